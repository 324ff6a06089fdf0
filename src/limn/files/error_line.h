// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace limn {

// Prints a PrintableLine to standard error. It is seen even while decoders are quiet (see
// QuietDecoders).
void PrintErrorLine(const std::string& line);

// Lines go to this file descriptor from now on.
void SendErrorLinesTo(int descriptor);

}  // namespace limn
