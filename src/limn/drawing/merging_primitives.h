#pragma once

#include <vector>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"
#include "limn/topology/graph_editor.h"

namespace limn {

// Number of applications of each merging primitive (ECCV 2016, section 3; ALGORITHM.md 11.2).
struct MergingCounts {
  int64_t released = 0;        // a run that touches nothing: a link of its own
  int64_t elongated = 0;       // a run that continues a link beyond its free end
  int64_t branched = 0;        // a run that leaves a link from its interior: junction
  int64_t bridged = 0;         // a run between two links
  int64_t rejoined = 0;        // a run with both ends on one link (bubble, or loop closed)
  int64_t multi_attached = 0;  // a run that ends at an existing node
};

// Makes links of runs of samples and attaches runs to links. A vertex is named by the sample it was
// made from and keeps its name in whatever link it ends up. The vertices of a stub that is cut off
// forward to the vertex that replaces them.
class MergingPrimitives {
 public:
  MergingPrimitives(const SampleSet& samples, const DrawingOptions& options, DrawingGraph* graph);

  // Adds a link whose vertices are made from these samples, in order.
  LinkId AddRun(const std::vector<int>& run, bool closed);

  // Attaches end `end` of link `link` at `vertex` of another link: elongates that link if the
  // vertex is near its free end and the directions agree, ends at its node if one is near, and
  // splits it otherwise. At a vertex of the same link, closes a loop if the vertex is near the
  // other end.
  void Attach(LinkId link, int end, int vertex);

  // The vertex that now stands for a vertex.
  int Resolve(int vertex) const;
  LinkId LinkOf(int vertex) const { return link_of_[Resolve(vertex)]; }
  // The end of its link that a vertex is; -1 if neither.
  int EndOf(int vertex) const;

  // Merges every sample into its vertex `home`, unless that is -1.
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
  // Length between a vertex and an end of its link, px.
  double StubPx(const Place& at, int end) const;
  bool CanElongate(const Place& at, int target_end, const LinkEnd& run) const;
  void Elongate(const Place& at, int target_end, const LinkEnd& run);
  void SetLink(LinkId link);

  const SampleSet& samples_;
  const DrawingOptions& options_;
  DrawingGraph* graph_;
  GraphEditor editor_;
  std::vector<LinkId> link_of_;  // per vertex, that is, sample it was made from
  mutable std::vector<int> forward_;
  MergingCounts counts_;
};

}  // namespace limn
