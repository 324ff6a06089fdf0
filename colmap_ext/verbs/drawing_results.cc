// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/drawing_results.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <system_error>

#include <nlohmann/json.hpp>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/options/retired_options.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/refined_cameras.h"
#include "colmap_ext/verbs/selection_options.h"
#include "colmap_ext/workspace/output_check.h"
#include "colmap_ext/workspace/refined_folder.h"
#include "limn/cache/curves_key.h"
#include "limn/evaluation/edgel_account.h"
#include "limn/files/atomic_file.h"
#include "limn/files/json_text.h"
#include "limn/formats/write_drawing.h"
#include "limn/pictures/overlays.h"
#include "limn/primitives/fit_primitives.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using Json = nlohmann::ordered_json;

// A picture per photograph; one photograph per thread is in memory. Those of other views than
// `only` are kept if they are there.
void WritePictures(const Project& project, const std::string& folder, const ViewSubset& only,
                   const RunContext& context, const std::function<Picture(ViewId)>& draw) {
  const auto path_of = [&](ViewId view) {
    return PicturePath(project.CurvesPath(folder), project.views()[view].name);
  };
  std::vector<ViewId> views = IdsOf({}, project.views().size());
  if (only) {
    std::erase_if(views, [&](ViewId view) {
      return !std::ranges::binary_search(*only, view) &&
             std::filesystem::exists(path_of(view).string());
    });
  }
  ParallelFor(context, folder.c_str(), views.size(),
              [&](size_t i) { WritePng(path_of(views[i]), draw(views[i])); });
  ReleaseDecoded(project.view_set());
}

LinkSelection WithDetail(LinkSelection selection, Detail detail) {
  selection.Set(detail);
  return selection;
}

// Share of the length by primitive, how far they are, and how much shorter they tell the drawing.
void SayPrimitives(const DrawingGraph& graph, Console* console) {
  const PrimitiveStatistics primitives = Describe(graph);
  double whole = 0;
  for (const auto& kind : primitives.kinds) whole += kind.length;
  if (primitives.numbers_after == 0) return;  // none yet
  std::string line = "primitives, shares of the length:";
  char text[120];
  for (const auto& kind : primitives.kinds) {
    std::snprintf(text, sizeof(text), " %s %.1f %%,", kind.name, 100 * kind.length / whole);
    line += text;
  }
  std::snprintf(text, sizeof(text), " %.2f px from the links (at most %.2f), %zu numbers for %zu",
                primitives.rms_px, primitives.max_px, primitives.numbers_after,
                primitives.numbers_before);
  console->Say(line + text);
}

// Each must take a file, and none may be a folder of another, as that of `a` for that of `a.png/b`.
void CheckPicturePaths(const Project& project, bool overwrite) {
  std::set<std::string> names;
  for (const View& view : project.views()) names.insert(PicturePath("", view.name).string());
  for (const View& view : project.views()) {
    for (const char* folder : {"overlays", "account"}) {
      CheckResultFile(PicturePath(project.CurvesPath(folder), view.name), overwrite);
    }
    for (std::filesystem::path above = view.name; above.has_parent_path();) {
      above = above.parent_path();
      if (!names.contains(above.string())) continue;
      throw InputError("image \"" + view.name +
                       "\": the folder of its overlay would have the name "
                       "of the overlay of another image: rename one of them");
    }
  }
}

// A group of options; null if it is not there or has none.
Json* GroupOf(const std::string& name, Json* options) {
  const auto group = options->find(name.substr(0, name.find('.')));
  return group != options->end() && group->is_object() ? &*group : nullptr;
}

// Options of a drawing of any version by their present names, without those that are fixed now at
// these values and those of another method.
Json PresentOptions(Json options) {
  const auto take = [&](const std::string& name, const auto& is_wanted) -> std::optional<Json> {
    Json* group = GroupOf(name, &options);
    if (!group) return std::nullopt;
    const auto found = group->find(name.substr(name.find('.') + 1));
    if (found == group->end() || !is_wanted(*found)) return std::nullopt;
    Json value = *found;
    group->erase(found);
    return value;
  };
  for (const RetiredOption& retired : RetiredOptions()) {
    take(retired.name,
         [&](const Json& value) { return AreSameValue(value.dump(), retired.value); });
  }
  const Json* drawing = GroupOf("Drawing.", &options);
  const bool is_paper = drawing && drawing->contains("method") && drawing->at("method") == "paper";
  for (const std::string former : FormerNames()) {
    const std::string name = *NewName(former);
    const auto value = take(former, [](const Json&) { return true; });
    if (value && is_paper) {
      Json& group = options[name.substr(0, name.find('.'))];
      if (!group.is_object()) group = Json::object();
      group[name.substr(name.find('.') + 1)] = *value;
    }
  }
  return options;
}

// Refined cameras have other last bits when their file is read again: they go by its name.
std::string SketchKey(const std::string& refined_cameras, const std::vector<View>& views,
                      const std::vector<ImageCurves>& curves, const RunContext& context) {
  if (refined_cameras.empty()) return CurvesKey(views, curves, context);
  return refined_cameras + " " + StoredCurvesKey(curves);
}

}  // namespace

void CheckReplaceable(const Project& project, const RunOptions& options, const std::string& name,
                      const std::string& provenance) {
  CheckTakesFile(project.DrawingPath(name));
  const std::string path = project.DrawingPath(name).string();
  std::error_code ignored;
  if (options.overwrite || !std::filesystem::exists(path, ignored)) return;
  const auto refuse = [&](const std::string& what) {
    throw IoError(path, what + ": --overwrite 1 replaces it, --output_path writes elsewhere");
  };
  DrawingMetadata metadata;
  try {
    metadata = ReadDrawingJson(path).metadata;
  } catch (const IoError&) {
    refuse("exists, and is not a drawing of this version of limn");
  }
  if (!options.update && metadata.view_names != ViewNames(project)) {
    refuse("is a drawing of other images");
  }
  const Json old_options =
      PresentOptions(ParseJson("options of the drawing", metadata.options_json));
  const Json new_options = Json::parse(provenance);
  // Whatever the order of keys.
  const Json difference = Json::diff(old_options, new_options);
  if (!difference.empty()) {
    refuse("was drawn with other options (" + difference.front().value("path", "") + ")");
  }
}

void CheckDrawingFiles(const Project& project, const RunOptions& options) {
  CheckTakesFile(project.DrawingPath("drawing.json"));
  for (const char* name : {"drawing.ply", "drawing.obj", "drawing.html"}) {
    CheckResultFile(project.DrawingPath(name), options.overwrite);
  }
  for (const char* name : {"tracks.txt", "account.csv", "project.ini"}) {
    CheckResultFile(project.CurvesPath(name), options.overwrite);
  }
  CheckPicturePaths(project, options.overwrite);
}

void CheckSketchFiles(const Project& project, const RunOptions& options) {
  for (const char* extension : {".bin", ".ply"}) {
    CheckResultFile(project.CurvesPath(SketchFileName(options.pipeline.mode) + extension),
                    options.overwrite);
  }
}

void CheckRunOutputs(const Project& project, const RunOptions& options) {
  CheckRefinedFolder(project, options);
  CheckDrawingFiles(project, options);
  CheckSketchFiles(project, options);
  CheckReplaceable(project, options, "drawing.json", Provenance(options));
}

std::string SketchFileName(SketchMode mode) {
  switch (mode) {
    case SketchMode::kOriginal:
      return "sketch";
    case SketchMode::kEnhanced:
      return "enhanced-sketch";
    case SketchMode::kSweep:
      return "swept-sketch";
  }
  return "";
}

void CheckGraph(const DrawingGraph& graph) {
  const std::vector<std::string> broken = Validate(graph);
  if (broken.empty()) return;
  throw InputError("the drawing is not written, it breaks " + std::to_string(broken.size()) +
                   " invariants; the first: " + broken.front());
}

void WriteSketchResults(const Project& project, const std::string& name,
                        const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                        const CurveSketch& sketch, const DrawingMetadata& metadata,
                        const RunContext& context) {
  WriteCurveSketch(project.CurvesPath(name + ".bin"), sketch, metadata,
                   SketchKey(metadata.refined_cameras, views, curves, context));
  WriteSketch(project.CurvesPath(name + ".ply"), Moved(sketch, project.origin()));
}

StoredCurveSketch ReadSketchResult(const Project& project, const std::string& name,
                                   const std::vector<ImageCurves>& curves,
                                   const RunContext& context) {
  const std::string path = project.CurvesPath(name + ".bin").string();
  const std::string cameras = RefinedCamerasOf(path);
  const bool has_cameras =
      cameras.empty() || NameOfRefinedCameras(project.layout().model_dir) == cameras;
  auto stored = has_cameras ? ReadCurveSketch(path, curves,
                                              SketchKey(cameras, project.views(), curves, context))
                            : std::nullopt;
  if (!stored) {
    throw IoError(path,
                  "was made from other images, cameras or options of edges and linking, or "
                  "by another version of limn: run curve_sketcher again");
  }
  return std::move(*stored);
}

void SayDroppedFaces(const DrawingGraph& before, const DrawingGraph& after, Console* console) {
  if (after.faces.size() >= before.faces.size()) return;
  console->Say("WARNING: links have moved: of " + std::to_string(before.faces.size()) +
               " faces between them there are " + std::to_string(after.faces.size()) +
               " left; run drawing_surfacer again");
}

void ResultOptions::AddOptions(OptionParser* parser) {
  AddDetailOption("drawing.ply, drawing.obj, tracks and overlays have", &detail, parser);
  parser->AddOption("overlay_markers", &overlay_markers, "mark nodes in overlays");
}

void WriteDrawingResults(const Project& project, const DrawingInScene& drawing,
                         const ResultOptions& options, Console* console,
                         const ViewSubset& pictures) {
  const DrawingGraph in_model = Moved(drawing.graph, project.origin());
  WriteDrawing(project.DrawingPath("drawing.json"), in_model, drawing.metadata);
  WarnOfUnknownCurves(in_model, options.detail, console);
  const DrawingGraph selected = Selected(in_model, WithDetail({}, options.detail));
  for (const char* name : {"drawing.ply", "drawing.obj"}) {
    WriteDrawing(project.DrawingPath(name), selected, drawing.metadata);
  }
  WriteTracks(project.CurvesPath("tracks.txt"), drawing.graph,
              WithDetail(LinkSelection::AsSeen(), options.detail),
              InStoredImages(project.view_set(), drawing.views));
  PictureOptions look;
  look.detail = options.detail;
  if (!options.overlay_markers) look.node_radius_px = 0;
  WritePictures(project, "overlays", pictures, console->context(), [&](ViewId v) {
    return DrawOverlay(project.images().read(v), drawing.views[v], v, drawing.graph, look);
  });
  SayPrimitives(drawing.graph, console);
  console->Say("Written: " + project.DrawingPath("drawing.{ply,json,obj}").string() + ", " +
               project.CurvesPath("tracks.txt").string() + ", " +
               project.CurvesPath("overlays").string());
}

void WriteAccount(const Project& project, const AccountInput& input, Console* console) {
  const EdgelFates fates = AccountEdgels(input, console->context());
  WriteFileAtomically(project.CurvesPath("account.csv"),
                      [&](std::ostream& out) { WriteAccountCsv(project.views(), fates, out); });
  WritePictures(project, "account", std::nullopt, console->context(), [&](ViewId v) {
    return DrawAccount(project.images().read(v), input.scene.curves[v], fates[v]);
  });
  console->Say("Written: " + project.CurvesPath("account.csv").string() + ", " +
               project.CurvesPath("account").string());
}

}  // namespace limn::colmap_ext
