#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limn/topology/joints.h"

namespace limn {

// A direction in space in which image edges leave a joint, and no link does yet.
struct CornerDirection {
  Eigen::Vector3d unit = Eigen::Vector3d::Zero();
  std::vector<ViewId> views;  // whose rays agree
};

// In every view that sees the joint, straight edges that begin at its projection and that none of
// its links explains are collected as rays. Rays of two views give a direction in space; the one is
// returned that chance explains least, if rays of at least min_views views agree. Time: views times
// pairs of rays of the views that propose directions, of which there are at most 24.
std::optional<CornerDirection> FindCornerDirection(const Joint& joint,
                                                   const std::vector<View>& views,
                                                   const std::vector<ImageCurves>& curves,
                                                   const EdgelIndexes& edgels, int min_views);

}  // namespace limn
