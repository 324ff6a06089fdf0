// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace limn {

// What became of options of earlier versions, so that their project.ini files and scripts do not
// surprise: data only, never changed once released.

// Fixed since at the value that was its default.
struct RetiredOption {
  const char* name;
  const char* value;
};

std::span<const RetiredOption> RetiredOptions();

// Of the option of this name, if it is retired.
std::optional<std::string> FixedValue(std::string_view name);

// The present name of an option that was renamed; else nothing.
std::optional<std::string> NewName(std::string_view name);

// All former names of the options that were renamed.
std::span<const char* const> FormerNames();

// Whether the option of this name once had this word as a value.
bool IsRetiredWord(std::string_view name, std::string_view word);

// Whether two texts of values mean the same: "1", "1.0" and "1e0" do.
bool AreSameValue(const std::string& a, const std::string& b);

}  // namespace limn
