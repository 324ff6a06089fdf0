// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/fuse.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "colmap_ext/dense_files/merged_cloud.h"
#include "colmap_ext/dense_files/pmvs_with_curves.h"
#include "colmap_ext/dense_files/sparse_with_curves.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/verbs/depth_warnings.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/files/atomic_file.h"
#include "limn/files/json_text.h"
#include "limn/formats/write_drawing.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Where the file system has links: they are replaced, never followed.
constexpr const char* kMadeAsLinks[] = {"with-curves/fused.ply", "with-curves/fused.ply.vis"};

// Views and curve points in the coordinates of the model.
struct InModel {
  std::vector<View> views;
  std::vector<CurvePoint> points;
};

InModel ToModel(const Project& project, const std::vector<CurvePoint>& points) {
  InModel moved = {Moved(project.views(), project.origin()), points};
  for (CurvePoint& point : moved.points) point.position += project.origin();
  return moved;
}

void WriteSparseWithCurves(const Project& project, int every, const InModel& curves,
                           Console* console) {
  const OutputPath folder = project.DrawingPath("sparse-with-curves");
  SparseModel model = project.ReadModel();
  const size_t before = model.points.size();
  model = AddCurvePoints(std::move(model), curves.points, curves.views, every);
  WriteModelBinary(model, folder);
  console->Say("wrote " + folder.string() + ": " + std::to_string(model.points.size() - before) +
               " points of curves beside " + std::to_string(before) + " of the model");
}

void WriteMeshing(const Project& project, const DenseInput& dense, const InModel& curves,
                  Console* console) {
  const OutputPath folder = project.DrawingPath("with-curves");
  const std::vector<CloudPoint> extra = PointsForMeshing(curves.points);
  if (!project.origin().isZero()) {
    const auto far = static_cast<float>(project.origin().cwiseAbs().maxCoeff());
    console->Say("WARNING: " + folder.string() +
                 " is in single precision, as COLMAP's meshers read it: so far from the origin "
                 "positions have steps of " +
                 ShortNumber(std::nextafter(far, 2 * far) - far));
  }
  WriteMeshingFolder(folder, dense.for_meshers, project.layout().model_dir, extra, curves.views);
  console->Say("wrote " + folder.string() + ": " + std::to_string(dense.cloud->num_points) +
               " dense points and " + std::to_string(extra.size()) + " of curves; to mesh them:");
  console->Say("  colmap poisson_mesher --input_path " + (folder / "fused.ply").string() +
               " --output_path " + (folder / "meshed-poisson.ply").string());
  if (dense.cloud->has_visibility) {
    console->Say("  colmap delaunay_mesher --input_path " + folder.string() + " --output_path " +
                 (folder / "meshed-delaunay.ply").string());
  }
}

// The length of the drawing by class, and what it adds to the dense results.
void SayLengths(const FusionResult& result, const DenseOptions& options, Console* console) {
  double whole = 0;
  for (const double length : result.samples.length) whole += length;
  const auto length_of = [&](DenseClass wanted) {
    return LengthOf(wanted, result.samples, result.classes);
  };
  console->Say("length: " + ShortNumber(whole) + " in the model's unit; on a surface " +
               ShortNumber(length_of(DenseClass::kSurface)) + ", at a boundary " +
               ShortNumber(length_of(DenseClass::kBoundary)) + ", off the surface " +
               ShortNumber(length_of(DenseClass::kFree)) + ", not judged " +
               ShortNumber(length_of(DenseClass::kUnknown)) + ", behind the surface " +
               ShortNumber(LengthBehind(result.samples, result.classes)));
  if (!result.trust.is_believed) return;
  console->Say("the drawing adds " + ShortNumber(LengthAdded(result.samples, result.classes)) +
               " that have no dense point within " + ShortNumber(options.near_px) + " footprints");
}

}  // namespace

void FuseVerb::AddOptions(OptionParser* parser) {
  parser->AddOption("dense_type", &paths_.dense_type,
                    {"auto", "depth_maps", "fused", "pmvs", "mesh"},
                    BasicOption("which dense results"));
  parser->AddOption("dense_path", &paths_.dense_path,
                    BasicOption("their file or folder, instead of those found beside the model"));
  parser->AddOption("remove_occluded", &remove_occluded_,
                    BasicOption("leave out links behind the surface, instead of marking them"));
}

void FuseVerb::AddFileOptions(OptionParser* parser) {
  AddDrawingPath("drawing.json to fuse, instead of the one in the output folder", parser);
  parser->AddOption("sparse_spacing_px", &sparse_spacing_px_,
                    "distance of the curves' points in sparse-with-curves, px");
}

void FuseVerb::Prepare(RunOptions*, Console*) {
  paths_.Check();
  CheckOption(sparse_spacing_px_ >= 1 && sparse_spacing_px_ <= 1e4, "sparse_spacing_px",
              sparse_spacing_px_, ">= 1 and <= 1e4");
}

std::string FuseVerb::Provenance(const RunOptions& options, const std::string& before) const {
  Json json = ParseJson("options of the drawing", before);
  Json& dense = json["DenseFusion"] = Json::parse(OptionsAsJson(options.dense));
  dense["dense_type"] = paths_.dense_type;
  dense["remove_occluded"] = remove_occluded_;
  dense["sparse_spacing_px"] = sparse_spacing_px_;
  return json.dump();
}

DrawingInScene FuseVerb::Apply(const Job& job, const DrawingInScene& given) {
  if (job.scene.layout().model_dir.empty()) {
    throw InputError("fuse: dense results belong to a project, not to a scene in memory");
  }
  dense_ = OpenDenseInput(job.scene, paths_, job.options.layout.workspace_path, job.console);
  FusionResult result = FuseDrawing(
      {given.views, given.graph, dense_.depths, dense_.products.kind == DenseKind::kDepthMaps,
       dense_.cloud ? std::optional(dense_.points) : std::nullopt},
      job.options.dense, job.context());
  job.console->Report(result.summary);
  if (const std::string note = dense_.cloud ? dense_.cloud->NoteOnOdd() : ""; !note.empty()) {
    job.console->Say("WARNING: " + dense_.products.clouds.front().string() + ": " + note);
  }
  const std::string warning = DepthWarning(result.trust, dense_.products, given.views);
  if (!warning.empty()) job.console->Say("WARNING: " + warning);
  SayLengths(result, job.options.dense, job.console);
  points_ = std::move(result.points);
  return {remove_occluded_ ? WithoutOccluded(result.graph) : std::move(result.graph),
          given.metadata, given.views, given.curves};
}

void FuseVerb::CheckFiles(const Project& project, const RunOptions& options) const {
  for (const char* name : {"drawing-fused.ply", "drawing-fused.obj"}) {
    CheckResultFile(project.DrawingPath(name), options.overwrite);
  }
  const bool may_replace =
      options.overwrite || fs::exists(project.DrawingPath(kFusedDrawing).string());
  std::vector<std::string> names = {"pmvs-with-curves.patch", "pmvs-with-curves.ply",
                                    "with-curves/fused-with-curves.ply",
                                    "with-curves/fused-with-curves.ply.vis"};
  names.insert(names.end(), std::begin(kMadeAsLinks), std::end(kMadeAsLinks));
  for (const ModelFile& file : kBinaryModelFiles) {
    names.push_back(std::string("sparse-with-curves/") + file.name);
  }
  for (const std::string& name : names) {
    const OutputPath path = project.DrawingPath(name);
    const bool is_link = fs::is_symlink(fs::symlink_status(path.string()));
    if (!is_link || !std::ranges::count(kMadeAsLinks, name)) CheckTakesFile(path);
    if (may_replace || !fs::exists(path.string())) continue;
    throw IoError(path.string(), "exists, and there is no " + std::string(kFusedDrawing) +
                                     " that it belongs to: --overwrite 1 replaces it");
  }
  const fs::path model = project.DrawingPath("with-curves/sparse").string();
  if (fs::is_directory(fs::symlink_status(model))) {
    throw IoError(model.string(), "is a folder, not the link that is to be made: remove it");
  }
}

void FuseVerb::CheckReplaces(const Project& project, const RunOptions& options,
                             const std::string& provenance) const {
  CheckReplaceable(project, options, kFusedDrawing, provenance);
}

void FuseVerb::Write(const Job& job, const Project& project, const DrawingInScene& made) {
  ColorCurvePoints(project, job.context(), &points_);
  const DrawingGraph graph = Moved(made.graph, project.origin());
  // The one that says whose the others are is first.
  for (const char* name : {kFusedDrawing, "drawing-fused.ply", "drawing-fused.obj"}) {
    WriteDrawing(project.DrawingPath(name), graph, made.metadata);
  }
  const InModel curves = ToModel(project, points_);
  job.console->Say("wrote " + project.DrawingPath("drawing-fused.{ply,json,obj}").string());
  const double spacing = sparse_spacing_px_ / job.options.dense.sample_spacing_px;
  WriteSparseWithCurves(project, std::max(1, static_cast<int>(std::lround(spacing))), curves,
                        job.console);
  if (dense_.products.kind == DenseKind::kPmvs) {
    const OutputPath base = project.DrawingPath("pmvs-with-curves");
    WritePmvsWithCurves(base, dense_.products.clouds, *dense_.cloud, curves.points, curves.views);
    job.console->Say("wrote " + base.string() + ".{patch,ply}");
  }
  if (!dense_.for_meshers.empty()) WriteMeshing(project, dense_, curves, job.console);
}

void ColorCurvePoints(const Scene& scene, const RunContext& context,
                      std::vector<CurvePoint>* points) {
  std::vector<std::vector<size_t>> of_view(scene.views().size());
  for (size_t p = 0; p < points->size(); ++p) of_view[(*points)[p].views.front()].push_back(p);
  ParallelFor(context, "reading colors", of_view.size(), [&](size_t v) {
    if (of_view[v].empty()) return;
    const View& view = scene.views()[v];
    const Image image = ReadViewImage(scene.view_set(), static_cast<ViewId>(v));
    for (const size_t p : of_view[v]) {
      CurvePoint& point = (*points)[p];
      const auto pixel = view.Project(point.position);
      const auto stored = pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
      if (!stored) continue;
      const Eigen::Vector3f color =
          ColorAt(image, image.FromView(*stored)).cwiseMax(0.F).cwiseMin(255.F);
      for (int c = 0; c < 3; ++c) point.color[c] = static_cast<uint8_t>(std::lround(color[c]));
    }
  });
}

}  // namespace limn::colmap_ext
