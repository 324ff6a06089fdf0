// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/sketched_scene.h"
#include "limn/cache/curve_sketch_file.h"
#include "limn/cache/stage_file.h"

// The bytes are the payload of a stage file that is whole.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string path = limn::fuzz::ScratchPath();
  limn::WriteStageFile(path, limn::StageKind::kCurveSketch, "", limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused([&] {
    const auto stored = limn::ReadCurveSketch(path, limn::fuzz::SketchedCurves(), "");
    limn::fuzz::DrawAndAccount(stored->sketch, 0, {});
  });
}
