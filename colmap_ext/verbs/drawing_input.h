// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/workspace/layout.h"
#include "limn/formats/json_drawing_reader.h"

namespace limn::colmap_ext {

// The name of a drawing that was fused with dense results.
constexpr const char* kFusedDrawing = "drawing-fused.json";

// Which drawing of a folder a command reads if no path is given.
enum class DrawingChoice {
  kUnfused,  // drawing.json: to continue from it
  kNewest,   // that, or drawing-fused.json, which has more, unless it is older: to read from it
};

// What a command continues from (LayoutOptions::starts_from): the drawing of this path, or, if that
// is empty, the one of the output folder.
std::vector<std::string> DrawingsToStartFrom(DrawingChoice choice, const std::string& path);

// The path of the drawing in an output folder. Throws IoError if there is none; it names what was
// looked for, and the option that takes a path.
std::string FindDrawing(const std::filesystem::path& folder, DrawingChoice choice,
                        const std::string& path_option);

// The same in the output folder of a workspace, else in the workspace itself, which may be an
// output folder without a model unless a model or images are asked for. Throws what ResolveLayout
// throws for other workspaces.
std::string FindDrawing(const LayoutOptions& workspace, DrawingChoice choice,
                        const std::string& path_option);

// Tells a state of the file from others (limn/cache/content_hash.h); empty for a folder. Throws
// IoError.
std::string FingerprintOf(const std::string& path);

// Reads a drawing.json, or a drawing from the folder of a model of LIMAP, for these views (see
// ReadLimapDrawing). Throws IoError.
DrawingFile ReadDrawing(const std::string& path, const std::vector<std::string>& view_names = {});

// The alignment of a drawing that shall be shown or exported with it. Throws IoError naming the
// file if it has none.
const Alignment& RequireAlignment(const std::string& path, const DrawingMetadata& metadata);

}  // namespace limn::colmap_ext
