// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/formats/image_polylines_reader.h"
#include "limn/linking/given_curves.h"

// What is accepted must become fragments.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const limn::fuzz::MemoryFile file(limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused([&] {
    limn::ImageCurves curves =
        limn::CurvesOfPolylines(limn::ReadImagePolylines(file.path(), 64, 48), 64, 48);
    limn::MakeConsistent(&curves);
  });
}
