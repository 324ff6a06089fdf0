#pragma once

#include <vector>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/topology/graph_editor.h"

namespace limn {

// How many times each merging primitive was applied (ECCV 2016, section 3).
struct MergingCounts {
  int64_t released = 0;        // a run that touches nothing: a link of its own
  int64_t elongated = 0;       // a run that continues a link beyond its free end
  int64_t branched = 0;        // a run that leaves a link from its interior: junction
  int64_t bridged = 0;         // a run between two links
  int64_t rejoined = 0;        // a run with both ends on one link (bubble, or loop closed)
  int64_t multi_attached = 0;  // a run that ends at an existing node
};

// Links made of runs of samples, and the primitives that attach runs to links. The sample that a
// vertex of a link is made from names the vertex, wherever it is moved to; where a stub is cut off
// its vertices are replaced by another and forward to it.
class MergingPrimitives {
 public:
  MergingPrimitives(const SampleSet& samples, const DrawingOptions& options, DrawingGraph* graph);

  // A new link whose vertices are made from these samples, in order.
  LinkId AddRun(const std::vector<int>& run, bool closed);

  // Join end `end` of link `link` to the graph at `vertex`: elongates that link if the vertex is
  // near its free end and the directions agree, ends at its node if one is near, and otherwise
  // splits it there.
  void Attach(LinkId link, int end, int vertex);

  // The vertex that stands for a vertex now.
  int Resolve(int vertex) const;
  LinkId LinkOf(int vertex) const { return link_of_[Resolve(vertex)]; }
  // Which end of its link a vertex is, -1 if neither.
  int EndOf(int vertex) const;

  // Merge every sample into the vertex that `home` names, where that is not -1.
  void MergeSamples(const std::vector<int>& home);

  MergingCounts& counts() { return counts_; }

 private:
  struct Place {
    LinkId link = -1;
    int index = -1;
  };
  int IdOf(const SketchSample& sample) const {
    return samples_.curve_begin[sample.curve] + sample.sample;
  }
  SketchSample SampleOf(int id) const {
    const int curve = samples_.curve_of[id];
    return {curve, id - samples_.curve_begin[curve]};
  }
  bool IsMadeFrom(const LinkVertex& vertex, int id) const;
  int IndexOf(int vertex) const;
  // Length of what is beyond a vertex on the way to an end of its link, px.
  double StubPx(const Place& at, int end) const;
  bool CanElongate(const Place& at, int target_end, const LinkEnd& run) const;
  void Elongate(const Place& at, int target_end, const LinkEnd& run);
  void SetLink(LinkId link);

  const SampleSet& samples_;
  const DrawingOptions& options_;
  DrawingGraph* graph_;
  GraphEditor editor_;
  std::vector<LinkId> link_of_;  // per sample that a vertex is made from
  mutable std::vector<int> forward_;
  MergingCounts counts_;
};

}  // namespace limn
