// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// Whether the folder contains cameras and images, in binary or text format.
bool HoldsColmapModel(const std::filesystem::path& folder);

// Which file an incomplete model lacks, such as "images.bin is missing beside cameras.bin". Empty
// if the folder has neither cameras nor images, or is a model.
std::string MissingColmapFile(const std::filesystem::path& folder);

// Number of registered images, without reading them. Throws IoError.
uint64_t CountColmapImages(const std::filesystem::path& folder);

// Reads a model: binary if cameras.bin and images.bin exist, else text; a format with points3D is
// preferred. A missing points3D file is a warning, since poses are enough. Poses composed from rigs
// and frames, where both exist, replace those of the images file, as in COLMAP.
//
// Throws IoError naming file, byte or line, and reason: missing, truncated or trailing data, counts
// too large for the file, unknown camera model, wrong number of parameters, focal length or size
// that is not positive or makes no sense, an EQUIRECTANGULAR camera whose parameters are not its
// size, within half a pixel, or whose height is not half its width, duplicate ids or names, unknown
// camera_id, zero or non-finite poses, image names that are empty or lead out of the image folder.
SparseModel ReadColmapModel(const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
