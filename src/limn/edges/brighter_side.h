// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/edgel.h"
#include "limn/model/image.h"

namespace limn {

// How much brighter a photograph is on the side of Normal() than on the other: the difference of
// the means of all channels at 1, 2 and 3 px from the edgel, gray levels. Beyond the border the
// image continues with its last pixel. `edgel` is in pixels of the image.
double BrighterSide(const Image& image, const Edgel& edgel);

// Turns edgels whose other side is the brighter one: by the sum of BrighterSide over the edgels
// within 3 px that continue them, so that they agree along a curve where the photograph shows
// little difference. Linear time.
void DirectByBrightness(const Image& image, std::vector<Edgel>* edgels);

}  // namespace limn
