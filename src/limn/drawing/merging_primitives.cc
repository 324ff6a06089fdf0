#include "limn/drawing/merging_primitives.h"

#include <algorithm>

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
      home_(samples.NumSamples(), -1) {}

int MergingPrimitives::HomeOf(int sample) const {
  while (sample >= 0 && !IsVertex(sample)) sample = home_[sample];
  return sample;
}

int MergingPrimitives::IndexOf(int vertex) const {
  const std::vector<LinkVertex>& vertices = editor_.link(link_of_[vertex]).vertices;
  const auto found = std::ranges::find_if(vertices, [&](const LinkVertex& of_link) {
    return std::ranges::count(of_link.samples, samples_.NameOf(vertex)) > 0;
  });
  return static_cast<int>(found - vertices.begin());
}

std::optional<LinkEnd> MergingPrimitives::EndOf(int vertex) const {
  const LinkId id = link_of_[vertex];
  const DrawingLink& link = editor_.link(id);
  const int index = IndexOf(vertex);
  if (index == link.size() - 1) return LinkEnd{id, 1};
  if (index == 0 && !link.closed) return LinkEnd{id, 0};
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

// Returns whether the target is a free end, the stub between it and the vertex short, and the run
// continues it.
bool MergingPrimitives::CanElongate(const LinkEnd& target, int index, const LinkEnd& run) const {
  if (editor_.link(target.link).closed || !editor_.IsFree(target)) return false;
  if (StubPx(target, index) >= options_.min_branch_length_px) return false;
  const LinkTip tip = TipOf(editor_.link(target.link), target.end);
  return tip.outward.dot(TipOf(editor_.link(run.link), run.end).outward) < -kMinElongationCosine;
}

// Replaces the stub by the run.
void MergingPrimitives::Elongate(const LinkEnd& target, int index, const LinkEnd& run) {
  const DrawingLink& link = editor_.link(target.link);
  const std::vector<LinkVertex>& of_run = editor_.link(run.link).vertices;
  const LinkVertex& first = run.end == 0 ? of_run.front() : of_run.back();
  // A link needs two points.
  const int begin = target.end == 0 ? std::min(index, link.size() - 2) : 0;
  const int end = target.end == 0 ? link.size() : std::max(index + 1, 2);
  for (int k = 0; k < link.size(); ++k) {
    if (k >= begin && k < end) continue;
    for (const SketchSample& sample : link.vertices[k].samples) {
      home_[samples_.IdOf(sample)] = samples_.IdOf(first.samples.front());
    }
  }
  editor_.CutTo(target.link, begin, end);
  editor_.Join(target, run);
  SetLink(target.link);
}

void MergingPrimitives::Attach(int tip, int vertex) {
  const std::optional<LinkEnd> run = EndOf(HomeOf(tip));
  if (!run) return;
  vertex = HomeOf(vertex);
  const LinkId target = link_of_[vertex];
  const int index = IndexOf(vertex);
  if (target == run->link) {
    // The run meets its own link: it closes a loop if it meets its other end.
    const LinkEnd other = {target, 1 - run->end};
    if (!editor_.IsFree(*run) || !editor_.IsFree(other)) return;
    if (StubPx(other, index) < options_.min_branch_length_px)
      editor_.Join({target, 0}, {target, 1});
    return;
  }
  const LinkEnd ends[] = {{target, 0}, {target, 1}};
  for (const LinkEnd& end : ends) {
    if (!CanElongate(end, index, *run)) continue;
    Elongate(end, index, *run);
    ++counts_.elongated;
    return;
  }
  for (const LinkEnd& end : ends) {
    if (editor_.link(target).closed) continue;
    if (StubPx(end, index) > options_.junction_distance_px) continue;
    editor_.EndAt(*run, editor_.NodeAt(end));
    ++counts_.multi_attached;
    return;
  }
  const LinkId second = editor_.NumLinks();
  const NodeId node = editor_.Split(target, index);
  if (second < editor_.NumLinks()) SetLink(second);
  editor_.EndAt(*run, node);
  ++counts_.branched;
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
