// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/graph_editor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "limn/geometry/polyline.h"
#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// Calls edit(values) for each per-point list of a link.
template <typename Edit>
void ForEachList(DrawingLink* link, Edit&& edit) {
  edit(&link->points_in_world);
  edit(&link->sigma);
  if (!link->vertices.empty()) edit(&link->vertices);
}

void ReverseLists(DrawingLink* link) {
  ForEachList(link, [](auto* values) { std::reverse(values->begin(), values->end()); });
}

template <typename T>
void Unite(const std::vector<T>& more, std::vector<T>* to) {
  std::vector<T> all;
  std::set_union(to->begin(), to->end(), more.begin(), more.end(), std::back_inserter(all));
  *to = std::move(all);
}

void Absorb(const LinkVertex& vertex, LinkVertex* into) {
  into->agreeing_views = std::max(into->agreeing_views, vertex.agreeing_views);
  Unite(vertex.support, &into->support);
  into->samples.insert(into->samples.end(), vertex.samples.begin(), vertex.samples.end());
}

// Drops the last point; the one before takes over its support.
void PopBack(DrawingLink* link) {
  if (!link->vertices.empty()) Absorb(link->vertices.back(), &link->vertices.end()[-2]);
  ForEachList(link, [](auto* values) { values->pop_back(); });
}

// Appends a point with the accuracy of the last one.
void PushBack(const Eigen::Vector3d& position, DrawingLink* link) {
  if (!link->vertices.empty()) link->vertices.push_back(Bare(link->vertices.back()));
  link->sigma.push_back(link->sigma.back());
  link->points_in_world.push_back(position);
}

template <typename T>
void AppendFrom(size_t begin, std::vector<T>* more, std::vector<T>* to) {
  to->insert(to->end(), std::make_move_iterator(more->begin() + static_cast<std::ptrdiff_t>(begin)),
             std::make_move_iterator(more->end()));
}

// Call it when the shape of a link has changed.
void ForgetShape(DrawingLink* link) {
  link->primitive.reset();
  link->regularity.reset();
  link->dense.reset();
  link->tri_angle_deg = -1;
  link->depth_sigma = -1;
  link->curve_px = 0;
}

// The kind of two links together, before they are joined: what is sure over more length. A rod
// remains one only with another. Confidences are means over the length.
void CombineKinds(const DrawingLink& other, DrawingLink* link) {
  const bool are_rods = link->kind == LinkKind::kRod && other.kind == LinkKind::kRod;
  const double length = Length(link->points_in_world);
  const double other_length = Length(other.points_in_world);
  const double whole = length + other_length;
  const double vote = link->kind_confidence * length;
  const double other_vote = other.kind_confidence * other_length;
  const bool is_same = link->kind == other.kind;
  if (other_vote > vote) {
    link->kind = other.kind;
    link->rod_radius = other.rod_radius;
    link->body = other.body;
  }
  link->kind_confidence =
      std::min(1.0, (is_same ? vote + other_vote : std::abs(vote - other_vote)) / whole);
  if (link->kind == LinkKind::kRod && !are_rods) link->kind_confidence = 0;
  if (link->kind_confidence == 0) link->kind = LinkKind::kUnknown;
  if (link->kind != LinkKind::kRod) link->rod_radius = 0;
  if (link->kind != LinkKind::kContour) link->body.reset();
  link->evidence = std::max(link->evidence, other.evidence);  // the unknown is least
  const bool is_known = link->confidence >= 0 && other.confidence >= 0;
  link->confidence =
      is_known ? (link->confidence * length + other.confidence * other_length) / whole : -1;
  const double tentative = link->tentative * length + other.tentative * other_length;
  link->tentative = tentative > whole / 2;
  if (!link->tentative) {
    link->doubt = LinkDoubt::kNone;
  } else if (other_length > length || link->doubt == LinkDoubt::kNone) {
    link->doubt = other.doubt;
  }
}

// Calls edit() with the link oriented so that the end is its last point.
template <typename Edit>
void AtBack(const LinkEnd& end, DrawingLink* link, Edit&& edit) {
  if (end.end == 0) ReverseLists(link);
  edit();
  if (end.end == 0) ReverseLists(link);
}

}  // namespace

std::vector<LinkEnd> GraphEditor::FreeEnds() const {
  std::vector<LinkEnd> ends;
  for (const DrawingNode& node : graph_->nodes) {
    if (node.Degree() == 1) ends.push_back(node.incident.front());
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

NodeId GraphEditor::AddNode(Eigen::Vector3d position) {
  graph_->nodes.emplace_back();
  graph_->nodes.back().position_in_world = position;
  return static_cast<NodeId>(graph_->nodes.size()) - 1;
}

void GraphEditor::UpdateKind(NodeId id) {
  DrawingNode& node = graph_->nodes[id];
  const bool is_loop = node.Degree() == 2 && node.incident[0].link == node.incident[1].link;
  for (const LinkEnd& end : node.incident) {
    DrawingLink& link = graph_->links[end.link];
    link.closed = is_loop && link.node0 == link.node1;
  }
  node.kind = KindOf(*graph_, node);
}

void GraphEditor::Attach(const LinkEnd& end, NodeId id) {
  DrawingLink& link = graph_->links[end.link];
  (end.end == 0 ? link.node0 : link.node1) = id;
  std::vector<LinkEnd>& incident = graph_->nodes[id].incident;
  incident.insert(std::upper_bound(incident.begin(), incident.end(), end), end);
  UpdateKind(id);
}

void GraphEditor::Detach(const LinkEnd& end) {
  const NodeId id = NodeAt(end);
  DrawingNode& node = graph_->nodes[id];
  std::erase(node.incident, end);
  std::erase_if(node.continuations,
                [&](const auto& pair) { return pair.first == end || pair.second == end; });
  DrawingLink& link = graph_->links[end.link];
  (end.end == 0 ? link.node0 : link.node1) = -1;
  link.closed = false;
  UpdateKind(id);
}

void GraphEditor::Rename(NodeId id, const LinkEnd& from, const LinkEnd& to) {
  DrawingNode& node = graph_->nodes[id];
  std::replace(node.incident.begin(), node.incident.end(), from, to);
  std::sort(node.incident.begin(), node.incident.end());
  for (auto& [first, second] : node.continuations) {
    if (first == from) first = to;
    if (second == from) second = to;
  }
}

LinkId GraphEditor::Add(DrawingLink link) {
  const LinkId id = NumLinks();
  const bool returns = link.points_in_world.front() == link.points_in_world.back();
  graph_->links.push_back(std::move(link));
  for (const int end : {0, 1}) {
    DrawingLink& added = graph_->links[id];
    NodeId node = added.NodeAt(end);
    if (node < 0 && end == 1 && returns) node = added.node0;
    Eigen::Vector3d& point =
        end == 0 ? added.points_in_world.front() : added.points_in_world.back();
    if (node < 0) node = AddNode(point);
    point = graph_->nodes[node].position_in_world;
    Attach({id, end}, node);
  }
  return id;
}

void GraphEditor::Remove(LinkId id) {
  Detach({id, 0});
  Detach({id, 1});
  graph_->links[id] = {};
}

// Makes a closed link begin and end at another of its points.
void GraphEditor::RotateTo(LinkId id, int index) {
  DrawingLink& loop = graph_->links[id];
  PopBack(&loop);
  ForEachList(&loop, [&](auto* values) {
    std::rotate(values->begin(), values->begin() + index % static_cast<int>(values->size()),
                values->end());
  });
  graph_->nodes[loop.node0].position_in_world = loop.points_in_world.front();
  Close(id);
  ForgetShape(&loop);
}

NodeId GraphEditor::Split(LinkId id, int index) {
  if (graph_->links[id].closed) {
    RotateTo(id, index);
    return graph_->links[id].node0;
  }
  const NodeId node = AddNode(graph_->links[id].points_in_world[index]);
  ForgetShape(&graph_->links[id]);
  const LinkId second_id = NumLinks();
  graph_->links.push_back(graph_->links[id]);
  DrawingLink& first = graph_->links[id];
  DrawingLink& second = graph_->links.back();
  ForEachList(&first, [&](auto* values) { values->resize(index + 1); });
  ForEachList(&second,
              [&](auto* values) { values->erase(values->begin(), values->begin() + index); });
  if (!second.vertices.empty()) second.vertices.front() = Bare(second.vertices.front());
  Rename(second.node1, {id, 1}, {second_id, 1});
  first.node1 = second.node0 = -1;
  Attach({id, 1}, node);
  Attach({second_id, 0}, node);
  UpdateKind(graph_->links[second_id].node1);
  return node;
}

void GraphEditor::EndAt(const LinkEnd& end, NodeId node) {
  const Eigen::Vector3d place = graph_->nodes[node].position_in_world;
  DropOvershoot(end, place);
  Detach(end);
  DrawingLink& link = graph_->links[end.link];
  AtBack(end, &link, [&] {
    if (link.points_in_world.back() != place) PushBack(place, &link);
  });
  ForgetShape(&link);
  Attach(end, node);
}

void GraphEditor::MoveEnds(NodeId from, NodeId to) {
  for (const LinkEnd& end : std::vector(graph_->nodes[from].incident)) EndAt(end, to);
}

void GraphEditor::Free(const LinkEnd& end) {
  Detach(end);
  Attach(end, AddNode(EndPoint(link(end.link), end.end)));
}

void GraphEditor::CutTo(LinkId id, int begin, int end) {
  DrawingLink& link = graph_->links[id];
  const int size = link.size();
  if (begin == 0 && end == size) return;
  const bool is_cut[2] = {begin > 0 || link.closed, end < size || link.closed};
  ForEachList(&link, [&](auto* values) {
    values->erase(values->begin() + end, values->end());
    values->erase(values->begin(), values->begin() + begin);
  });
  ForgetShape(&link);
  for (const int e : {0, 1}) {
    if (is_cut[e]) Free({id, e});
  }
}

void GraphEditor::DropOvershoot(const LinkEnd& end, Eigen::Vector3d place) {
  DrawingLink& link = graph_->links[end.link];
  const std::vector<Eigen::Vector3d>& points = link.points_in_world;
  const int before = link.size();
  AtBack(end, &link, [&] {
    while (link.size() > 2) {
      const Eigen::Vector3d ahead = points.back() - points.end()[-2];
      if (place == points.back() || (place - points.back()).dot(ahead) > 0) break;
      PopBack(&link);
    }
  });
  if (link.size() == before) return;
  ForgetShape(&link);
  Free(end);
}

// Appends the first point to a link that does not return to it.
void GraphEditor::Close(LinkId id) {
  DrawingLink& link = graph_->links[id];
  link.points_in_world.push_back(link.points_in_world.front());
  link.sigma.push_back(link.sigma.front());
  if (!link.vertices.empty()) link.vertices.push_back(Bare(link.vertices.front()));
}

void GraphEditor::Join(const LinkEnd& a, const LinkEnd& b) {
  ForgetShape(&graph_->links[a.link]);
  if (a.link == b.link) {
    DrawingLink& loop = graph_->links[a.link];
    if (loop.points_in_world.front() == loop.points_in_world.back()) {
      if (!loop.vertices.empty()) {
        Absorb(loop.vertices.back(), &loop.vertices.front());
        loop.vertices.back() = Bare(loop.vertices.front());
      }
    } else {
      Close(a.link);
    }
    Detach({a.link, 1});
    Attach({a.link, 1}, loop.node0);
    graph_->nodes[loop.node0].continuations = {{{a.link, 0}, {a.link, 1}}};
    return;
  }
  const LinkEnd far = {b.link, 1 - b.end};
  const NodeId far_node = NodeAt(far);
  Detach(a);
  Detach(b);
  DrawingLink& first = graph_->links[a.link];
  DrawingLink& second = graph_->links[b.link];
  CombineKinds(second, &first);
  if (b.end == 1) ReverseLists(&second);
  AtBack(a, &first, [&] {
    const bool coincide = first.points_in_world.back() == second.points_in_world.front();
    if (coincide && !first.vertices.empty())
      Absorb(second.vertices.front(), &first.vertices.back());
    AppendFrom(coincide, &second.points_in_world, &first.points_in_world);
    AppendFrom(coincide, &second.sigma, &first.sigma);
    if (!second.vertices.empty()) AppendFrom(coincide, &second.vertices, &first.vertices);
  });
  first.members.insert(first.members.end(), second.members.begin(), second.members.end());
  Unite(second.supporting_views, &first.supporting_views);
  first.residual_px = std::max(first.residual_px, second.residual_px);
  second = {};
  (a.end == 0 ? first.node0 : first.node1) = far_node;
  Rename(far_node, far, a);
  UpdateKind(far_node);
  moved_[far] = a;
}

LinkEnd GraphEditor::CurrentEnd(LinkEnd end) const {
  for (auto it = moved_.find(end); it != moved_.end(); it = moved_.find(end)) end = it->second;
  return end;
}

void GraphEditor::Unify(LinkId id, LinkId other) {
  DrawingLink& link = graph_->links[id];
  const DrawingLink& same = graph_->links[other];
  CombineKinds(same, &link);
  link.members.insert(link.members.end(), same.members.begin(), same.members.end());
  Unite(same.supporting_views, &link.supporting_views);
  Remove(other);
}

int GraphEditor::InsertPoint(LinkId id, int segment, double t) {
  DrawingLink& link = graph_->links[id];
  const int at = segment + 1;
  const Eigen::Vector3d point =
      (1 - t) * link.points_in_world[segment] + t * link.points_in_world[at];
  const double sigma = std::max(link.sigma[segment], link.sigma[at]);
  link.points_in_world.insert(link.points_in_world.begin() + at, point);
  link.sigma.insert(link.sigma.begin() + at, sigma);
  if (!link.vertices.empty()) {
    link.vertices.insert(link.vertices.begin() + at, Bare(link.vertices[segment]));
  }
  return at;
}

void GraphEditor::MoveNode(NodeId id, const Eigen::Vector3d& position) {
  graph_->nodes[id].position_in_world = position;
  for (const LinkEnd& end : graph_->nodes[id].incident) {
    DrawingLink& link = graph_->links[end.link];
    (end.end == 0 ? link.points_in_world.front() : link.points_in_world.back()) = position;
    ForgetShape(&link);
  }
}

void GraphEditor::MovePoint(LinkId id, int index, const Eigen::Vector3d& position) {
  graph_->links[id].points_in_world[index] = position;
  ForgetShape(&graph_->links[id]);
}

void GraphEditor::SetContinuations(NodeId id, std::vector<std::pair<LinkEnd, LinkEnd>> pairs) {
  graph_->nodes[id].continuations = std::move(pairs);
}

void GraphEditor::SetKind(LinkId id, LinkKind kind) {
  graph_->links[id].kind = kind;
  graph_->links[id].kind_confidence = kind == LinkKind::kUnknown ? 0 : 1;
  if (kind != LinkKind::kRod) graph_->links[id].rod_radius = 0;
  if (kind != LinkKind::kContour) graph_->links[id].body.reset();
}

void GraphEditor::MakeFirm(LinkId id) {
  graph_->links[id].tentative = false;
  graph_->links[id].doubt = LinkDoubt::kNone;
}

void GraphEditor::Keep(const std::vector<uint8_t>& keep) {
  for (size_t l = 0; l < keep.size(); ++l) {
    if (!keep[l] && IsLink(static_cast<LinkId>(l))) Remove(static_cast<LinkId>(l));
  }
  Compact();
}

void GraphEditor::Compact() {
  std::vector<uint8_t> keep;
  for (LinkId id = 0; id < NumLinks(); ++id) keep.push_back(IsLink(id));
  RemoveLinks(keep, graph_);
  moved_.clear();
}

}  // namespace limn
