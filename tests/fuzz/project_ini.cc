// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/ini_file.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return limn::fuzz::FuzzStream(
      data, size, [](std::istream& in, const std::string& path) { limn::ReadIniFile(in, path); });
}
