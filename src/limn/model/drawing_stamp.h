// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace limn {

// Which state of which drawing something was made from.
struct DrawingStamp {
  // Of the file in its folder; empty if it was elsewhere.
  std::string name;
  // Of the bytes of the file, 16 hexadecimal digits; empty if it is not known.
  std::string fingerprint;
};

}  // namespace limn
