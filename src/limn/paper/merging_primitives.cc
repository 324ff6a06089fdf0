// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/merging_primitives.h"

#include <algorithm>
#include <array>
#include <limits>

#include "limn/topology/link_geometry.h"

namespace limn {
namespace {

// Cosine of the largest turn from a link into a run that elongates it.
constexpr double kMinElongationCosine = 0.5;

std::array<LinkEnd, 2> EndsOf(LinkId link) { return {{{link, 0}, {link, 1}}}; }

}  // namespace

MergingPrimitives::MergingPrimitives(const SampleSet& samples, const PaperOptions& options,
                                     DrawingGraph* graph)
    : samples_(samples),
      options_(options),
      graph_(graph),
      editor_(graph),
      link_of_(samples.NumSamples(), -1),
      home_(samples.NumSamples(), -1) {}

int MergingPrimitives::HomeOf(int sample) const {
  while (sample >= 0 && !IsVertex(sample)) sample = home_[sample];
  return sample;
}

MergingPrimitives::Place MergingPrimitives::PlaceOf(int sample) const {
  const int vertex = HomeOf(sample);
  const LinkId link = link_of_[vertex];
  const std::vector<LinkVertex>& vertices = editor_.link(link).vertices;
  const auto found = std::ranges::find_if(vertices, [&](const LinkVertex& of_link) {
    return std::ranges::count(of_link.samples, samples_.NameOf(vertex)) > 0;
  });
  return {link, static_cast<int>(found - vertices.begin())};
}

std::optional<LinkEnd> MergingPrimitives::FreeEndOf(int vertex) const {
  const Place place = PlaceOf(vertex);
  for (const LinkEnd& end : EndsOf(place.link)) {
    const int last = editor_.link(place.link).size() - 1;
    if (place.index == (end.end == 0 ? 0 : last) && editor_.IsFree(end)) return end;
  }
  return std::nullopt;
}

void MergingPrimitives::SetLink(LinkId link) {
  for (const LinkVertex& vertex : editor_.link(link).vertices) {
    for (const SketchSample& sample : vertex.samples) link_of_[samples_.IdOf(sample)] = link;
  }
}

void MergingPrimitives::AddRun(const std::vector<int>& run, bool closed) {
  DrawingLink link;
  for (const int id : run) {
    home_[id] = id;
    link.points_in_world.push_back(samples_.position[id]);
    link.vertices.push_back(
        {samples_.information[id], samples_.footprint[id], 0, {}, {samples_.NameOf(id)}});
  }
  link.sigma.assign(link.points_in_world.size(), 0);
  const LinkId id = editor_.Add(std::move(link));
  if (closed) editor_.Join({id, 0}, {id, 1});
  SetLink(id);
}

double MergingPrimitives::StubPx(const LinkEnd& end, int index) const {
  const DrawingLink& link = editor_.link(end.link);
  return end.end == 0 ? ArcPx(link, 0, index) : ArcPx(link, index, link.size() - 1);
}

// Returns whether the target is a free end, the stub between it and the point short and
// dispensable, and the run continues it.
bool MergingPrimitives::CanElongate(const LinkEnd& target, int index, const LinkEnd& run,
                                    int kept) const {
  if (target == run || !editor_.IsFree(target)) return false;
  const double stub_px = StubPx(target, index);
  if (stub_px >= options_.min_branch_length_px) return false;
  if (kept >= 0) {
    const Place needed = PlaceOf(kept);
    if (needed.link == target.link && StubPx(target, needed.index) <= stub_px) return false;
  }
  const LinkTip tip = TipOf(editor_.link(target.link), target.end);
  return tip.outward.dot(TipOf(editor_.link(run.link), run.end).outward) < -kMinElongationCosine;
}

// Cuts the stub off and joins what is left to the run. The samples of the stub are merged into the
// nearest vertices.
void MergingPrimitives::ReplaceStub(const LinkEnd& target, int index, const LinkEnd& run) {
  const DrawingLink& link = editor_.link(target.link);
  // A link needs two points.
  const int begin = target.end == 0 ? std::min(index, link.size() - 2) : 0;
  const int end = target.end == 0 ? link.size() : std::max(index + 1, 2);
  std::vector<int> of_stub;
  for (int k = 0; k < link.size(); ++k) {
    if (k >= begin && k < end) continue;
    for (const SketchSample& sample : link.vertices[k].samples) {
      of_stub.push_back(samples_.IdOf(sample));
    }
  }
  editor_.CutTo(target.link, begin, end);
  editor_.Join(target, run);
  SetLink(target.link);
  for (const int sample : of_stub) home_[sample] = NearestVertex(editor_.link(target.link), sample);
}

int MergingPrimitives::NearestVertex(const DrawingLink& link, int sample) const {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < link.size(); ++k) {
    if (link.vertices[k].samples.empty()) continue;
    const double squared = (link.points_in_world[k] - samples_.position[sample]).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    nearest = samples_.IdOf(link.vertices[k].samples.front());
  }
  return nearest;
}

bool MergingPrimitives::Elongate(const Place& place, const LinkEnd& run, int kept) {
  for (const LinkEnd& end : EndsOf(place.link)) {
    if (!CanElongate(end, place.index, run, kept)) continue;
    if (place.link != run.link) ++counts_.elongated;
    ReplaceStub(end, place.index, run);
    return true;
  }
  return false;
}

NodeId MergingPrimitives::NodeFor(const Place& place, const LinkEnd& run, bool* is_new) {
  *is_new = false;
  for (const LinkEnd& end : EndsOf(place.link)) {
    if (end == run || editor_.link(place.link).closed) continue;
    if (StubPx(end, place.index) <= options_.junction_distance_px) return editor_.NodeAt(end);
  }
  *is_new = true;
  const LinkId second = editor_.NumLinks();
  const NodeId node = editor_.Split(place.link, place.index);
  if (second < editor_.NumLinks()) SetLink(second);
  return node;
}

// Whether a link between two nodes is so short that it would vanish if they became one.
bool MergingPrimitives::AreJoined(NodeId a, NodeId b) const {
  return std::ranges::any_of(editor_.node(a).incident, [&](const LinkEnd& end) {
    return editor_.NodeAt({end.link, 1 - end.end}) == b &&
           LengthPx(editor_.link(end.link)) < options_.min_branch_length_px;
  });
}

// Whether the link of a place ends at the node, near the place.
bool MergingPrimitives::EndsAt(const Place& place, NodeId node) const {
  const auto is_near = [&](const LinkEnd& end) {
    return editor_.NodeAt(end) == node && StubPx(end, place.index) < options_.min_branch_length_px;
  };
  return std::ranges::any_of(EndsOf(place.link), is_near);
}

bool MergingPrimitives::Attach(int tip, const std::vector<int>& touched, int kept) {
  tip = HomeOf(tip);
  const std::optional<LinkEnd> run = FreeEndOf(tip);
  if (!run) return false;
  std::vector<int> reached;
  std::ranges::copy_if(touched, std::back_inserter(reached), [&](int vertex) {
    const Place place = PlaceOf(vertex);
    return place.link != run->link || StubPx(*run, place.index) > options_.min_branch_length_px;
  });
  if (reached.empty()) return false;
  if (reached.size() == 1 && Elongate(PlaceOf(reached.front()), *run, kept)) return true;
  std::optional<NodeId> node;
  bool is_branch = reached.size() == 1;
  for (const int vertex : reached) {
    const Place place = PlaceOf(vertex);
    if (node && EndsAt(place, *node)) continue;
    bool is_new = false;
    const NodeId at = NodeFor(place, *FreeEndOf(tip), &is_new);
    is_branch &= is_new;
    if (!node) {
      node = at;
    } else if (at != *node && !AreJoined(at, *node)) {
      editor_.MoveEnds(at, *node);
    }
  }
  editor_.EndAt(*FreeEndOf(tip), *node);
  ++(is_branch ? counts_.branched : counts_.multi_attached);
  return true;
}

void MergingPrimitives::ListSamples() {
  editor_.Compact();
  std::vector<LinkVertex*> vertex_of(samples_.NumSamples());
  for (DrawingLink& link : graph_->links) {
    for (LinkVertex& vertex : link.vertices) {
      for (const SketchSample& sample : vertex.samples) vertex_of[samples_.IdOf(sample)] = &vertex;
    }
  }
  for (int s = 0; s < samples_.NumSamples(); ++s) {
    LinkVertex* vertex = vertex_of[HomeOf(s)];
    if (vertex_of[s] != vertex) vertex->samples.push_back(samples_.NameOf(s));
  }
}

}  // namespace limn
