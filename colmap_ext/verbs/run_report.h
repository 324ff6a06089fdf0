// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/verbs/draw_options.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "colmap_ext/verbs/trust.h"

namespace limn::colmap_ext {

// Writes drawing.html with the report of the run: counts, times and memory of its stages, warnings,
// options that differ from the defaults, how far to trust the drawing, links by number of
// supporting images; with a truth also precision and recall, overall and for the links with at
// least n of them. Prints a line if Limn was built without the page. Throws IoError.
void WritePageWithReport(const Project& project, const DrawingInScene& drawing,
                         const DrawerOptions& options, const Trust& trust, Console* console);

}  // namespace limn::colmap_ext
