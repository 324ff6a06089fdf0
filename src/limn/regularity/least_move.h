#pragma once

#include <span>

#include "limn/regularity/regularity_classes.h"

namespace limn {

// The shape of a line or arc that follows regularities as they are and is the least move, as its
// evidence tells it, from what suits the images best; without regard to what meets it. All
// memberships are of one link. Local units. To first order for arcs.
CurveShape LeastMove(std::span<const Membership> memberships, const RegularityClasses& classes,
                     const DrawingEvidence& evidence);

}  // namespace limn
