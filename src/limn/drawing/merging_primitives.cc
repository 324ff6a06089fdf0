#include "limn/drawing/merging_primitives.h"

#include <algorithm>
#include <numeric>

#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// Cosine of the largest turn from a link into a run that elongates it.
constexpr double kMinElongationCosine = 0.5;

}  // namespace

MergingPrimitives::MergingPrimitives(const SampleSet& samples, const DrawingOptions& options,
                                     DrawingGraph* graph)
    : samples_(samples),
      options_(options),
      graph_(graph),
      editor_(graph),
      link_of_(samples.NumSamples(), -1),
      forward_(samples.NumSamples()) {
  std::iota(forward_.begin(), forward_.end(), 0);
}

int MergingPrimitives::Resolve(int vertex) const {
  while (forward_[vertex] != vertex) vertex = forward_[vertex] = forward_[forward_[vertex]];
  return vertex;
}

bool MergingPrimitives::IsMadeFrom(const LinkVertex& vertex, int id) const {
  return std::any_of(vertex.samples.begin(), vertex.samples.end(),
                     [&](const SketchSample& sample) { return IdOf(sample) == id; });
}

int MergingPrimitives::IndexOf(int vertex) const {
  const std::vector<LinkVertex>& vertices = editor_.link(link_of_[vertex]).vertices;
  const auto found = std::find_if(vertices.begin(), vertices.end(), [&](const LinkVertex& of_link) {
    return IsMadeFrom(of_link, vertex);
  });
  return static_cast<int>(found - vertices.begin());
}

int MergingPrimitives::EndOf(int vertex) const {
  const DrawingLink& link = editor_.link(LinkOf(vertex));
  if (IsMadeFrom(link.vertices.back(), vertex)) return 1;
  return !link.closed && IsMadeFrom(link.vertices.front(), vertex) ? 0 : -1;
}

void MergingPrimitives::SetLink(LinkId link) {
  for (const LinkVertex& vertex : editor_.link(link).vertices) {
    for (const SketchSample& sample : vertex.samples) link_of_[IdOf(sample)] = link;
  }
}

LinkId MergingPrimitives::AddRun(const std::vector<int>& run, bool closed) {
  DrawingLink link;
  for (const int id : run) {
    link.points_in_world.push_back(samples_.position[id]);
    link.vertices.push_back(
        {samples_.information[id], samples_.footprint[id], 0, {}, {SampleOf(id)}});
  }
  if (closed) {
    link.points_in_world.push_back(link.points_in_world.front());
    link.vertices.push_back(link.vertices.front());
    link.vertices.back().samples.clear();
  }
  link.sigma.assign(link.points_in_world.size(), 0);
  const LinkId id = editor_.Add(std::move(link));
  SetLink(id);
  return id;
}

double MergingPrimitives::StubPx(const Place& at, int end) const {
  const DrawingLink& link = editor_.link(at.link);
  return end == 0 ? ArcPx(link, 0, at.index) : ArcPx(link, at.index, link.size() - 1);
}

// Returns whether the end is free, the stub between it and the vertex short, and the run continues
// it.
bool MergingPrimitives::CanElongate(const Place& at, int target_end, const LinkEnd& run) const {
  const DrawingLink& target = editor_.link(at.link);
  if (target.closed || !editor_.IsFree({at.link, target_end})) return false;
  if (StubPx(at, target_end) >= options_.min_branch_length_px) return false;
  return TipOf(target, target_end).outward.dot(TipOf(editor_.link(run.link), run.end).outward) <
         -kMinElongationCosine;
}

// Replaces the stub by the run.
void MergingPrimitives::Elongate(const Place& at, int target_end, const LinkEnd& run) {
  const DrawingLink& target = editor_.link(at.link);
  const std::vector<LinkVertex>& of_run = editor_.link(run.link).vertices;
  const LinkVertex& first = run.end == 0 ? of_run.front() : of_run.back();
  // A link needs two points.
  const int begin = target_end == 0 ? std::min(at.index, target.size() - 2) : 0;
  const int end = target_end == 0 ? target.size() : std::max(at.index + 1, 2);
  for (int k = 0; k < target.size(); ++k) {
    if (k >= begin && k < end) continue;
    for (const SketchSample& sample : target.vertices[k].samples) {
      forward_[IdOf(sample)] = IdOf(first.samples.front());
    }
  }
  editor_.CutTo(at.link, begin, end);
  editor_.Join({at.link, target_end}, run);
  SetLink(at.link);
}

void MergingPrimitives::Attach(LinkId link, int end, int vertex) {
  vertex = Resolve(vertex);
  const Place at = {link_of_[vertex], IndexOf(vertex)};
  const DrawingLink& target = editor_.link(at.link);
  if (at.link == link) {
    // The run meets its own link: it closes a loop if it meets its other end.
    const bool is_free = editor_.IsFree({link, 0}) && editor_.IsFree({link, 1});
    if (!is_free || StubPx(at, 1 - end) >= options_.min_branch_length_px) return;
    editor_.Join({link, 0}, {link, 1});
    ++counts_.rejoined;
    return;
  }
  for (const int target_end : {0, 1}) {
    if (!CanElongate(at, target_end, {link, end})) continue;
    Elongate(at, target_end, {link, end});
    ++counts_.elongated;
    return;
  }
  for (const int target_end : {0, 1}) {
    if (target.closed || StubPx(at, target_end) > options_.junction_distance_px) continue;
    editor_.EndAt({link, end}, editor_.NodeAt({at.link, target_end}));
    ++counts_.multi_attached;
    return;
  }
  const LinkId second = editor_.NumLinks();
  const NodeId node = editor_.Split(at.link, at.index);
  if (second < editor_.NumLinks()) SetLink(second);
  editor_.EndAt({link, end}, node);
  ++counts_.branched;
}

void MergingPrimitives::MergeSamples(const std::vector<int>& home) {
  editor_.Compact();
  std::vector<Place> place_of(samples_.NumSamples());
  for (LinkId id = 0; id < editor_.NumLinks(); ++id) {
    for (int k = 0; k < editor_.link(id).size(); ++k) {
      for (const SketchSample& sample : editor_.link(id).vertices[k].samples) {
        place_of[IdOf(sample)] = {id, k};
      }
    }
  }
  for (int s = 0; s < static_cast<int>(home.size()); ++s) {
    if (home[s] < 0) continue;
    const Place& place = place_of[Resolve(home[s])];
    LinkVertex& vertex = graph_->links[place.link].vertices[place.index];
    if (!IsMadeFrom(vertex, s)) vertex.samples.push_back(SampleOf(s));
  }
}

}  // namespace limn
