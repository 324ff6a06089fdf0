// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/cache/image_curves_file.h"
#include "limn/cache/stage_file.h"

// The bytes are the payload of a stage file that is whole.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string path = limn::fuzz::ScratchPath();
  limn::WriteStageFile(path, limn::StageKind::kImageCurves, "", limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused([&] { limn::ReadImageCurves(path, ""); });
}
