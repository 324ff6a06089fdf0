// SPDX-License-Identifier: BSD-3-Clause
#include "limn/tiles/tile_cropping.h"

#include <cstdint>
#include <optional>
#include <vector>

#include "limn/topology/graph_editor.h"

namespace limn {
namespace {

// The part of a step between two points inside the core, as shares of the step; empty unless enter
// < leave.
struct InsidePart {
  double enter = 0;
  double leave = 1;
  // Where the step enters and leaves, unless at its end points.
  Eigen::Vector3d enters_at = Eigen::Vector3d::Zero();
  Eigen::Vector3d leaves_at = Eigen::Vector3d::Zero();

  bool IsEmpty() const { return !(enter < leave); }
};

InsidePart Clip(const Eigen::AlignedBox3d& core, const Eigen::Vector3d& from,
                const Eigen::Vector3d& to) {
  InsidePart part;
  const Eigen::Vector3d step = to - from;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = core.min()[axis], high = core.max()[axis];
    if (step[axis] == 0) {
      if (from[axis] < low || from[axis] > high) part.leave = -1;
      continue;
    }
    const double first = step[axis] > 0 ? low : high, last = step[axis] > 0 ? high : low;
    const auto at = [&](double plane, double share) {
      Eigen::Vector3d point = from + share * step;
      point[axis] = plane;
      return point;
    };
    const double enter = (first - from[axis]) / step[axis];
    if (enter > part.enter) {
      part.enter = enter;
      part.enters_at = at(first, enter);
    }
    const double leave = (last - from[axis]) / step[axis];
    if (leave < part.leave) {
      part.leave = leave;
      part.leaves_at = at(last, leave);
    }
  }
  return part;
}

// A place on a link where it crosses the border: a new point after point `after`, or, with no new
// point, that point itself.
struct Crossing {
  int after = 0;
  std::optional<Eigen::Vector3d> point;
};

std::vector<Crossing> FindCrossings(const Eigen::AlignedBox3d& core, const DrawingLink& link) {
  std::vector<Crossing> crossings;
  const auto& points = link.points_in_world;
  bool was_inside = true;  // up to the point before; nothing is before the first
  for (int k = 1; k < static_cast<int>(points.size()); ++k) {
    const InsidePart part = Clip(core, points[k - 1], points[k]);
    const bool begins_inside = !part.IsEmpty() && part.enter == 0;
    if (k > 1 && begins_inside != was_inside) crossings.push_back({k - 1, std::nullopt});
    if (!part.IsEmpty() && part.enter > 0) crossings.push_back({k - 1, part.enters_at});
    if (!part.IsEmpty() && part.leave < 1) crossings.push_back({k - 1, part.leaves_at});
    was_inside = !part.IsEmpty() && part.leave == 1;
  }
  return crossings;
}

// Adds points where a link crosses the border. Returns their indices, ascending.
std::vector<int> AddCrossings(const Eigen::AlignedBox3d& core, DrawingLink* link) {
  std::vector<int> indices;
  int num_added = 0;
  for (const Crossing& crossing : FindCrossings(core, *link)) {
    const int after = crossing.after + num_added;
    if (!crossing.point) {
      indices.push_back(after);
      continue;
    }
    link->points_in_world.insert(link->points_in_world.begin() + after + 1, *crossing.point);
    link->sigma.insert(link->sigma.begin() + after + 1, link->sigma[after]);
    indices.push_back(after + 1);
    ++num_added;
  }
  return indices;
}

// Cut a link at its crossings; the parts are the link itself and the last links.
void CutAtBorder(LinkId id, std::vector<int> crossings, GraphEditor* editor) {
  if (!crossings.empty() && editor->link(id).closed) {
    const int start = crossings.front();
    editor->Split(id, start);
    editor->Free({id, 1});
    crossings.erase(crossings.begin());
    for (int& crossing : crossings) crossing -= start;
  }
  for (auto it = crossings.rbegin(); it != crossings.rend(); ++it) editor->Split(id, *it);
}

// For a link that crosses the border only at its ends.
bool IsInside(const Eigen::AlignedBox3d& core, const DrawingLink& link) {
  const size_t middle = (link.points_in_world.size() - 1) / 2;
  return core.contains((link.points_in_world[middle] + link.points_in_world[middle + 1]) / 2);
}

void KeepSide(const Eigen::AlignedBox3d& box, bool inside, DrawingGraph* graph) {
  std::vector<std::vector<int>> crossings;
  for (DrawingLink& link : graph->links) crossings.push_back(AddCrossings(box, &link));
  GraphEditor editor(graph);
  for (size_t l = 0; l < crossings.size(); ++l) {
    CutAtBorder(static_cast<LinkId>(l), crossings[l], &editor);
  }
  std::vector<uint8_t> keep;
  for (const DrawingLink& link : graph->links) keep.push_back(IsInside(box, link) == inside);
  editor.Keep(keep);
}

}  // namespace

void CropDrawing(const Eigen::AlignedBox3d& core, DrawingGraph* graph) {
  KeepSide(core, /*inside=*/true, graph);
}

void CutOut(const Eigen::AlignedBox3d& hole, DrawingGraph* graph) {
  KeepSide(hole, /*inside=*/false, graph);
}

bool IsOnBorder(const Eigen::AlignedBox3d& core, const Eigen::Vector3d& point) {
  return (point.array() == core.min().array() || point.array() == core.max().array()).any();
}

}  // namespace limn
