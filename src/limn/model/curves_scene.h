// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/model/curve3d.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn {

inline const SceneHints kNoHints = {};

// A scene as the stages after the edges see it: the cameras and the curves in their images.
struct CurvesScene {
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;  // per view, after ApplyLens
  const SceneHints& hints = kNoHints;
  // Only what lies in this box is drawn.
  std::optional<Eigen::AlignedBox3d> box = std::nullopt;
};

}  // namespace limn
