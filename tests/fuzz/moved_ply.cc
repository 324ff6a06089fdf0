// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>

#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/formats/ply_mover.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const limn::fuzz::MemoryFile file(limn::fuzz::Text(data, size));
  const limn::Similarity3d similarity = {2, Eigen::Matrix3d::Identity(), {1, 2, 3}};
  return limn::fuzz::ExpectReadOrRefused([&] {
    std::ostringstream out;
    limn::MovePly(file.path(), similarity, "offset 1 2 3", out);
  });
}
