// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/viewer/viewer_scene.h"

namespace limn {

// Whether this build includes the page (CMake option LIMN_WITH_VIEWER).
bool HasViewerPage();

// Writes a page that shows the scene: one self-contained HTML file, which needs no network and no
// server. The same scene gives the same bytes. Throws InputError if the scene is inconsistent
// (payload.h) or the build has no page.
void WriteViewerPage(const ViewerScene& scene, std::ostream& out);

}  // namespace limn
