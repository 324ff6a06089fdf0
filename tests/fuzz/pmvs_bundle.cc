// SPDX-License-Identifier: BSD-3-Clause
// The points of a PMVS folder.
#include "colmap_ext/workspace/pmvs_model.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/pmvs_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace limn;
  const std::filesystem::path& folder = fuzz::PmvsFolder();
  fuzz::WriteScratch("pmvs/bundle.rd.out", fuzz::Text(data, size));
  return fuzz::ExpectReadOrRefused([&] { colmap_ext::ReadPmvsModel(folder); });
}
