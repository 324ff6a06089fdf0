#include "limn/drawing/junctions.h"

namespace limn {

void JoinLinks(const SampleSet& samples, const std::vector<View>& views,
               const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
               const DrawingOptions& options, Draft* draft, JunctionCounts* counts) {
  LinkEnds ends(samples, views, evidence, options, draft);
  counts->without_image_evidence = 0;
  JoinContinuations(options, ends, draft, counts);
  JoinCorners(options, ends, draft, counts);
  JoinToNodes(options, ends, draft, counts);
  JoinToInteriors(options, ends, draft, counts);
}

}  // namespace limn
