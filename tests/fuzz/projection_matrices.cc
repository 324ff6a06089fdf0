// SPDX-License-Identifier: BSD-3-Clause
// One of the two matrices of a folder.
#include "colmap_ext/import/projection_matrices.h"

#include "fuzz/fuzz_file.h"
#include "fuzz/import_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace limn;
  static const std::string other =
      fuzz::WriteScratch("matrices/2.txt", "CONTOUR\n50 0 20 1\n0 50 15 2\n0 0 1 3\n");
  fuzz::WriteScratch("matrices/1.txt", fuzz::Text(data, size));
  const std::string folder = (fuzz::ScratchFolder() / "matrices").string();
  colmap_ext::HoldsProjectionMatrices(folder);
  return fuzz::FuzzImport(folder, colmap_ext::ReadProjectionMatrices);
}
