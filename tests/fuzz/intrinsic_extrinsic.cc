// SPDX-License-Identifier: BSD-3-Clause
// calib.intrinsic before the first '|', the extrinsics of both images after it.
#include "colmap_ext/import/intrinsic_extrinsic.h"

#include <algorithm>

#include "fuzz/fuzz_file.h"
#include "fuzz/import_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace limn;
  const std::string_view text = fuzz::Text(data, size);
  const size_t bar = std::min(text.find('|'), text.size());
  const std::string_view extrinsic = text.substr(std::min(bar + 1, text.size()));
  fuzz::WriteScratch("frames/calib.intrinsic", text.substr(0, bar));
  fuzz::WriteScratch("frames/1.extrinsic", extrinsic);
  fuzz::WriteScratch("frames/2.extrinsic", extrinsic);
  return fuzz::FuzzImport((fuzz::ScratchFolder() / "frames").string(),
                          colmap_ext::ReadIntrinsicExtrinsic);
}
