// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/aligned_project.h"

#include <filesystem>
#include <numeric>
#include <optional>
#include <ostream>
#include <system_error>
#include <utility>
#include <vector>

#include "colmap_ext/dense_files/moved_files.h"
#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/scene_origin.h"
#include "colmap_ext/model/transform_model.h"
#include "colmap_ext/verbs/aligned_folder.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/page.h"
#include "colmap_ext/verbs/renew_page.h"
#include "colmap_ext/workspace/find_masks.h"
#include "colmap_ext/workspace/image_files.h"
#include "limn/files/atomic_file.h"
#include "limn/files/output_link.h"
#include "limn/formats/write_drawing.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"
#include "limn/util/name_list.h"
#include "limn/util/number_text.h"
#include "limn/viewer/viewer_page.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Farther from the origin, numbers in single precision have steps of 0.1 mm and more.
constexpr double kFarMeters = 1000;
// Local origins are multiples of this.
constexpr double kOriginStepMeters = 100;

// The frame of all files in the folder.
struct AlignedFrame {
  Similarity3d frame_from_model;
  // Its origin in the world; zero: it is the world.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();

  bool HasOffset() const { return !offset.isZero(); }
  std::string OffsetText() const {
    return NumberText(offset.x()) + " " + NumberText(offset.y()) + " " + NumberText(offset.z());
  }
};

AlignedFrame FrameOf(const SparseModel& model, const Similarity3d& world_from_model) {
  AlignedFrame frame{world_from_model};
  if (model.images.empty()) return frame;
  const Eigen::Vector3d middle = world_from_model * MiddleOfCameras(model);
  if (middle.cwiseAbs().maxCoeff() <= kFarMeters) return frame;
  frame.offset = (middle / kOriginStepMeters).array().round() * kOriginStepMeters;
  frame.frame_from_model.translation -= frame.offset;
  return frame;
}

// Where a link to the folder of images would not do, since files have other names than images: a
// link for each. Whether there are links.
bool LinkImages(const SparseModel& model, const fs::path& image_dir, const OutputPath& folder) {
  std::vector<int> all(model.images.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<std::string> files = FindImageFiles(model, all, image_dir, {}).paths;
  bool have_their_names = true;
  for (size_t i = 0; i < files.size(); ++i) {
    have_their_names &= image_dir / model.images[i].StoredName() == files[i];
  }
  if (have_their_names) return MakeLink(image_dir, folder);
  std::error_code ignored;
  for (size_t i = 0; i < files.size(); ++i) {
    if (!fs::exists(files[i], ignored)) continue;
    if (!MakeLink(files[i], folder / model.images[i].StoredName())) return false;
  }
  return true;
}

void SayImages(bool have_links, const Project& project, const OutputPath& folder,
               Console* console) {
  const std::string& images = project.layout().image_dir.string();
  if (!have_links) {
    console->Say("WARNING: " + folder.string() +
                 " has no images, as the file system has no links: name them with --image_path " +
                 images);
  }
  const std::string masks = MaskListOf(project.layout().given_model_dir);
  if (!masks.empty()) {
    console->Say("NOTE: " + folder.string() + " has no masks: name them with --mask_path " + masks);
  }
}

// In the frame of the folder. It fits the model there, whatever that is.
void WriteDrawingFiles(const Project& project, const DrawingInScene& drawing,
                       const AlignedFrame& frame, const OutputPath& folder) {
  const Similarity3d model_from_scene = {1, Eigen::Matrix3d::Identity(), project.origin()};
  const auto [scale, rotation, translation] = frame.frame_from_model * model_from_scene;
  const DrawingGraph graph = Transformed(drawing.graph, scale, rotation, translation);
  DrawingMetadata metadata = After(frame.frame_from_model, drawing.metadata);
  metadata.alignment->world_from_model = {1, Eigen::Matrix3d::Identity(), frame.offset};
  metadata.refined_cameras.clear();
  WriteDrawing(folder / "drawing.json", graph, metadata);
  const DrawingGraph selected = Selected(graph, LinkSelection());
  DrawingFormatOptions format;
  if (metadata.alignment->IsMetric()) format.unit = LengthUnit::kMeter;
  for (const char* name : {"drawing.ply", "drawing.obj"}) {
    WriteDrawing(folder / name, selected, metadata, format);
  }
}

void WriteAlignedPage(const Project& project, const RunOptions& options,
                      const DrawingInScene& drawing, const AlignedFrame& frame,
                      const OutputPath& folder, Console* console) {
  Alignment shown = *drawing.metadata.alignment;
  shown.world_from_model = frame.frame_from_model;
  PageOptions page;
  // Once it is renewed: the coordinates of the folder, not those far away.
  if (frame.HasOffset()) page.shown = PageOptions::Shown::kModel;
  PageParts parts;
  parts.report_json = ReportOfPage(project, console);
  parts.cloud = MakeCloud(project, options.layout.workspace_path, page, console);
  parts.thumbnails = MakeThumbnails(project, drawing.views, page.thumbnail_size, {}, console);
  ViewerScene scene = MakeViewerScene(project, drawing, page, std::move(parts), shown);
  scene.shown_from_model = Similarity3d();  // edits are of the drawing in the folder
  const std::string name = "drawing.json";
  scene.drawing = {name, FingerprintOf((folder / name).string())};
  WriteFileAtomically(folder / kViewerPage,
                      [&](std::ostream& out) { WriteViewerPage(scene, out); });
}

void WriteOffset(const AlignedFrame& frame, const OutputPath& folder) {
  WriteFileAtomically(folder / "offset.txt", [&](std::ostream& out) {
    out << "# Of this folder, written by limn: to be added to all of its coordinates, for those of "
           "the world: X Y Z\n"
        << frame.OffsetText() << '\n';
  });
}

// The dense workspace, or else the project; empty if neither is given.
fs::path DenseFolder(const Project& project, const RunOptions& options) {
  const fs::path workspace = options.layout.workspace_path;
  const fs::path& dense = project.layout().dense_dir;
  const bool is_elsewhere = !HasDenseFiles(dense) && HasDenseFiles(workspace);
  return dense.empty() || is_elsewhere ? workspace : dense;
}

// Depth maps and PMVS's patches.
void SayLeftOut(const Project& project, const fs::path& workspace, const fs::path& dense,
                Console* console) {
  std::error_code ignored;
  if (!dense.empty() && fs::exists(dense / "stereo", ignored)) {
    console->Say("NOTE: " + (dense / "stereo").string() +
                 " is left out: depth maps are in the unit of the model");
  }
  const auto pmvs = LookForDenseProducts({"pmvs", ""}, workspace, project.layout().dense_dir);
  if (pmvs) {
    console->Say("NOTE: " + pmvs->path.parent_path().string() +
                 " is left out: patches belong to PMVS's own projection matrices");
  }
}

void SayDense(const MovedFiles& moved, const Project& project, Console* console) {
  for (const std::string& reason : moved.left_out) {
    console->Say("WARNING: " + reason + ": left out");
  }
  const WorkspaceLayout& layout = project.layout();
  if (!moved.names.empty() && layout.model_dir != layout.given_model_dir) {
    console->Say(
        "WARNING: the drawing fits refined cameras, but these were made with the cameras as "
        "given: " +
        ListNames(moved.names));
  }
}

fs::path FolderOf(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  return whole.has_filename() ? whole.parent_path() : whole.parent_path().parent_path();
}

}  // namespace

void CheckAlignedProject(const Project& project, const RunOptions& options) {
  const OutputPath folder = project.DrawingPath(kAlignedFolder);
  CheckAlignedFolder(folder, options.overwrite);
  const WorkspaceLayout& layout = project.layout();
  for (const fs::path& read : {layout.model_dir, layout.given_model_dir, layout.image_dir}) {
    std::error_code ignored;
    if (!fs::equivalent(FolderOf(read), folder.string(), ignored)) continue;
    throw IoError(folder.string(), "would be replaced, but " + read.string() +
                                       " in it is read: choose another --output_path");
  }
}

void WriteAlignedProject(const Project& project, const RunOptions& options,
                         const DrawingInScene& drawing, Console* console) {
  const OutputPath path = project.DrawingPath(kAlignedFolder);
  SparseModel model = project.ReadModel();
  if (!HasTextNames(model)) model.flavor = ModelFlavor::kBinary;
  const AlignedFrame frame = FrameOf(model, drawing.metadata.alignment->world_from_model);
  const std::string comment = frame.HasOffset() ? "offset " + frame.OffsetText() : "";
  const fs::path dense = DenseFolder(project, options);
  bool have_links = false;
  MovedFiles moved;
  WriteAlignedFolder(path, options.overwrite, [&](const OutputPath& folder) {
    TransformModel(frame.frame_from_model, &model);
    WriteModel(model, model.flavor, folder / "sparse");
    have_links = LinkImages(model, project.layout().image_dir, folder / "images");
    if (!dense.empty())
      moved = MoveDenseFiles(dense, frame.frame_from_model, comment, folder, console->context());
    WriteDrawingFiles(project, drawing, frame, folder);
    if (HasViewerPage()) WriteAlignedPage(project, options, drawing, frame, folder, console);
    if (frame.HasOffset()) WriteOffset(frame, folder);
  });
  SayImages(have_links, project, path, console);
  SayDense(moved, project, console);
  SayLeftOut(project, options.layout.workspace_path, dense, console);
  std::string files = "sparse/, drawing.{json,ply,obj}";
  if (HasViewerPage()) files += std::string(", ") + kViewerPage;
  for (const std::string& name : moved.names) files += ", " + name;
  console->Say("Written: " + path.string() + ", the project in the world: " + files);
  if (frame.HasOffset()) {
    console->Say("The world's origin is far away: all coordinates in " + path.string() +
                 " are relative to " + frame.OffsetText() + ", which is in its offset.txt");
  }
}

}  // namespace limn::colmap_ext
