// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/pmvs_folder.h"

#include "fuzz/fuzz_file.h"

namespace limn::fuzz {
namespace {

std::filesystem::path MakeFolder() {
  for (const std::string number : {"00000000", "00000001", "00000002"}) {
    WriteScratch("pmvs/txt/" + number + ".txt", "CONTOUR\n50 0 20 1\n0 50 15 2\n0 0 1 3\n");
    WriteScratch("pmvs/visualize/" + number + ".jpg", EmptyImage());
  }
  return ScratchFolder() / "pmvs";
}

}  // namespace

const std::filesystem::path& PmvsFolder() {
  static const std::filesystem::path folder = MakeFolder();
  return folder;
}

}  // namespace limn::fuzz
