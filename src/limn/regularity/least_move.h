// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "limn/regularity/regularity_classes.h"

namespace limn {

// The shape of a line or arc that follows the present regularities with the least move, in the
// metric of its evidence, from what fits the images best; curves that meet it are ignored. All
// memberships are of one link. Local units. To first order for arcs.
CurveShape LeastMove(std::span<const Membership> memberships, const RegularityClasses& classes,
                     const DrawingEvidence& evidence);

}  // namespace limn
