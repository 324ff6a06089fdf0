// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/formats/text_curves_reader.h"

// The file of edges that goes with a file of points.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const limn::fuzz::MemoryFile points("0 0 0\n1 0 0\n1 1 0\n0 0 0\n0 1 0\n");
  const limn::fuzz::MemoryFile edges(limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused(
      [&] { limn::ReadIndexedCurves(points.path(), edges.path()); });
}
