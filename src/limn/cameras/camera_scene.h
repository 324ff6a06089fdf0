// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "limn/cameras/camera_mounts.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn {

// A point of the sparse model as images show it, whatever their lenses.
struct SeenPoint {
  struct Sight {
    ViewId view = -1;
    Eigen::Vector2d stored_px = Eigen::Vector2d::Zero();
  };
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  std::vector<Sight> sights;
  bool is_fitted = false;  // else where it was given
};

// A scene whose cameras are being refined.
struct CameraScene {
  std::vector<View> given;
  CameraMounts mounts;
  std::vector<View> views;        // with the cameras as they are now
  std::vector<SeenPoint> points;  // as those of the hints
};

CameraScene MakeCameraScene(const std::vector<View>& views, const SceneHints& hints,
                            const CameraMounts& mounts);

// The hints with the positions of the scene's points, and their pixels as these views see them.
SceneHints HintsOf(const CameraScene& scene, const SceneHints& given,
                   const std::vector<View>& views);

// All lengths multiplied.
CameraScene Scaled(CameraScene scene, double factor);

// Pictures of the scene, and the curves in them: the views as they are, with curves as the given
// lenses have mapped them, or the photographs made smaller by a whole number, with curves in their
// stored pixels.
struct PictureLevel {
  int factor = 1;
  std::vector<ImageCurves> curves;  // per view
  // As lenses that were asked for have mapped them, and these lenses, per view; empty if the curves
  // are as they see them.
  std::vector<ImageCurves> seen = {};
  std::vector<std::shared_ptr<const LensMap>> seen_through = {};
};

// Pixels of a view per pixel of a picture of it: 1 for the views as they are, View::scale times the
// factor for smaller photographs.
double ViewPxPerPicturePx(const View& view, int factor);

// The views of small pictures.
std::vector<View> ShrunkViews(const std::vector<View>& views, int factor);

// The curves of pictures as the cameras of the scene see them now. They stay valid until cameras
// with other lenses ask for them.
const std::vector<ImageCurves>& CurvesSeenNow(const CameraScene& scene, const RunContext& context,
                                              PictureLevel* level);

// Curves that lenses have mapped, as these views of the same pictures see them.
std::vector<ImageCurves> CurvesThroughOtherLenses(const std::vector<View>& views,
                                                  const std::vector<ImageCurves>& curves,
                                                  const RunContext& context);

// The view with other optics; its region stays what it is in the stored image.
View WithOptics(View view, const Optics& optics);

// By camera_index, how far a parameter of the calibration must change to move some pixel of an
// image by 1 px.
std::map<int, Eigen::VectorXd> ParametersPerPx(const std::vector<View>& views);

}  // namespace limn
