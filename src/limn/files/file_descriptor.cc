// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/file_descriptor.h"

#include <unistd.h>

namespace limn {

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) close(number_);
}

}  // namespace limn
