#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "limn/drawing/draft.h"
#include "limn/model/curve_fragment.h"
#include "limn/support/segment_evidence.h"
#include "limn/support/view_evidence.h"

namespace limn {

// A place where links end: a node, or a free end.
struct Joint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // mean of the ends
  double footprint = 0;
  std::vector<LinkEnd> ends;
  std::vector<Eigen::Vector3d> leaving;  // unit directions into the links
  std::vector<uint8_t> visible;          // per view: edgels support a link near the joint
};

// All joints of the draft, in the order of their first link.
std::vector<Joint> CollectJoints(const SampleSet& samples, size_t num_views, const Draft& draft);

// Whether a link leaves the joint within the angle of the direction.
bool IsTaken(const Joint& joint, const Eigen::Vector3d& direction, double max_angle_rad);

// Per view, the edgels of fragments: all, and those that no link of the draft is made from.
// Neighbours on the fragment of an edgel that supports a link belong to the link too.
struct EdgelEvidence {
  EdgelIndexes all;        // those of the views' evidence, which must outlive this
  EdgelIndexes unclaimed;  // point into `owned`
  std::vector<EdgelIndex> owned;
};
EdgelEvidence IndexEdgels(const std::vector<ImageCurves>& curves,
                          const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                          const SampleSet& samples, const Draft& draft);

// What finds an edge next to a corner, where edges are rounded: wider than the gate of samples.
SupportGate CornerGate();

// Edgels of the given views at a point of an edge with this direction.
std::vector<EdgelRef> SupportAt(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                                const std::vector<ViewId>& in_views, const std::vector<View>& views,
                                const EdgelIndexes& edgels, const SupportGate& gate);

// A straight link that joints need and the sketch does not have. Its samples, with the edgels of
// `in_views` as support, are appended to `samples` without a curve of the sketch; joints are given
// nodes and know the new link afterwards.
class StraightLinks {
 public:
  StraightLinks(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                const EdgelIndexes& edgels, SampleSet* samples, Draft* draft)
      : views_(views), curves_(curves), edgels_(edgels), samples_(samples), draft_(draft) {}

  // From the joint to a free end, or to another joint if `target` is not null.
  void Add(const Eigen::Vector3d& end, const std::vector<ViewId>& in_views, Joint* joint,
           Joint* target);

 private:
  int NodeAt(const Joint& joint);
  int AppendSample(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                   double footprint, const std::vector<ViewId>& in_views);

  const std::vector<View>& views_;
  const std::vector<ImageCurves>& curves_;
  const EdgelIndexes& edgels_;
  SampleSet* samples_;
  Draft* draft_;
};

}  // namespace limn
