// SPDX-License-Identifier: BSD-3-Clause
#include "limn/rods/draw_rod.h"

#include <algorithm>
#include <iterator>

#include <Eigen/Geometry>

#include "limn/geometry/polyline.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/link_geometry.h"
#include "limn/util/angles.h"
#include "limn/util/logistic.h"

namespace limn {
namespace {

// A link runs along a rod at points within its outlines and this many px, in its direction.
constexpr double kOutlineReachPx = 1.5;
constexpr double kOutlineTurnRad = 25 * kDeg;
// Parts along a rod, and parts beside it, are at least this long, px.
constexpr double kMinPartPx = 6;
// Ends of rods touch within their radii and this many px.
constexpr double kTouchPx = 1.5;

class RodDrawing {
 public:
  explicit RodDrawing(DrawingGraph* graph) : graph_(*graph), editor_(graph) {}

  int64_t Run(std::span<const FoundRod> rods) {
    int64_t num_outlines = 0;
    for (const FoundRod& found : rods) num_outlines += DoubtOutlines(found.rod);
    std::vector<LinkId> links;
    for (const FoundRod& found : rods) links.push_back(editor_.Add(LinkOf(found)));
    JoinTouching(rods, links);
    editor_.Compact();
    return num_outlines;
  }

 private:
  int64_t DoubtOutlines(const Rod& rod) {
    int64_t count = 0;
    const Eigen::AlignedBox3d near = Around(rod);
    const int num_links = editor_.NumLinks();
    for (LinkId id = 0; id < num_links; ++id) {
      const DrawingLink& link = editor_.link(id);
      if (link.tentative) continue;
      if (!near.intersects(BoxOf(link.points_in_world))) continue;
      for (const LinkId part : PartsAlong(rod, id)) {
        graph_.links[part].tentative = true;
        graph_.links[part].doubt = LinkDoubt::kRodOutline;
        ++count;
      }
    }
    return count;
  }

  static Eigen::AlignedBox3d BoxOf(const Polyline3d& points) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : points) box.extend(point);
    return box;
  }

  // What is in reach of its axis.
  static Eigen::AlignedBox3d Around(const Rod& rod) {
    const Eigen::Vector3d reach =
        Eigen::Vector3d::Constant(rod.radius + kOutlineReachPx * rod.footprint);
    const Eigen::AlignedBox3d box = BoxOf(rod.axis);
    return {box.min() - reach, box.max() + reach};
  }

  // Cuts a link where it leaves or joins a rod. Returns the parts along the rod.
  std::vector<LinkId> PartsAlong(const Rod& rod, LinkId id) {
    const std::vector<uint8_t> along = Along(rod, editor_.link(id));
    const bool is_whole = std::ranges::count(along, along.front()) == std::ssize(along);
    if (editor_.link(id).closed && !is_whole) return {};
    std::vector<LinkId> parts;
    // From the back, so that the points before a cut stay where they are.
    for (int k = editor_.link(id).size() - 2; k > 0; --k) {
      if (along[k] == along[k - 1]) continue;
      editor_.Split(id, k);
      if (along[k]) parts.push_back(editor_.NumLinks() - 1);
    }
    if (along.front()) parts.push_back(id);
    return parts;
  }

  // Per point of a link, whether it runs along a rod; short stretches are as those beside them.
  static std::vector<uint8_t> Along(const Rod& rod, const DrawingLink& link) {
    std::vector<uint8_t> along(link.size(), 0);
    for (int k = 0; k < link.size(); ++k) {
      along[k] = RunsAlong(rod, link.points_in_world[k], TangentAt(link, k), kOutlineReachPx,
                           kOutlineTurnRad);
    }
    const std::vector<double> arc = CumulativeLength(link.points_in_world);
    for (const uint8_t value : {0, 1}) FillShort(value, kMinPartPx * rod.footprint, arc, &along);
    return along;
  }

  // Turns runs of `value` that are shorter than `min_length`, unless they are all there is.
  static void FillShort(uint8_t value, double min_length, const std::vector<double>& arc,
                        std::vector<uint8_t>* along) {
    const size_t size = along->size();
    for (size_t begin = 0; begin < size;) {
      size_t end = begin;
      while (end < size && (*along)[end] == (*along)[begin]) ++end;
      const bool is_all = begin == 0 && end == size;
      if ((*along)[begin] == value && !is_all && arc[end - 1] - arc[begin] < min_length) {
        std::fill(along->begin() + static_cast<std::ptrdiff_t>(begin),
                  along->begin() + static_cast<std::ptrdiff_t>(end), !value);
      }
      begin = end;
    }
  }

  DrawingLink LinkOf(const FoundRod& found) const {
    DrawingLink link;
    link.points_in_world = found.rod.axis;
    link.kind = LinkKind::kRod;
    link.kind_confidence = Logistic(found.evidence.log_ratio);
    link.rod_radius = found.rod.radius;
    link.supporting_views = found.views;
    link.residual_px = found.evidence.rms_px;
    link.sigma.assign(link.points_in_world.size(), found.evidence.rms_px * found.rod.footprint);
    return link;
  }

  void JoinTouching(std::span<const FoundRod> rods, const std::vector<LinkId>& links) {
    for (size_t a = 0; a < rods.size(); ++a) {
      for (size_t b = a + 1; b < rods.size(); ++b) {
        const double reach =
            rods[a].rod.radius + rods[b].rod.radius + kTouchPx * rods[a].rod.footprint;
        for (const int end_a : {0, 1}) {
          for (const int end_b : {0, 1}) {
            const NodeId node_a = editor_.NodeAt({links[a], end_a});
            const NodeId node_b = editor_.NodeAt({links[b], end_b});
            const Eigen::Vector3d at_a = editor_.node(node_a).position_in_world;
            const Eigen::Vector3d at_b = editor_.node(node_b).position_in_world;
            if ((at_a - at_b).norm() > reach) continue;
            // It would be a loop.
            if (node_a == editor_.NodeAt({links[b], 1 - end_b})) continue;
            if (node_a == node_b) continue;
            editor_.MoveEnds(node_b, node_a);
          }
        }
      }
    }
  }

  DrawingGraph& graph_;
  GraphEditor editor_;
};

}  // namespace

int64_t DrawRods(std::span<const FoundRod> rods, DrawingGraph* graph) {
  return RodDrawing(graph).Run(rods);
}

}  // namespace limn
