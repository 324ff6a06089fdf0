// SPDX-License-Identifier: BSD-3-Clause
#include "limn/model/drawing_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "limn/geometry/polyline.h"
#include "limn/model/link_shape.h"
#include "limn/util/name_table.h"

namespace limn {
namespace {

constexpr NameTable<NodeKind, 3> kNodeKinds = {{"end", "junction", "loop_anchor"}};
constexpr NameTable<LinkKind, kNumLinkKinds> kLinkKinds = {
    {"unknown", "edge", "paint", "shadow", "contour", "rod", "texture"}};
constexpr NameTable<LinkDoubt, kNumLinkDoubts> kLinkDoubts = {
    {"", "few views", "chance", "seen through", "explained by others", "outline of a rod",
     "depth not measured", "still in the images", "short and unlikely"}};
constexpr NameTable<DenseClass, 4> kDenseClasses = {{"unknown", "surface", "boundary", "free"}};

class Violations {
 public:
  void Add(const std::string& what, int id, const std::string& problem) {
    list_.push_back(what + " " + std::to_string(id) + ": " + problem);
  }
  std::vector<std::string> Take() { return std::move(list_); }

 private:
  std::vector<std::string> list_;
};

bool IsNode(const DrawingGraph& graph, NodeId id) {
  return id >= 0 && id < static_cast<int>(graph.nodes.size());
}

bool HasIncidence(const DrawingNode& node, LinkEnd end) {
  return std::binary_search(node.incident.begin(), node.incident.end(), end);
}

void CheckLink(const DrawingGraph& graph, LinkId id, Violations* violations) {
  const DrawingLink& link = graph.links[id];
  if (!IsNode(graph, link.node0) || !IsNode(graph, link.node1)) {
    violations->Add("link", id, "node out of range");
    return;
  }
  if (link.points_in_world.size() < 2) {
    violations->Add("link", id, "fewer than two points");
    return;
  }
  for (const Eigen::Vector3d& point : link.points_in_world) {
    if (!point.allFinite()) violations->Add("link", id, "point not finite");
  }
  if (!(Length(link.points_in_world) > 0)) violations->Add("link", id, "zero length");
  if (link.sigma.size() != link.points_in_world.size()) {
    violations->Add("link", id, "as many sigmas as points needed");
  }
  if (!link.vertices.empty() && link.vertices.size() != link.points_in_world.size()) {
    violations->Add("link", id, "as many vertices as points needed");
  }
  if (link.points_in_world.front() != graph.nodes[link.node0].position_in_world ||
      link.points_in_world.back() != graph.nodes[link.node1].position_in_world) {
    violations->Add("link", id, "ends are not at its nodes");
  }
  if (!(link.kind_confidence >= 0 && link.kind_confidence <= 1)) {
    violations->Add("link", id, "confidence of its kind not from 0 to 1");
  }
  if (link.evidence && !std::isfinite(*link.evidence)) {
    violations->Add("link", id, "evidence not finite");
  }
  if (!(link.confidence == -1 || (link.confidence >= 0 && link.confidence <= 1))) {
    violations->Add("link", id, "confidence not from 0 to 1");
  }
  if (!(link.tri_angle_deg == -1 || (link.tri_angle_deg >= 0 && link.tri_angle_deg <= 90))) {
    violations->Add("link", id, "triangulation angle not from 0 to 90");
  }
  if (!(link.depth_sigma == -1 || link.depth_sigma >= 0) || !std::isfinite(link.depth_sigma)) {
    violations->Add("link", id, "standard deviation of its depth below 0 or not finite");
  }
  if (!(link.curve_px >= 0) || !std::isfinite(link.curve_px)) {
    violations->Add("link", id, "length of its curve below 0 or not finite");
  }
  const bool has_radius = link.rod_radius > 0 && std::isfinite(link.rod_radius);
  if (link.kind == LinkKind::kRod ? !has_radius : link.rod_radius != 0) {
    violations->Add("link", id, "a rod needs a radius, and nothing else has one");
  }
  if (link.body) {
    const std::string broken =
        link.kind == LinkKind::kContour ? Validate(*link.body) : "a body, but no contour";
    if (!broken.empty()) violations->Add("link", id, broken);
  }
  if (!link.tentative && link.doubt != LinkDoubt::kNone) {
    violations->Add("link", id, "doubted, but not tentative");
  }
  if (link.primitive) {
    const std::string broken = ValidateShape(link.primitive->shape);
    if (!broken.empty()) {
      violations->Add("link", id, "primitive: " + broken);
    } else if (!IsAlongLink(link.primitive->shape, link.points_in_world)) {
      violations->Add("link", id, "primitive: it is not where the points of the link are");
    }
  }
  if (link.regularity) {
    const std::string broken = Validate(*link.regularity, graph.regularities);
    if (!broken.empty()) violations->Add("link", id, broken);
  }
  if (link.closed && link.node0 != link.node1) {
    violations->Add("link", id, "closed, but with two nodes");
  }
  if (!HasIncidence(graph.nodes[link.node0], {id, 0}) ||
      !HasIncidence(graph.nodes[link.node1], {id, 1})) {
    violations->Add("link", id, "missing at its node");
  }
}

// False too where the incident link does not exist.
bool IsLoopAnchor(const DrawingGraph& graph, const DrawingNode& node) {
  if (node.incident.size() != 2 || node.incident[0].link != node.incident[1].link) return false;
  const LinkId link = node.incident[0].link;
  return link >= 0 && link < static_cast<int>(graph.links.size()) && graph.links[link].closed;
}

void CheckIncidence(const DrawingGraph& graph, NodeId id, Violations* violations) {
  const DrawingNode& node = graph.nodes[id];
  for (const LinkEnd& end : node.incident) {
    if (end.link < 0 || end.link >= static_cast<int>(graph.links.size()) ||
        (end.end != 0 && end.end != 1)) {
      violations->Add("node", id, "incident link end out of range");
      return;
    }
    const DrawingLink& link = graph.links[end.link];
    if ((end.end == 0 ? link.node0 : link.node1) != id) {
      violations->Add("node", id, "incident link does not end here");
    }
  }
  for (const auto& [first, second] : node.continuations) {
    if (!HasIncidence(node, first) || !HasIncidence(node, second)) {
      violations->Add("node", id, "continuation of a link that does not end here");
    }
  }
}

void CheckOrder(const DrawingGraph& graph, NodeId id, Violations* violations) {
  const std::vector<LinkEnd>& ends = graph.nodes[id].incident;
  if (!std::is_sorted(ends.begin(), ends.end())) {
    violations->Add("node", id, "incident link ends not ascending");
  }
}

// Symmetric, and without negative variances but by rounding.
bool IsCovariance(const Eigen::Matrix3d& matrix) {
  if (!matrix.allFinite() || !(matrix.trace() >= 0)) return false;
  const double slack = 1e-9 * matrix.trace();
  if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > slack) return false;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(matrix, Eigen::EigenvaluesOnly);
  return axes.eigenvalues()[0] >= -slack;
}

void CheckNode(const DrawingGraph& graph, NodeId id, Violations* violations) {
  const DrawingNode& node = graph.nodes[id];
  if (!node.position_in_world.allFinite()) violations->Add("node", id, "position not finite");
  if (!IsCovariance(node.covariance)) violations->Add("node", id, "not a covariance");
  if (node.incident.empty()) violations->Add("node", id, "no link ends here");
  const bool should_be_junction = node.Degree() >= 3;
  if ((node.kind == NodeKind::kJunction) != should_be_junction) {
    violations->Add("node", id, "junction and degree >= 3 do not agree");
  }
  CheckIncidence(graph, id, violations);
}

void CheckFaces(const DrawingGraph& graph, Violations* violations) {
  std::vector<int> num_points;
  for (const DrawingLink& link : graph.links) num_points.push_back(link.size());
  for (size_t id = 0; id < graph.faces.size(); ++id) {
    const std::string broken = Validate(graph.faces[id], num_points);
    if (!broken.empty()) violations->Add("face", static_cast<int>(id), broken);
  }
}

}  // namespace

const char* NodeKindName(NodeKind kind) { return kNodeKinds.Of(kind); }
const char* LinkKindName(LinkKind kind) { return kLinkKinds.Of(kind); }
const char* LinkDoubtName(LinkDoubt doubt) { return kLinkDoubts.Of(doubt); }
const char* DenseClassName(DenseClass dense_class) { return kDenseClasses.Of(dense_class); }

std::optional<LinkKind> LinkKindNamed(const std::string& name) { return kLinkKinds.Find(name); }

std::optional<LinkDoubt> LinkDoubtNamed(const std::string& name) { return kLinkDoubts.Find(name); }

std::vector<std::string> Validate(const DrawingGraph& graph) {
  Violations violations;
  // Before the links, which are looked for at their nodes.
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    CheckOrder(graph, static_cast<NodeId>(id), &violations);
  }
  for (size_t id = 0; id < graph.links.size(); ++id) {
    CheckLink(graph, static_cast<LinkId>(id), &violations);
  }
  CheckFaces(graph, &violations);
  for (size_t id = 0; id < graph.dimensions.size(); ++id) {
    const DrawingDimension& dimension = graph.dimensions[id];
    if (!dimension.from.allFinite() || !dimension.to.allFinite() || !dimension.shift.allFinite()) {
      violations.Add("dimension", static_cast<int>(id), "place not finite");
    }
  }
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    CheckNode(graph, static_cast<NodeId>(id), &violations);
  }
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    const DrawingNode& node = graph.nodes[id];
    if (node.kind == NodeKind::kLoopAnchor && !IsLoopAnchor(graph, node)) {
      violations.Add("node", static_cast<NodeId>(id), "loop anchor without its closed link");
    }
  }
  return violations.Take();
}

NodeKind KindOf(const DrawingGraph& graph, const DrawingNode& node) {
  if (node.Degree() >= 3) return NodeKind::kJunction;
  return IsLoopAnchor(graph, node) ? NodeKind::kLoopAnchor : NodeKind::kEnd;
}

NodeId NumberOfNode(const DrawingGraph& graph, size_t node) {
  const NodeId number = graph.nodes[node].number;
  return number >= 0 ? number : static_cast<NodeId>(node);
}

LinkId NumberOfLink(const DrawingGraph& graph, size_t link) {
  const LinkId number = graph.links[link].number;
  return number >= 0 ? number : static_cast<LinkId>(link);
}

void RebuildIncidence(DrawingGraph* graph) {
  for (DrawingNode& node : graph->nodes) node.incident.clear();
  for (size_t id = 0; id < graph->links.size(); ++id) {
    const DrawingLink& link = graph->links[id];
    graph->nodes[link.node0].incident.push_back({static_cast<LinkId>(id), 0});
    graph->nodes[link.node1].incident.push_back({static_cast<LinkId>(id), 1});
  }
  for (DrawingNode& node : graph->nodes) node.kind = KindOf(*graph, node);
}

void RemoveLinks(const std::vector<uint8_t>& keep, DrawingGraph* graph) {
  std::vector<LinkId> new_link(keep.size(), -1);
  std::vector<NodeId> new_node(graph->nodes.size(), -1);
  DrawingGraph kept;
  kept.regularities = std::move(graph->regularities);
  kept.dimensions = std::move(graph->dimensions);
  for (size_t l = 0; l < keep.size(); ++l) {
    if (!keep[l]) continue;
    new_link[l] = static_cast<LinkId>(kept.links.size());
    kept.links.push_back(std::move(graph->links[l]));
    new_node[kept.links.back().node0] = new_node[kept.links.back().node1] = 0;
  }
  for (size_t n = 0; n < new_node.size(); ++n) {
    if (new_node[n] < 0) continue;
    new_node[n] = static_cast<NodeId>(kept.nodes.size());
    kept.nodes.push_back(std::move(graph->nodes[n]));
    auto& pairs = kept.nodes.back().continuations;
    std::erase_if(pairs, [&](const auto& pair) {
      return new_link[pair.first.link] < 0 || new_link[pair.second.link] < 0;
    });
    for (auto& [first, second] : pairs) {
      first.link = new_link[first.link];
      second.link = new_link[second.link];
    }
  }
  for (DrawingLink& link : kept.links) {
    link.node0 = new_node[link.node0];
    link.node1 = new_node[link.node1];
  }
  RebuildIncidence(&kept);
  for (DrawingFace& face : graph->faces) {
    if (RenameLinks(new_link, &face)) kept.faces.push_back(std::move(face));
  }
  *graph = std::move(kept);
}

void DropFacesOf(const std::vector<uint8_t>& changed, DrawingGraph* graph) {
  const auto is_changed = [&](const FaceEdge& edge) {
    return !edge.IsBridge() && changed[edge.link];
  };
  std::erase_if(graph->faces, [&](const DrawingFace& face) {
    return std::ranges::any_of(
        face.loops, [&](const FaceLoop& loop) { return std::ranges::any_of(loop, is_changed); });
  });
}

}  // namespace limn
