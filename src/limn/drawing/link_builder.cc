#include "limn/drawing/link_builder.h"

#include <algorithm>

namespace limn {
namespace {

// Vertices back from an end that its direction is measured over.
constexpr int kDirectionVertices = 5;

}  // namespace

int LinkBuilder::Resolve(int vertex) const {
  while (forward_[vertex] != vertex) vertex = forward_[vertex] = forward_[forward_[vertex]];
  return vertex;
}

int LinkBuilder::AddLink(const std::vector<int>& run, bool closed) {
  const int id = static_cast<int>(links_.size());
  Link link;
  link.closed = closed;
  for (const int sample : run) {
    const int vertex = num_vertices();
    sample_of_.push_back(sample);
    link_of_.push_back(id);
    forward_.push_back(vertex);
    link.vertices.push_back(vertex);
  }
  links_.push_back(std::move(link));
  return id;
}

int LinkBuilder::CopyVertex(int vertex, int link) {
  const int copy = num_vertices();
  sample_of_.push_back(sample_of_[vertex]);
  link_of_.push_back(link);
  forward_.push_back(copy);
  return copy;
}

int LinkBuilder::IndexOf(int vertex) const {
  const auto& vertices = links_[link_of_[vertex]].vertices;
  return static_cast<int>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
}

double LinkBuilder::ArcPx(const Link& link, int from, int to) const {
  double arc = 0;
  for (int i = from; i < to; ++i) {
    arc += (Position(link.vertices[i + 1]) - Position(link.vertices[i])).norm() /
           samples_.footprint[sample_of_[link.vertices[i]]];
  }
  return arc;
}

Eigen::Vector3d LinkBuilder::OutwardDirection(const Link& link, int end) const {
  const int last = static_cast<int>(link.vertices.size()) - 1;
  const int tip = end == 0 ? 0 : last;
  const int back =
      end == 0 ? std::min(kDirectionVertices, last) : std::max(last - kDirectionVertices, 0);
  const Eigen::Vector3d chord = Position(link.vertices[tip]) - Position(link.vertices[back]);
  return chord.norm() > 0 ? Eigen::Vector3d(chord.normalized()) : Eigen::Vector3d::Zero();
}

// The stub between the attachment and the end is short, the end is free, and the run leads on.
bool LinkBuilder::CanElongate(int target, int target_end, int index, int link, int end) const {
  const Link& to = links_[target];
  if (to.closed || to.node[target_end] >= 0) return false;
  const int last = static_cast<int>(to.vertices.size()) - 1;
  const double stub = target_end == 0 ? ArcPx(to, 0, index) : ArcPx(to, index, last);
  if (stub >= options_.min_branch_length_px) return false;
  const Eigen::Vector3d run_outward = OutwardDirection(links_[link], end);
  return OutwardDirection(to, target_end).dot(run_outward) < -0.5;
}

// Replace the stub of `target` beyond `index` by the run; the run's link dissolves into the target.
int LinkBuilder::Elongate(int target, int target_end, int index, int link, int end) {
  std::vector<int> run = links_[link].vertices;
  const int far_node = links_[link].node[1 - end];
  if (end == 1) std::reverse(run.begin(), run.end());  // now begins at the attachment
  links_[link].alive = false;
  links_[link].vertices.clear();
  Link& to = links_[target];
  if (target_end == 0) std::reverse(to.vertices.begin(), to.vertices.end());
  const int keep = target_end == 0 ? static_cast<int>(to.vertices.size()) - 1 - index : index;
  for (size_t i = keep + 1; i < to.vertices.size(); ++i) {
    forward_[to.vertices[i]] = run.front();
  }
  to.vertices.resize(keep + 1);
  for (const int vertex : run) {
    link_of_[vertex] = target;
    to.vertices.push_back(vertex);
  }
  if (target_end == 0) std::reverse(to.vertices.begin(), to.vertices.end());
  to.node[target_end] = far_node;
  return target;
}

// Cut a link at a vertex, which both parts keep (the second as a copy). Returns the new node.
int LinkBuilder::SplitAt(int link, int index) {
  const int node = num_nodes_++;
  if (links_[link].closed) {
    // A loop with a junction: begins and ends there.
    Link& loop = links_[link];
    std::rotate(loop.vertices.begin(), loop.vertices.begin() + index, loop.vertices.end());
    const int copy = CopyVertex(loop.vertices.front(), link);
    links_[link].vertices.push_back(copy);
    links_[link].closed = false;
    links_[link].node[0] = links_[link].node[1] = node;
    return node;
  }
  const int id = static_cast<int>(links_.size());
  links_.emplace_back();
  Link& first = links_[link];
  Link& second = links_[id];
  second.vertices.assign(first.vertices.begin() + index + 1, first.vertices.end());
  for (const int vertex : second.vertices) link_of_[vertex] = id;
  const int cut = first.vertices[index];
  first.vertices.resize(index + 1);
  second.vertices.insert(second.vertices.begin(), CopyVertex(cut, id));
  second.node[0] = node;
  second.node[1] = first.node[1];
  first.node[1] = node;
  return node;
}

// End a link at a node, with a copy of the vertex that stands there.
void LinkBuilder::EndAt(int link, int end, int node, int vertex) {
  const int copy = CopyVertex(vertex, link);
  Link& of = links_[link];
  of.node[end] = node;
  of.vertices.insert(end == 0 ? of.vertices.begin() : of.vertices.end(), copy);
}

int LinkBuilder::Attach(int link, int end, int vertex) {
  vertex = Resolve(vertex);
  const int target = link_of_[vertex];
  const int index = IndexOf(vertex);
  if (target == link) {
    // The run's own link: a loop closes if its other end is what it meets.
    Link& loop = links_[link];
    const int last = static_cast<int>(loop.vertices.size()) - 1;
    const int other_end = 1 - end;
    if (loop.node[0] < 0 && loop.node[1] < 0 &&
        (other_end == 0 ? ArcPx(loop, 0, index) : ArcPx(loop, index, last)) <
            options_.min_branch_length_px) {
      loop.closed = true;
      ++counts_.rejoined;
    }
    return link;
  }
  for (const int target_end : {0, 1}) {
    if (CanElongate(target, target_end, index, link, end)) {
      ++counts_.elongated;
      return Elongate(target, target_end, index, link, end);
    }
  }
  const int last = static_cast<int>(links_[target].vertices.size()) - 1;
  for (const int target_end : {0, 1}) {
    if (links_[target].closed) break;
    const double stub =
        target_end == 0 ? ArcPx(links_[target], 0, index) : ArcPx(links_[target], index, last);
    if (stub > options_.junction_distance_px) continue;
    if (links_[target].node[target_end] < 0) links_[target].node[target_end] = num_nodes_++;
    ++counts_.multi_attached;
    const int tip =
        target_end == 0 ? links_[target].vertices.front() : links_[target].vertices.back();
    EndAt(link, end, links_[target].node[target_end], tip);
    return link;
  }
  ++counts_.branched;
  EndAt(link, end, SplitAt(target, index), vertex);
  return link;
}

}  // namespace limn
