// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "colmap_ext/commands/command.h"

namespace limn::colmap_ext {

// In the order in which a project needs them, the main job first.
std::span<const Command> Commands();

// Null if no command has this name.
const Command* FindCommand(std::string_view name);

// The verb of Python's function. Throws std::out_of_range if there is none of this name.
std::unique_ptr<DrawingVerb> MakeDrawingVerb(std::string_view function);

}  // namespace limn::colmap_ext
