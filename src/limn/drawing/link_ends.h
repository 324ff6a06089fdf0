#pragma once

#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "limn/drawing/draft.h"
#include "limn/support/view_evidence.h"

namespace limn {

// The fragments, per view, that support a stretch of a link.
using FragmentsByView = std::map<ViewId, std::set<int>>;

// What all that joins the ends of links asks and does. Holds references; the draft is changed by
// EndAt only.
class LinkEnds {
 public:
  LinkEnds(const SampleSet& samples, const std::vector<View>& views,
           const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
           const DrawingOptions& options, Draft* draft)
      : samples_(samples), views_(views), evidence_(evidence), options_(options), draft_(draft) {}

  // Ends of open links that are at no node.
  std::vector<LinkEnd> Free() const;
  std::vector<EndLine> Lines(const std::vector<LinkEnd>& ends) const;
  // Pairs (i < j) of ends within twice the reach of each other.
  std::vector<std::pair<int, int>> NearPairs(const std::vector<EndLine>& lines) const;

  // How far a link may be extended or cut back to meet something, px.
  double ReachPx() const;
  // The same on one line: `along` is the way from the end outwards, world units.
  bool InReach(double along, double footprint) const;

  FragmentsByView FragmentsAround(const DraftLink& link, int index) const;
  FragmentsByView FragmentsAtEnd(const LinkEnd& ref) const;
  // In min_junction_views views image curves of both stretches come near the projection of the
  // point.
  bool ImagesAgree(const Eigen::Vector3d& point, const FragmentsByView& a,
                   const FragmentsByView& b) const;

  // Cut what overshoots the node, then end there.
  void EndAt(const LinkEnd& ref, int node, const Eigen::Vector3d& point);

 private:
  void CollectFragments(const DraftLink& link, int k, FragmentsByView* fragments) const;

  const SampleSet& samples_;
  const std::vector<View>& views_;
  const std::vector<std::unique_ptr<ViewEvidence>>& evidence_;
  const DrawingOptions& options_;
  Draft* draft_;
};

}  // namespace limn
