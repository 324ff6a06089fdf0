#pragma once

#include <memory>
#include <vector>

#include "limn/drawing/draft.h"
#include "limn/model/curve_fragment.h"
#include "limn/support/view_evidence.h"

namespace limn {

// Whether a link is the outline of a smooth body (algorithm.md 0.1 items 8 and 10): no edge in
// space, but where lines of sight touch the body, another place for every view. Neighbouring views
// agree on it nearly; so it is supported in a narrow part of the range of directions in which it is
// in the image. And as the body always covers the place, the views beside those see the outline
// moved to one and the same side of it. `near` holds the views that may contain the link. Time: at
// most 60 points times the square of these views.
bool IsOccludingContour(const DraftLink& link, const std::vector<ViewId>& near,
                        const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                        const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                        const SupportGate& gate);

}  // namespace limn
