// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/run_options.h"

#include <iostream>

#include "colmap_ext/options/option_group.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/pipeline/shard.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

void AddPathOptions(const OptionGroups& groups, RunOptions* options, OptionParser* parser) {
  LayoutOptions& layout = options->layout;
  ViewOptions& view = options->view;
  parser->AddOption("workspace_path", &layout.workspace_path,
                    BasicOption("folder of the COLMAP project"));
  parser->AddOption("input_path", &layout.input_path,
                    BasicOption("sparse model instead of the one found"));
  parser->AddOption("image_path", &layout.image_path, BasicOption("images instead of those found"));
  parser->AddOption("output_path", &layout.output_path, BasicOption(groups.output_help));
  parser->AddOption("model_index", &layout.model_index,
                    "which of several models, -1 = the one with the most images");
  parser->AddOption("image_list_path", &view.image_list_path,
                    "file with the names of the images to use");
  parser->AddOption("skip_missing_images", &view.skip_missing_images,
                    "leave out registered images whose files are missing");
  parser->AddOption(
      "mask_path", &view.mask_path,
      BasicOption("folder of masks, such as <image name>.png, or one mask for all images"));
  parser->AddOption("edges_path", &options->edges_path,
                    "folder of edges found elsewhere, <image name>.edg, .cem, .txt or .png");
  parser->AddOption(
      "max_image_size", &view.max_image_size,
      BasicOption("shrink images to this longer side, panoramas to four times that, px, -1 = off"));
  parser->AddOption("max_reprojection_px", &view.max_reprojection_px,
                    "leave out images that points of the model miss by more than this, 0 = none");
  parser->AddOption(
      "quality", &options->quality,
      {{"low", Quality::kLow}, {"medium", Quality::kMedium}, {"high", Quality::kHigh}},
      BasicOption(
          "how fine to draw: low for a first look, high for finer detail; sets the defaults "
          "of other options"));
  if (groups.overwrites) {
    parser->AddOption(
        "overwrite", &options->overwrite,
        BasicOption("replace results made with other options, from other images or not by limn"));
  }
  if (groups.shards) {
    parser->AddOption(
        "shard", &options->shard,
        "i/n: only store the results of part i of n of the images, for a later run without");
    parser->AddOption(
        "shard_stage", &options->shard_stage,
        {{"curves", ShardStage::kCurves}, {"sketches", ShardStage::kSketches}},
        "where a shard ends; in a scene in tiles, sketches means the tiles' drawings");
  }
  parser->AddOption("num_threads", &options->num_threads,
                    BasicOption("processor cores to use, -1 = all"));
  parser->AddOption("log_level", &options->log_level,
                    "what is printed: 1 = a line per stage, 2 = what it kept and dropped, too");
}

void AddOptions(const OptionGroups& groups, RunOptions* options, OptionParser* parser) {
  AddPathOptions(groups, options, parser);
  PipelineOptions& pipeline = options->pipeline;
  if (groups.sketch) {
    parser->AddOption("box", &options->box,
                      BasicOption("reconstruct only inside x0,x1,y0,y1,z0,z1"));
  }
  if (groups.sketch || groups.drawing) {
    std::vector<std::pair<std::string, SketchMode>> modes;
    for (const SketchMode mode :
         {SketchMode::kOriginal, SketchMode::kEnhanced, SketchMode::kSweep}) {
      modes.push_back({SketchModeName(mode), mode});
    }
    parser->AddOption("mode", &pipeline.mode, modes, BasicOption("how the sketch is made"));
  }
  if (groups.sketch && groups.drawing) {
    parser->AddOption("refine_cameras", &pipeline.refine_cameras,
                      {{"auto", CameraRefinement::kAuto},
                       {"0", CameraRefinement::kOff},
                       {"1", CameraRefinement::kOn}},
                      BasicOption("refine the cameras by the curves, auto = if needed"));
    parser->AddOption("hold_images", &options->view.hold_images,
                      "file with the names of images whose cameras are not refined");
  }
  if (groups.output_cameras) {
    parser->AddOption(
        "output_cameras", &pipeline.output_cameras,
        {{"refined", OutputCameras::kRefined}, {"given", OutputCameras::kGiven}},
        "cameras that the drawing fits if they were refined; given: for dense results "
        "that were made with those");
  }
  AddGroup("EdgeDetection", &pipeline.edges, parser);
  AddGroup("EdgeMaps", &options->edge_maps, parser);
  if (groups.linking) AddGroup("Linking", &pipeline.linking, parser);
  if (groups.sketch) {
    AddGroup("ViewSelection", &pipeline.sketch.view_selection, parser);
    AddGroup("Sketch", &pipeline.sketch, parser);
  }
  if (groups.drawing) {
    std::vector<std::pair<std::string, DrawingMethod>> methods;
    for (const DrawingMethod method : {DrawingMethod::kTraced, DrawingMethod::kPaper}) {
      methods.push_back({DrawingMethodName(method), method});
    }
    parser->AddOption("Drawing.method", &pipeline.method, methods,
                      "how samples become links; paper: as in the paper, and nothing else");
    AddGroup("Drawing", &pipeline.drawing, parser);
    AddGroup("Paper", &pipeline.paper, parser);
  }
  // Edits and faces have gaps and gates in common with the drawing.
  if (groups.refit) AddGroup("Drawing", &pipeline.drawing.topology, parser);
  if (groups.refinement || groups.refit || groups.surfaces) {
    AddGroup("DrawingRefinement", &pipeline.refinement, parser);
  }
  if (groups.refinement) AddGroup("Belief", &pipeline.belief, parser);
  if (groups.refinement || groups.refit || groups.regularities) {
    AddGroup("Primitives", &pipeline.primitives, parser);
  }
  if (groups.refinement) {
    parser->AddOption("regularize", &pipeline.regularize,
                      "make directions, planes and circles regular where the images allow it");
  }
  if (groups.refinement || groups.regularities) {
    AddGroup("Regularity", &pipeline.regularity, parser);
  }
  if (groups.surfaces) AddGroup("Surfaces", &pipeline.surfaces, parser);
  if (groups.tiles) AddGroup("Tiles", &pipeline.tiles, parser);
  if (groups.dense) AddGroup("DenseFusion", &options->dense, parser);
}

}  // namespace

std::optional<Eigen::AlignedBox3d> BoxFromNumbers(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  if (numbers.size() != 6) {
    throw OptionError("box = " + std::to_string(numbers.size()) +
                      " numbers: must be six, x0,x1,y0,y1,z0,z1");
  }
  Eigen::AlignedBox3d box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min()[axis] = numbers[2 * axis];
    box.max()[axis] = numbers[2 * axis + 1];
    for (const double bound : {box.min()[axis], box.max()[axis]}) {
      CheckOption(bound >= -1e15 && bound <= 1e15, "box", bound, ">= -1e15 and <= 1e15");
    }
    CheckOption(box.min()[axis] < box.max()[axis], "box", box.max()[axis],
                "above the lower bound of its axis");
  }
  return box;
}

void RunOptions::Check() const {
  CheckValues();
  layout.Check();
}

void RunOptions::CheckValues() const {
  LIMN_CHECK_RANGE_OR(num_threads, -1, >= 1, <= 1e4);
  LIMN_CHECK_RANGE(log_level, >= 0, <= 2);
  pipeline.Check();
  view.Check();
  CheckGroup("EdgeMaps", edge_maps);
  CheckGroup("DenseFusion", dense);
  BoxFromNumbers(box);
  if (!shard.empty()) ParseShard(shard);
  if (!view.hold_images.empty() && pipeline.refine_cameras == CameraRefinement::kOff) {
    throw OptionError("hold_images = " + view.hold_images +
                      ": no camera is refined: needs refine_cameras = 1 or auto");
  }
}

void RunOptions::SetDerived() {
  view.border_margin_px = pipeline.edges.margin_px;
  // Edges from elsewhere are as fine as they are, and the paper's methods know pixels only.
  if (!edges_path.empty() || pipeline.IsPaper() || pipeline.mode != SketchMode::kSweep) {
    view.max_scale = 1;
  }
}

RunOptions DefaultRunOptions(Quality quality) {
  const QualityPreset preset = PresetOf(quality);
  RunOptions options;
  options.quality = quality;
  options.pipeline = preset.options;
  options.view.max_image_size = preset.max_image_size;
  options.view.max_scale = preset.max_scale;
  return options;
}

std::optional<OptionParser> ParseRunOptions(const std::string& command, const std::string& summary,
                                            const OptionGroups& groups, int argc,
                                            const char* const* argv, RunOptions* options,
                                            const std::function<void(OptionParser*)>& add_more) {
  *options = RunOptions();
  // First to learn the level of quality and the method, then to let single options override what
  // they set.
  for (const bool final_pass : {false, true}) {
    OptionParser parser(command, summary);
    AddOptions(groups, options, &parser);
    if (add_more) add_more(&parser);
    const OptionParser::Outcome outcome = parser.Parse(argc, argv);
    if (final_pass && outcome == OptionParser::Outcome::kHelp) {
      parser.WriteHelp(std::cout);
      return std::nullopt;
    }
    if (final_pass) {
      options->SetDerived();
      options->Check();
      return parser;
    }
    const DrawingMethod method = options->pipeline.method;
    *options = DefaultRunOptions(options->quality);
    if (!groups.linking && !groups.regularities) options->view.max_scale = 1;
    SetMethodDefaults(method, &options->pipeline);
  }
  return std::nullopt;
}

void SayRetired(const OptionParser& parser, Console* console) {
  const std::string note = parser.NoteOnRetired();
  if (!note.empty()) console->Say("NOTE: " + note);
}

}  // namespace limn::colmap_ext
