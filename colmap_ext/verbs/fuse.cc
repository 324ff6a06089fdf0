#include "colmap_ext/verbs/fuse.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "colmap_ext/dense_files/depth_sources.h"
#include "colmap_ext/dense_files/merged_cloud.h"
#include "colmap_ext/dense_files/pmvs_with_curves.h"
#include "colmap_ext/dense_files/sparse_with_curves.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/output_check.h"
#include "colmap_ext/workspace/pmvs_model.h"
#include "limn/files/atomic_file.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/write_drawing.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Files hold the coordinates of the model that was read.
DensePointStream MovedStream(const DensePointStream& points, const Eigen::Vector3d& shift) {
  return [=](const DensePointVisitor& visit) {
    points([&](const DensePoint& point) {
      DensePoint moved = point;
      moved.position += shift;
      visit(moved);
    });
  };
}

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
  const fs::path folder = project.DrawingPath("sparse-with-curves");
  SparseModel model = project.ReadModel();
  const size_t before = model.points.size();
  model = AddCurvePoints(std::move(model), curves.points, curves.views, every);
  WriteModelBinary(model, folder);
  console->Say("wrote " + folder.string() + ": " + std::to_string(model.points.size() - before) +
               " points of curves beside " + std::to_string(before) + " of the model");
}

void WriteMeshing(const Project& project, const DenseInput& dense, const InModel& curves,
                  Console* console) {
  const fs::path folder = project.DrawingPath("with-curves");
  const std::vector<CloudPoint> extra = PointsForMeshing(curves.points);
  if (!project.origin().isZero()) {
    const auto far = static_cast<float>(project.origin().cwiseAbs().maxCoeff());
    console->Say("WARNING: " + folder.string() +
                 " is in single precision, as COLMAP's meshers read it: so far from the origin "
                 "positions have steps of " +
                 ShortNumber(std::nextafter(far, 2 * far) - far));
  }
  fs::create_directories(folder);
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

void WarnWithoutImageNames(const fs::path& pmvs_cloud, Console* console) {
  const fs::path folder = pmvs_cloud.parent_path().parent_path();
  if (!ReadPmvsImageNames(folder).empty()) return;
  console->Say("WARNING: " + (folder / "bundle.rd.out.list.txt").string() +
               " is missing: image numbers are taken as the order of the model's images");
}

}  // namespace

void FuserOptions::AddOptions(OptionParser* parser) {
  parser->AddOption("drawing_path", &drawing_path,
                    BasicOption("drawing.json to fuse, instead of the one in the output folder"));
  parser->AddOption("dense_type", &paths.dense_type,
                    {"auto", "depth_maps", "fused", "pmvs", "mesh"},
                    BasicOption("which dense results"));
  parser->AddOption("dense_path", &paths.dense_path,
                    BasicOption("their file or folder, instead of those found beside the model"));
  parser->AddOption("remove_occluded", &remove_occluded,
                    BasicOption("leave out links behind the surface, instead of marking them"));
  parser->AddOption("sparse_spacing_px", &sparse_spacing_px,
                    "distance of the curves' points in sparse-with-curves, px");
}

void FuserOptions::Check() const {
  paths.Check();
  LIMN_CHECK_RANGE(sparse_spacing_px, >= 1, <= 1e4);
}

std::string FusionProvenance(const RunOptions& options, const FuserOptions& fuser,
                             const std::string& drawing_provenance) {
  auto json = nlohmann::ordered_json::parse(drawing_provenance);
  auto& dense = json["DenseFusion"] = nlohmann::ordered_json::parse(OptionsAsJson(options.dense));
  dense["dense_type"] = fuser.paths.dense_type;
  dense["remove_occluded"] = fuser.remove_occluded;
  dense["sparse_spacing_px"] = fuser.sparse_spacing_px;
  return json.dump();
}

void CheckFusionFiles(const Project& project, const RunOptions& options) {
  for (const char* name : {"drawing-fused.ply", "drawing-fused.obj"}) {
    CheckResultFile(project.DrawingPath(name), options.overwrite);
  }
  const bool may_replace = options.overwrite || fs::exists(project.DrawingPath(kFusedDrawing));
  std::vector<std::string> names = {"pmvs-with-curves.patch",
                                    "pmvs-with-curves.ply",
                                    "with-curves/fused.ply",
                                    "with-curves/fused.ply.vis",
                                    "with-curves/fused-with-curves.ply",
                                    "with-curves/fused-with-curves.ply.vis"};
  for (const ModelFile& file : kBinaryModelFiles) {
    names.push_back(std::string("sparse-with-curves/") + file.name);
  }
  for (const std::string& name : names) {
    const std::string path = project.DrawingPath(name);
    CheckTakesFile(path);
    if (may_replace || !fs::exists(path)) continue;
    throw IoError(path, "exists, and there is no " + std::string(kFusedDrawing) +
                            " that it belongs to: --overwrite 1 replaces it");
  }
  const fs::path model = project.DrawingPath("with-curves/sparse");
  if (fs::is_directory(fs::symlink_status(model))) {
    throw IoError(model.string(), "is a folder, not the link that is to be made: remove it");
  }
}

DenseInput OpenDenseInput(const Scene& scene, const FuserOptions& options,
                          const std::string& workspace_path, Console* console) {
  if (scene.view_set().HasPanoramas()) {
    throw InputError(scene.layout().model_dir.string() +
                     " has EQUIRECTANGULAR images, for which there are no dense results");
  }
  DenseInput dense;
  dense.products = FindDenseProducts(options.paths, workspace_path, scene.layout().dense_dir);
  console->Say(dense.products.description);
  const size_t num_images = CountRegisteredImages(scene.layout().model_dir);
  if (!dense.products.clouds.empty()) {
    dense.cloud = OpenClouds(dense.products.clouds, scene.views(), num_images);
    dense.points = MovedStream(dense.cloud->points, -scene.origin());
    console->Say(std::to_string(dense.cloud->num_points) + " dense points" +
                 (dense.cloud->has_visibility ? " with the images that see them" : ""));
  }
  switch (dense.products.kind) {
    case DenseKind::kDepthMaps: {
      const size_t count = CountDepthMaps(dense.products.path, scene.views());
      if (count == 0) throw IoError(dense.products.path.string(), "no depth map of any image");
      console->Say(std::to_string(count) + " depth maps for " +
                   std::to_string(scene.views().size()) + " images");
      dense.depths = DepthMapSource(dense.products.path, scene.views());
      break;
    }
    case DenseKind::kPmvs:
      WarnWithoutImageNames(dense.products.path, console);
      [[fallthrough]];
    case DenseKind::kFusedCloud:
      dense.depths = CloudDepthSource(dense.points, scene.views());
      break;
    case DenseKind::kMesh: {
      TriangleMesh mesh = ReadMesh(dense.products.path.string());
      for (Eigen::Vector3d& vertex : mesh.vertices) vertex -= scene.origin();
      dense.depths = MeshDepthSource(std::move(mesh), scene.views());
      break;
    }
  }
  if (!dense.cloud || dense.products.kind == DenseKind::kPmvs) return dense;
  const fs::path& fused = dense.products.clouds.front();
  if (dense.cloud->has_normals) {
    dense.for_meshers = fused;
  } else {
    console->Say("WARNING: " + fused.string() + " has no normals: nothing is written for meshers");
  }
  return dense;
}

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
  console->Say("the drawing adds " + ShortNumber(LengthAdded(result.samples, result.classes)) +
               " that have no dense point within " + ShortNumber(options.near_px) + " footprints");
}

void ColorCurvePoints(const Project& project, const RunContext& context,
                      std::vector<CurvePoint>* points) {
  std::vector<std::vector<size_t>> of_view(project.views().size());
  for (size_t p = 0; p < points->size(); ++p) of_view[(*points)[p].views.front()].push_back(p);
  ParallelFor(context, "reading colors", of_view.size(), [&](size_t v) {
    if (of_view[v].empty()) return;
    const View& view = project.views()[v];
    const Image image = ReadViewImage(project.view_set(), static_cast<ViewId>(v));
    for (const size_t p : of_view[v]) {
      CurvePoint& point = (*points)[p];
      const auto pixel = view.Project(point.position);
      const auto stored = pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
      if (!stored) continue;
      const Eigen::Vector3f color = ColorAt(image, *stored).cwiseMax(0.F).cwiseMin(255.F);
      for (int c = 0; c < 3; ++c) point.color[c] = static_cast<uint8_t>(std::lround(color[c]));
    }
  });
}

void WriteFusionResults(const Project& project, const RunOptions& options,
                        const FuserOptions& fuser, const DenseInput& dense,
                        const DrawingMetadata& metadata, const FusionResult& result,
                        Console* console) {
  const DrawingGraph graph =
      Moved(fuser.remove_occluded ? WithoutOccluded(result.graph) : result.graph, project.origin());
  // The one that says whose the others are is first.
  for (const char* name : {kFusedDrawing, "drawing-fused.ply", "drawing-fused.obj"}) {
    WriteDrawing(project.DrawingPath(name), graph, metadata);
  }
  const InModel curves = ToModel(project, result.points);
  console->Say("wrote " + project.DrawingPath("drawing-fused.{ply,json,obj}"));
  const double spacing = fuser.sparse_spacing_px / options.dense.sample_spacing_px;
  WriteSparseWithCurves(project, std::max(1, static_cast<int>(std::lround(spacing))), curves,
                        console);
  if (dense.products.kind == DenseKind::kPmvs) {
    const fs::path base = project.DrawingPath("pmvs-with-curves");
    WritePmvsWithCurves(base, dense.products.clouds, *dense.cloud, curves.points, curves.views);
    console->Say("wrote " + base.string() + ".{patch,ply}");
  }
  if (!dense.for_meshers.empty()) {
    WriteMeshing(project, dense, curves, console);
  }
}

}  // namespace limn::colmap_ext
