// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/patch_file.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const limn::fuzz::MemoryFile file(limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused(
      [&] { limn::colmap_ext::ReadPatchFile(file.path(), [](const auto&) {}); });
}
