// SPDX-License-Identifier: BSD-3-Clause
// consumer <COLMAP workspace> <file with the names of images> <drawing.json to write>

#include <cstdio>
#include <exception>
#include <string>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/alignment/camera_hints.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/step/step_drawing_writer.h"
#include "limn/formats/write_drawing.h"
#include "limn/pipeline/pipeline.h"
#include "limn/version.h"

namespace {

void Draw(const char* workspace, const char* image_list, const char* output) {
  using namespace limn;
  using namespace limn::colmap_ext;
  const WorkspaceLayout layout = ResolveLayout({.workspace_path = workspace});
  const SparseModel model = ReadColmapModel(layout.model_dir);
  const ViewSet set =
      ToViews(model, layout.image_dir, {.image_list_path = image_list, .max_image_size = 320});

  ResultCache no_cache("");
  const ImageSource images{.read = [&](ViewId view) { return ReadViewImage(set, view); },
                           .identity = [&](ViewId view) { return set.files[view].image_path; }};
  const PipelineInput input{set.views, set.hints, images, {}, &no_cache};
  const PipelineResult result =
      DrawScene(input, PresetOf(Quality::kLow).options, {}, [](const StageSummary&) {});
  DrawingMetadata metadata;
  for (const View& view : set.views) metadata.view_names.push_back(view.name);
  metadata.main_view_direction = MainViewDirection(set.views);
  WriteDrawing(output, result.graph, metadata);
#ifdef WITH_STEP
  WriteDrawing(std::string(output) + ".step", result.graph, metadata,
               {.write_step = &WriteDrawingStep});
#endif
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  try {
    Draw(argv[1], argv[2], argv[3]);
    const limn::DrawingFile drawing = limn::ReadDrawingJson(argv[3]);
    std::printf("limn %s: %zu links in %zu images\n", LIMN_VERSION, drawing.graph.links.size(),
                drawing.metadata.view_names.size());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ERROR: %s\n", error.what());
    return 1;
  }
}
