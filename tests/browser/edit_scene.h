// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "limn/viewer/viewer_scene.h"

namespace limn::testing {

// Links to edit, in a plane that one view looks straight down on, with a face, a link behind it and
// a dimension. What is displayed is turned, scaled and moved. Links, by their numbers:
//   0, 1   on one line with a gap between them, free ends
//   2, 3   side by side
//   4 to 6 meet at a corner
//   7      tentative
//   8      outline of a smooth body
//   9      a circle
//   10     short
//   11, 12 behind the face, and along its border
ViewerScene EditScene();

// Points of the links as displayed and in the coordinates of drawing.json, how the former come from
// the latter, and the corner of the face.
nlohmann::ordered_json EditExpectations(const ViewerScene& scene);

// 4,000 links of 100 segments each.
ViewerScene ManyLinksScene();

}  // namespace limn::testing
