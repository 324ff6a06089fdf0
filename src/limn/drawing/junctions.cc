#include "limn/drawing/junctions.h"

namespace limn {

JunctionCounts JoinLinks(const SampleSet& samples, const std::vector<View>& views,
                         const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                         const DrawingOptions& options, Draft* draft) {
  LinkEnds ends(samples, views, evidence, options, draft);
  JunctionCounts counts;
  JoinContinuations(options, ends, draft, &counts);
  JoinCorners(options, ends, draft, &counts);
  JoinToNodes(options, ends, draft, &counts);
  JoinToInteriors(options, ends, draft, &counts);
  return counts;
}

}  // namespace limn
