// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "colmap_ext/commands/commands.h"

namespace limn::colmap_ext {

// What the command prints with -h or --help_all.
std::string HelpOf(const Command& command, const char* flag);

// The names of the options that a help text lists.
std::set<std::string> OptionsIn(const std::string& help);

}  // namespace limn::colmap_ext
