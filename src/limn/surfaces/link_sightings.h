// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/belief/image_evidence.h"

namespace limn {

enum class Sighting : uint8_t {
  kOutside,  // not in the image
  kHidden,   // in the image, but no edgel runs along the link there
  kOther,    // only edgels that a better link explains
  kShown,
};

// What a view shows of a link, per sample of its evidence.
struct LinkSighting {
  std::vector<Sighting> samples;
  std::vector<Eigen::Vector2d> pixels;  // where not kOutside
  Eigen::AlignedBox2d extent;           // of the pixels
};

// What a view shows of all links; empty for links that it cannot see. Time: samples.
std::vector<LinkSighting> SightingsIn(const View& view, ViewId id,
                                      const std::vector<ImageEvidence>& links);

}  // namespace limn
