// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/sketched_scene.h"
#include "limn/cache/stage_file.h"
#include "limn/cache/view_sketch_file.h"

// The bytes are the payload of a stage file that is whole.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string path = limn::fuzz::ScratchPath();
  limn::WriteStageFile(path, limn::StageKind::kViewSketch, "", limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused([&] {
    auto sketch = limn::ReadViewSketch(path, 0, {0, 1}, limn::fuzz::SketchedViews(),
                                       limn::fuzz::SketchedCurves(), "");
    limn::fuzz::DrawAndAccount({std::move(sketch->curves)}, 0, sketch->fates);
  });
}
