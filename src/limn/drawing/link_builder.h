#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/drawing/drawing_options.h"
#include "limn/drawing/samples.h"

namespace limn {

// How many times each merging primitive was applied (ECCV 2016, section 5; algorithm.md 11.3).
struct MergingCounts {
  int64_t released = 0;        // a run that touches nothing: a link of its own
  int64_t elongated = 0;       // a run that continues a link beyond its free end
  int64_t branched = 0;        // a run that leaves a link from its interior: junction
  int64_t bridged = 0;         // a run between two links
  int64_t rejoined = 0;        // a run with both ends on one link (bubble, or loop closed)
  int64_t multi_attached = 0;  // a run that ends at an existing node
};

// Vertices of the links under construction. A vertex never changes its id; where a link is trimmed
// its vertices are replaced by others and forward to them.
class LinkBuilder {
 public:
  struct Link {
    std::vector<int> vertices;
    int node[2] = {-1, -1};  // -1 = free end
    bool closed = false;     // the last vertex is followed by the first
    bool alive = true;
  };

  LinkBuilder(const SampleSet& samples, const DrawingOptions& options)
      : samples_(samples), options_(options) {}

  // A new link whose vertices are these samples, in order. Ends are free. Returns its id.
  int AddLink(const std::vector<int>& run, bool closed);

  // Join end `end` of link `link` to the graph at `vertex` of another link: elongates that link if
  // the vertex is near its free end and the directions agree, ends at its node if one is near, and
  // otherwise splits it there. Returns the id of the link that now holds the run.
  int Attach(int link, int end, int vertex);

  // The vertex that stands for a vertex now.
  int Resolve(int vertex) const;

  const std::vector<Link>& links() const { return links_; }
  // The sample a vertex was made from.
  int SampleOf(int vertex) const { return sample_of_[vertex]; }
  int LinkOf(int vertex) const { return link_of_[Resolve(vertex)]; }
  int num_vertices() const { return static_cast<int>(sample_of_.size()); }
  int num_nodes() const { return num_nodes_; }
  const MergingCounts& counts() const { return counts_; }
  MergingCounts& counts() { return counts_; }

 private:
  const Eigen::Vector3d& Position(int vertex) const {
    return samples_.position[sample_of_[vertex]];
  }
  int IndexOf(int vertex) const;
  double ArcPx(const Link& link, int from, int to) const;
  Eigen::Vector3d OutwardDirection(const Link& link, int end) const;
  bool CanElongate(int target, int target_end, int index, int link, int end) const;
  int Elongate(int target, int target_end, int index, int link, int end);
  int SplitAt(int link, int index);
  int CopyVertex(int vertex, int link);
  void EndAt(int link, int end, int node, int vertex);

  const SampleSet& samples_;
  const DrawingOptions& options_;
  std::vector<int> sample_of_;
  std::vector<int> link_of_;
  mutable std::vector<int> forward_;
  std::vector<Link> links_;
  int num_nodes_ = 0;
  MergingCounts counts_;
};

}  // namespace limn
