// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/limap_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return limn::fuzz::FuzzLimap(data, size, "lines3D.txt");
}
