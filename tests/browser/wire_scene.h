// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "limn/viewer/viewer_scene.h"

namespace limn::testing {

// A cube of straight links and a circle on its top, far from the origin, as six views with their
// principal points off the middle see it; with primitives, classes, a cloud and a report. Names
// hold what would be HTML.
ViewerScene WireScene();

// What a page of the scene must show: links, nodes, and where every view sees the links
// (View::Project), a sample every quarter of a pixel or closer.
nlohmann::ordered_json Expectations(const ViewerScene& scene);

// 1,000 links of 100 segments each on the surface of a torus and 200,000 points beside it.
ViewerScene LargeScene();

}  // namespace limn::testing
