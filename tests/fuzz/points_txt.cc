// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/formats/text_curves_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const limn::fuzz::MemoryFile file(limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused([&] { limn::ReadTextPoints(file.path()); });
}
