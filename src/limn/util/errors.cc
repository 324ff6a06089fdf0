// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/errors.h"

#include <limits>
#include <sstream>

namespace limn {

IoError::IoError(const std::string& path, const std::string& reason)
    : std::runtime_error(path + ": " + reason) {}

IoError::IoError(const std::string& path, const std::string& place, const std::string& reason)
    : std::runtime_error(path + ": " + place + ": " + reason) {}

void FilePlace::Fail(const std::string& reason) const {
  throw IoError(path, std::string(unit) + " " + std::to_string(number), reason);
}

void CheckOption(bool ok, const char* name, double value, const char* constraint) {
  if (ok) return;
  std::ostringstream message;
  message.precision(std::numeric_limits<int>::digits10);
  message << name << " = " << value << ": must be " << constraint;
  throw OptionError(message.str());
}

}  // namespace limn
