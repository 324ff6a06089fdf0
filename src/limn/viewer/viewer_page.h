#pragma once

#include <iosfwd>

#include "limn/viewer/viewer_scene.h"

namespace limn {

// Whether this build has the page in it (CMake option LIMN_WITH_VIEWER).
bool HasViewerPage();

// A page that shows the scene: one HTML file that needs nothing else, no network and no server. The
// same scene gives the same bytes. Throws InputError if the scene does not fit together (payload.h)
// or the build has no page.
void WriteViewerPage(const ViewerScene& scene, std::ostream& out);

}  // namespace limn
