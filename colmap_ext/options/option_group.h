// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "colmap_ext/options/option_parser.h"
#include "limn/util/option_fields.h"

namespace limn {

// The fields of a struct of options (util/option_fields.h), as --<group>.<field>.
template <typename Options>
void AddGroup(const std::string& group, Options* options, OptionParser* parser) {
  Options::VisitFields(*options, [&](const std::string& name, auto& field,
                                     const OptionValues& values, const OptionHelp& help) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_enum_v<Field>) {
      std::vector<std::pair<std::string, Field>> words;
      for (const char* word : values.words) {
        words.push_back({word, static_cast<Field>(words.size())});
      }
      parser->AddOption(group + "." + name, &field, words, help);
    } else {
      parser->AddOption(group + "." + name, &field, help);
    }
  });
}

}  // namespace limn
