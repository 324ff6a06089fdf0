// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/span_value.h"

namespace limn {

std::optional<SpanValue> ParseSpanValue(const std::string& text) {
  const size_t equals = text.rfind('=');
  if (text.size() > kMaxSpanValueBytes || equals == std::string::npos) return std::nullopt;
  const auto span = ParseSpan(text.substr(0, equals));
  if (!span) return std::nullopt;
  return SpanValue{*span, text.substr(equals + 1)};
}

}  // namespace limn
