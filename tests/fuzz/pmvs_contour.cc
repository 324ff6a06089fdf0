// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/pmvs_model.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return limn::fuzz::FuzzStream(data, size, [](std::istream& in, const std::string& path) {
    limn::colmap_ext::Decompose(limn::colmap_ext::ReadContour(in, path));
  });
}
