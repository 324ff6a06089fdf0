// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/hidden_links.h"

#include <algorithm>
#include <cstdint>

#include "limn/geometry/polyline.h"
#include "limn/model/footprint.h"
#include "limn/model/link_selection.h"
#include "limn/visibility/face_surface.h"
#include "limn/visibility/render_depth.h"

namespace limn {
namespace {

constexpr double kSpacingPx = 3;
constexpr double kBehindPx = 5;
constexpr double kMinHiddenShare = 0.5;

struct Counts {
  int64_t samples = 0;
  int64_t hidden = 0;
};

struct JudgedLink {
  LinkId link = -1;
  double footprint = 0;
  Polyline3d samples;
};

std::vector<JudgedLink> LinksToJudge(const std::vector<View>& views, const DrawingGraph& graph) {
  std::vector<uint8_t> bounds(graph.links.size(), 0);
  for (const DrawingFace& face : graph.faces) {
    for (const FaceLoop& loop : face.loops) {
      for (const FaceEdge& edge : loop) {
        if (!edge.IsBridge()) bounds[edge.link] = 1;
      }
    }
  }
  const LinkSelection selection;
  std::vector<JudgedLink> judged;
  for (size_t id = 0; id < graph.links.size(); ++id) {
    const DrawingLink& link = graph.links[id];
    const double footprint = LinkFootprint(link, views);
    if (bounds[id] || !selection.Has(link) || !(footprint > 0)) continue;
    judged.push_back({static_cast<LinkId>(id), footprint,
                      ResampleUniform(link.points_in_world, kSpacingPx * footprint)});
  }
  return judged;
}

Counts CountIn(const View& view, const DepthImage& depth, const JudgedLink& link) {
  Counts counts;
  for (const Eigen::Vector3d& sample : link.samples) {
    const auto pixel = view.Project(sample);
    if (!pixel) continue;
    ++counts.samples;
    const double z = (view.cam_from_world * sample).z();
    counts.hidden += IsBehind(depth, *pixel, z, kBehindPx * link.footprint);
  }
  return counts;
}

}  // namespace

std::vector<LinkId> LinksBehindFaces(const std::vector<View>& views, const DrawingGraph& graph,
                                     const RunContext& context) {
  const TriangleMesh mesh = MeshOf(graph.faces);
  const std::vector<JudgedLink> links = LinksToJudge(views, graph);
  std::vector<std::vector<Counts>> per_view(views.size(), std::vector<Counts>(links.size()));
  ParallelFor(context, "links behind faces", views.size(), [&](size_t v) {
    const DepthImage depth = RenderDepth(mesh, views[v], /*scale=*/1);
    for (size_t l = 0; l < links.size(); ++l) {
      const auto& supporting = graph.links[links[l].link].supporting_views;
      if (!std::ranges::binary_search(supporting, static_cast<ViewId>(v))) continue;
      per_view[v][l] = CountIn(views[v], depth, links[l]);
    }
  });
  std::vector<LinkId> behind;
  for (size_t l = 0; l < links.size(); ++l) {
    Counts all;
    for (const auto& of_view : per_view) {
      all.samples += of_view[l].samples;
      all.hidden += of_view[l].hidden;
    }
    if (static_cast<double>(all.hidden) > kMinHiddenShare * static_cast<double>(all.samples)) {
      behind.push_back(links[l].link);
    }
  }
  return behind;
}

}  // namespace limn
