// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "limn/files/text_scanner.h"
#include "limn/model/edge_map.h"

namespace limn {

// Throws the scanner's error if an edgel is not finite, its strength or sigma below 0, its sigma
// above 10 px, or its position more than a pixel outside the image.
inline void CheckEdgel(const TextScanner& scanner, const Edgel& edgel, int width, int height) {
  if (!edgel.position_px.allFinite() || !std::isfinite(edgel.tangent_rad) ||
      !std::isfinite(edgel.strength) || !std::isfinite(edgel.position_sigma_px)) {
    scanner.Fail("edgel not finite");
  }
  if (edgel.strength < 0) scanner.Fail("strength below 0");
  if (edgel.position_sigma_px < 0) scanner.Fail("uncertainty below 0");
  if (edgel.position_sigma_px > 10) scanner.Fail("uncertainty above 10 px");
  if (!IsNearImage(width, height, edgel.position_px)) scanner.Fail("edgel outside the image");
}

}  // namespace limn
