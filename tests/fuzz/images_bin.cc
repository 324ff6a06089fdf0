// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/model_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return limn::fuzz::FuzzImages(data, size, limn::colmap_ext::ReadImagesBinary);
}
