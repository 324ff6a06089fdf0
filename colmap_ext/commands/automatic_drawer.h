// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/commands/command.h"

namespace limn::colmap_ext {

// The one command that draws again and again, and that several processes share.
int RunAutomaticDrawer(const Command& command, int argc, const char* const* argv,
                       const ConsoleMaker& make_console);

}  // namespace limn::colmap_ext
