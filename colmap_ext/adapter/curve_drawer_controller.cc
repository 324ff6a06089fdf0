// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/adapter/curve_drawer_controller.h"

#include <exception>
#include <utility>
#include <vector>

#include <glog/logging.h>

#include "colmap_ext/adapter/log_console.h"
#include "colmap_ext/adapter/reconstruction_model.h"
#include "colmap_ext/dense_files/sparse_with_curves.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/draw.h"
#include "colmap_ext/verbs/fuse.h"
#include "limn/dense/fuse_drawing.h"
#include "limn/model/link_selection.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

// Throws OptionError.
void CheckOptions(const CurveDrawerOptions& options) {
  const DrawerOptions& drawer = options.drawer;
  const double point_spacing_px = options.point_spacing_px;
  LIMN_CHECK_RANGE_OR(point_spacing_px, 0, >= 0.1, <= 1e4);
  if (point_spacing_px > 0 && drawer.run.pipeline.refine_cameras == CameraRefinement::kOn &&
      drawer.run.pipeline.output_cameras == OutputCameras::kRefined) {
    throw OptionError("point_spacing_px: the reconstruction lacks the refined poses");
  }
  drawer.Check();
  drawer.run.CheckValues();
}

}  // namespace

bool CurveDrawerOptions::Check() const {
  try {
    CheckOptions(*this);
    return true;
  } catch (const std::exception& error) {
    LOG(ERROR) << PrintableLine(error.what());
    return false;
  }
}

CurveDrawerController::CurveDrawerController(CurveDrawerOptions options,
                                             std::shared_ptr<colmap::Reconstruction> reconstruction)
    : options_(std::move(options)), reconstruction_(std::move(reconstruction)) {}

void CurveDrawerController::Run() {
  drawing_.reset();
  error_.clear();
  LOG(INFO) << "Curve drawing";
  try {
    CheckOptions(options_);
    Draw();
  } catch (const Cancelled&) {
    LOG(WARNING) << "Curve drawing was stopped";
  } catch (const std::exception& error) {
    error_ = error.what();
    LOG(ERROR) << "Curve drawing failed: " << PrintableLine(error_);
  }
}

void CurveDrawerController::Draw() {
  DrawerOptions options = options_.drawer;
  options.run.layout.image_path = options_.image_path;
  options.run.layout.output_path = options_.output_path;
  // Points get the cameras of the reconstruction.
  PipelineOptions& pipeline = options.run.pipeline;
  if (options_.point_spacing_px > 0 && pipeline.output_cameras == OutputCameras::kRefined) {
    pipeline.refine_cameras = CameraRefinement::kOff;
  }
  options.SetDerived();
  LogConsole console(options.run.num_threads, PrintingAt(options.run.log_level),
                     [this] { return IsColmapStopped(this); });
  const Project project(ToSparseModel(*reconstruction_), options.run, &console);
  if (options_.point_spacing_px > 0 && project.view_set().HasPanoramas()) {
    throw OptionError(
        "point_spacing_px: the model has EQUIRECTANGULAR images, which take no points of curves");
  }
  std::optional<DrawingGraph> graph = DrawProject(project, options, &console);
  if (!graph) return;  // a shard
  if (options_.point_spacing_px > 0) AddPoints(project, *graph, console);
  drawing_ = Moved(std::move(*graph), project.origin());
}

void CurveDrawerController::AddPoints(const Project& project, const DrawingGraph& graph,
                                      const Console& console) {
  DenseOptions spacing;
  spacing.sample_spacing_px = options_.point_spacing_px * project.view_set().TypicalScale();
  const DepthSource no_depths = [](ViewId) { return std::nullopt; };
  std::vector<CurvePoint> points =
      FuseDrawing({project.views(), Selected(graph, {}), no_depths, false, std::nullopt}, spacing,
                  console.context())
          .points;
  ColorCurvePoints(project, console.context(), &points);
  for (CurvePoint& point : points) point.position += project.origin();
  const std::vector<View> views = Moved(project.views(), project.origin());
  SparseModel model = project.ReadModel();
  const size_t num_before = model.points.size();
  model = AddCurvePoints(std::move(model), points, views, /*every=*/1);
  AppendPoints(model, num_before, reconstruction_.get());
  LOG(INFO) << "Added " << model.points.size() - num_before << " points of curves";
}

}  // namespace limn::colmap_ext
