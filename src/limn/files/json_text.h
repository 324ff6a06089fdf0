// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limn/files/json_value.h"

namespace limn {

// Largest number of values (numbers, texts, lists, objects) that are read from a file: of short
// ones, and of large ones, such as drawings.
constexpr size_t kMaxJsonValues = size_t{1} << 25;
constexpr size_t kMaxLargeJsonValues = size_t{1} << 31;

// Gets the items of the lists of the root object, of which `list` is the name, when they have been
// read. Returns whether it has taken it: then null is in its place.
using TakeJsonItem = std::function<bool(const std::string& list, const JsonValue& item)>;

// Parses the JSON text of a file, keeping the order of members. Time n log n, mostly linear. What
// `take` takes needs memory only until then. Throws IoError if it is invalid, has two members of
// one name in an object, more than `max_values`, or is nested more than 100 deep (the JSON library
// writes and copies recursively); and InputError of `take`.
nlohmann::ordered_json ParseJson(const std::string& path, const std::string& text,
                                 size_t max_values = kMaxJsonValues, const TakeJsonItem& take = {});

// Call it in a handler of std::exception: rethrows InputErrors as IoError with the file's name.
// Other exceptions propagate.
[[noreturn]] void RethrowJsonError(const std::string& path);

}  // namespace limn
