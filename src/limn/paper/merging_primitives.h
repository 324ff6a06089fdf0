// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/drawing/samples.h"
#include "limn/paper/paper_options.h"
#include "limn/topology/graph_editor.h"

namespace limn {

// Number of applications of each merging primitive (ECCV 2016, section 3;
// algorithm/paper.md#merging-primitives).
struct MergingCounts {
  int64_t released = 0;   // a run that touches nothing: a link of its own
  int64_t elongated = 0;  // a run that continues a link beyond its free end
  int64_t branched = 0;   // a run that leaves a link from its interior: junction
  int64_t bridged = 0;    // a run between two links
  int64_t rejoined = 0;   // a run with both ends on one link (bubble), or one that meets itself
  int64_t multi_attached = 0;  // a run that ends at an existing node, or at several links at once
};

// Makes links of runs of samples and attaches runs to links. A vertex is named by the sample it was
// made from and keeps its name in whatever link it ends up. The home of every other sample is the
// vertex that it is merged into. The vertices of a stub that is cut off are merged into the vertex
// that replaces them.
class MergingPrimitives {
 public:
  MergingPrimitives(const SampleSet& samples, const PaperOptions& options, DrawingGraph* graph);

  // Adds a link whose vertices are made from these samples, in order.
  void AddRun(const std::vector<int>& run, bool closed);

  // Attaches the free end of a link that is vertex `tip` at these vertices. At one vertex near the
  // free end of its link, the run elongates that link in place of the stub beyond the vertex if the
  // directions agree and the stub does not have the vertex `kept` (-1: none), where the run's other
  // end belongs. Else the run ends at a node: that of the link's end if it is near, or one that
  // splits the link. The nodes of several links become one. The vertices may be of the run's own
  // link: a loop, closed without a stub where the run reaches its other end. Returns false, and
  // does nothing, if `tip` is at no free end, or all vertices are near it along its own link.
  bool Attach(int tip, const std::vector<int>& touched, int kept);

  // Whether a sample is a vertex at a free end of its link.
  bool IsFreeEnd(int sample) const { return IsVertex(sample) && FreeEndOf(sample).has_value(); }

  bool IsVertex(int sample) const { return home_[sample] == sample; }
  void SetHome(int sample, int vertex) { home_[sample] = vertex; }
  // The vertex that a sample is merged into, or is; -1 if there is none yet.
  int HomeOf(int sample) const;
  // The sample has a home.
  LinkId LinkOf(int sample) const { return link_of_[HomeOf(sample)]; }

  // Lists the samples, which all have homes, in their vertices. Call it once, at the end.
  void ListSamples();

  MergingCounts& counts() { return counts_; }

 private:
  // Where a link is touched.
  struct Place {
    LinkId link = -1;
    int index = 0;  // of the point
  };

  // The free end of its link that a vertex is.
  std::optional<LinkEnd> FreeEndOf(int vertex) const;
  Place PlaceOf(int sample) const;
  // Length between an end and a point of its link, px.
  double StubPx(const LinkEnd& end, int index) const;
  bool CanElongate(const LinkEnd& target, int index, const LinkEnd& run, int kept) const;
  void ReplaceStub(const LinkEnd& target, int index, const LinkEnd& run);
  bool Elongate(const Place& place, const LinkEnd& run, int kept);
  // The node that the end of a run gets at a place.
  NodeId NodeFor(const Place& place, const LinkEnd& run, bool* is_new);
  bool AreJoined(NodeId a, NodeId b) const;
  bool EndsAt(const Place& place, NodeId node) const;
  // Name of the vertex of a link that is nearest to a sample.
  int NearestVertex(const DrawingLink& link, int sample) const;
  void SetLink(LinkId link);

  const SampleSet& samples_;
  const PaperOptions& options_;
  DrawingGraph* graph_;
  GraphEditor editor_;
  std::vector<LinkId> link_of_;  // per vertex, that is, sample it was made from
  std::vector<int> home_;        // per sample: itself if it is a vertex, else one nearer to it
  MergingCounts counts_;
};

}  // namespace limn
