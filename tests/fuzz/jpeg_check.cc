// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/jpeg_check.h"

#include "colmap_ext/workspace/image_header.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"

// The codes of small pictures: the time and memory that a size needs are checked before.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace limn;
  const fuzz::MemoryFile file(fuzz::Text(data, size));
  const auto pixels = colmap_ext::ReadSizeFromHeader(file.path());
  if (!pixels || pixels->NumPixels() > 100'000) return 0;
  return fuzz::ExpectReadOrRefused([&] { colmap_ext::CheckJpeg(file.path()); });
}
