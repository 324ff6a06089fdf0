// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/limap_structures.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// A COLMAP model with LIMAP's structures: what LIMAP 2.0 calls a model.
struct LimapModel {
  SparseModel model;
  LimapStructures structures;
};

// A drawing as LIMAP's structures, beside the model that `views` were made from:
// - a straight link (LineOf) is a line, with a segment in each view that supports it
//   and has it in its region, and the mean of its sigmas as uncertainty;
// - with `chains` any other link is a chain of lines within half a pixel of it, else left out;
// - where lines meet is a new 3D point of the model, with an observation in all images of these
//   lines, if there are two; the wireframes say which lines go through it.
// Groups are not made. Throws InputError for images with lens distortion, whose lines are not
// straight, and IoError if the drawing has images that the model has not.
LimapModel ToLimap(DrawingFile drawing, SparseModel model, const std::vector<View>& views,
                   bool chains);

// A drawing whose links are LIMAP's lines, supported by the images of their tracks: the named
// views, all images of the model if none are named. Others support nothing. Lines meet
// where they end within their uncertainty of the same point of the wireframe, and are moved there.
// Lines of no length and groups are left out. Throws IoError for images or points that the model
// does not have.
DrawingFile FromLimap(const LimapModel& limap, const std::vector<std::string>& view_names = {});

// Whether the folder has structures/ with lines, or is structures/, and the model is beside it.
bool HoldsLimapDrawing(const std::filesystem::path& folder);

// FromLimap of such a folder. Throws IoError.
DrawingFile ReadLimapDrawing(const std::filesystem::path& folder,
                             const std::vector<std::string>& view_names = {});

}  // namespace limn::colmap_ext
