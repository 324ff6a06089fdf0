// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <Eigen/Core>

namespace limn::colmap_ext {

// What a COLMAP database.db knows about an image before reconstruction.
struct PosePrior {
  // Of the camera's center: latitude and longitude in degrees and altitude in meters (WGS84), or in
  // a frame with z up, taken to be in meters.
  std::optional<Eigen::Vector3d> position;
  bool is_geographic = false;
  // Standard deviation along each axis, 0 = unknown.
  double position_sigma = 0;
  // Which way things fall, in the camera's coordinates.
  std::optional<Eigen::Vector3d> gravity;
};

// By the name of the image.
using PosePriors = std::map<std::string, PosePrior>;

// Reads the priors of these images of a database of COLMAP 3.4 to 4.2: table pose_priors, or, in
// databases without one, the columns prior_* of images, where COLMAP stores geographic positions
// (unless some are not on earth); with a rotation they are the pose of the camera in a frame with z
// up. Images without priors are left out, and so are the priors of other sensors than cameras.
// Positions without coordinate system are Cartesian, as to COLMAP. The file is opened read-only and
// as immutable: neither it nor its folder is changed.
//
// Nothing of its schema is run: views, virtual tables and computed columns are refused.
//
// Throws IoError: no database, tables or columns missing, values of wrong size or impossible,
// positions of both kinds, more work than any database of COLMAP takes (some seconds), a journal or
// log with changes that are not in the file (CheckHasNoJournal).
PosePriors ReadPosePriors(const std::filesystem::path& path, const std::set<std::string>& images);

}  // namespace limn::colmap_ext
