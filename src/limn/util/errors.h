// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace limn {

// A file cannot be read or written. The text names the path, the place in it (byte offset or line)
// and the reason.
class IoError : public std::runtime_error {
 public:
  IoError(const std::string& path, const std::string& reason);
  IoError(const std::string& path, const std::string& place, const std::string& reason);
};

// Where in a file something was found, for messages.
struct FilePlace {
  const std::string& path;
  const char* unit;  // "byte" or "line"
  uint64_t number;

  // Throws IoError "<path>: <unit> <number>: <reason>".
  [[noreturn]] void Fail(const std::string& reason) const;
};

// An option or argument is outside its allowed range. The text names option, value and constraint.
class OptionError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

// Input is well-formed but unusable, e.g. all cameras have the same center.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The work was cancelled through RunContext::cancelled.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

// Throws OptionError "<name> = <value>: must be <constraint>" unless `ok`.
void CheckOption(bool ok, const char* name, double value, const char* constraint);

}  // namespace limn

// For use inside `void XOptions::Check() const`. Every number has a range with two ends, and may
// also depend on other options:
//
//   LIMN_CHECK_RANGE(max_gap_px, >= 0, <= 1000);
//   LIMN_CHECK_RANGE_OR(num_threads, -1, >= 1, <= 1e4);     -1 or in the range
//   LIMN_CHECK_OPTION(max_views, >= min_views);
#define LIMN_CHECK_OPTION(field, constraint) \
  ::limn::CheckOption(((field)constraint), #field, static_cast<double>(field), #constraint)
#define LIMN_CHECK_RANGE(field, low, high)                                               \
  ::limn::CheckOption(((field)low) && ((field)high), #field, static_cast<double>(field), \
                      #low " and " #high)
#define LIMN_CHECK_RANGE_OR(field, special, low, high)                                 \
  ::limn::CheckOption((field) == (special) || (((field)low) && ((field)high)), #field, \
                      static_cast<double>(field), #special " or " #low " and " #high)
