// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"

namespace limn::colmap_ext {

// To be called when a drawing of the output folder has been written. A page there is made anew: it
// shows the newest drawing, with the report, points and photographs of the old page, and new
// ones only where the old ones do not fit. Whatever prevents that is a warning. Other files
// of this name stay as they are.
void RenewPage(const Project& project, const std::string& workspace_path, Console* console);

// Warns if there is a page, which the command leaves older than the drawing for this reason.
void WarnOfOldPage(const Project& project, const std::string& reason, Console* console);

// The report of the page in the output folder; empty if there is none. Warns if the page cannot be
// read.
std::string ReportOfPage(const Project& project, Console* console);

}  // namespace limn::colmap_ext
