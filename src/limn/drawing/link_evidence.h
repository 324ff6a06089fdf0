#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "limn/drawing/draft.h"
#include "limn/model/curve_fragment.h"
#include "limn/support/view_evidence.h"

namespace limn {

// What a link is judged by.
struct LinkJudgementInput {
  const SampleSet& samples;
  // Per sample: see CountAgreeingViews.
  const std::vector<int>& agreeing_views;
  const std::vector<View>& views;
  const std::vector<ImageCurves>& curves;
  const std::vector<std::unique_ptr<ViewEvidence>>& evidence;
};

// Which links to believe, 1 or 0 each. Samples of two primary views must have been merged into a
// link: curves that only agree may have been merged into another one. It must not be an occluding
// contour (occluding_contours.h). It is certain when enough
// primary views agree with it in the mean over its length (primary_views_share). Any other link
// must explain edgels that no certain link explains: it is believed when such edgels run along it
// in enough more views than any do along copies of it shifted sideways, which tell what chance does
// (own_views_share). Ours; not in the paper.
// Time: points of all links times views, ten times that for uncertain links.
std::vector<uint8_t> BelievedLinks(const LinkJudgementInput& input, const DrawingOptions& options,
                                   const Draft& draft, const RunContext& context);

}  // namespace limn
