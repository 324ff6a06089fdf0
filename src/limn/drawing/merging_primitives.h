#pragma once

#include <optional>
#include <vector>

#include "limn/drawing/drawing_options.h"
#include "limn/topology/graph_editor.h"
#include "limn/topology/samples.h"

namespace limn {

// Number of applications of each merging primitive (ECCV 2016, section 3; ALGORITHM.md 11.5).
struct MergingCounts {
  int64_t released = 0;        // a run that touches nothing: a link of its own
  int64_t elongated = 0;       // a run that continues a link beyond its free end
  int64_t branched = 0;        // a run that leaves a link from its interior: junction
  int64_t bridged = 0;         // a run between two links
  int64_t rejoined = 0;        // a run with both ends on one link (bubble, or loop closed)
  int64_t multi_attached = 0;  // a run that ends at an existing node
};

// Makes links of runs of samples and attaches runs to links. A vertex is named by the sample it was
// made from and keeps its name in whatever link it ends up. The home of every other sample is the
// vertex that it is merged into. The vertices of a stub that is cut off are merged into the vertex
// that replaces them.
class MergingPrimitives {
 public:
  MergingPrimitives(const SampleSet& samples, const DrawingOptions& options, DrawingGraph* graph);

  // Adds a link whose vertices are made from these samples, in order.
  void AddRun(const std::vector<int>& run, bool closed);

  // Attaches the end of a link that is vertex `tip` at `vertex` of another link: elongates that
  // link if the vertex is near its free end and the directions agree, ends at its node if one is
  // near, and splits it otherwise. At a vertex of the same link, closes a loop if the vertex is
  // near the other end. Does nothing if `tip` is at no end.
  void Attach(int tip, int vertex);

  bool IsVertex(int sample) const { return home_[sample] == sample; }
  void SetHome(int sample, int vertex) { home_[sample] = vertex; }
  // The vertex that a sample is merged into, or is; -1 if there is none yet.
  int HomeOf(int sample) const;
  LinkId LinkOf(int sample) const { return link_of_[HomeOf(sample)]; }

  // Lists the samples, which all have homes, in their vertices. To be called once, in the end.
  void ListSamples();

  MergingCounts& counts() { return counts_; }

 private:
  // The end of its link that a vertex is.
  std::optional<LinkEnd> EndOf(int vertex) const;
  int IndexOf(int vertex) const;
  // Length between an end and a vertex of its link, px.
  double StubPx(const LinkEnd& end, int index) const;
  bool CanElongate(const LinkEnd& target, int index, const LinkEnd& run) const;
  void Elongate(const LinkEnd& target, int index, const LinkEnd& run);
  void SetLink(LinkId link);

  const SampleSet& samples_;
  const DrawingOptions& options_;
  DrawingGraph* graph_;
  GraphEditor editor_;
  std::vector<LinkId> link_of_;  // per vertex, that is, sample it was made from
  std::vector<int> home_;        // per sample: itself if it is a vertex, else one nearer to it
  MergingCounts counts_;
};

}  // namespace limn
