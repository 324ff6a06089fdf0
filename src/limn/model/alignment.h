// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "limn/geometry/similarity3.h"

namespace limn {

// What determined the up direction of an alignment (limn/alignment/).
enum class UpSource {
  kGravity,    // measured in the cameras
  kPositions,  // of the cameras
  kLines,      // vertical and horizontal lines of the drawing
  kCameras,    // how cameras are held, roughly
};

// What determined its rotation around the vertical.
enum class AxesSource {
  kLines,      // the x or y axis is along the main horizontal direction of the drawing
  kPositions,  // x is east
  kModel,      // x is as near to the model's as it can be
  kPlan,       // the directions of lines in a floor plan
};

// What determined its scale.
enum class ScaleSource {
  kNone,       // nothing: the unit is the model's
  kLengths,    // known lengths
  kPositions,  // of the cameras
};

// "gravity", "positions", "lines", "cameras".
const char* SourceName(UpSource source);
// "lines", "positions", "model", "plan".
const char* SourceName(AxesSource source);
// "none", "lengths", "positions".
const char* SourceName(ScaleSource source);

// How a drawing in the coordinates of its model lies in the world: z is up, z = 0 its floor unless
// the world has an origin of its own, and lengths are in meters unless the scale is unknown.
struct Alignment {
  Similarity3d world_from_model;
  UpSource up = UpSource::kCameras;
  AxesSource axes = AxesSource::kModel;
  ScaleSource scale = ScaleSource::kNone;
  // Standard deviation of the scale, relative; 0: unknown.
  double scale_sigma = 0;

  bool IsMetric() const { return scale != ScaleSource::kNone; }
  const char* Unit() const { return IsMetric() ? "m" : "none"; }
};

// What is wrong with it; empty if it is valid. Wrong are non-finite numbers, a scale that is not
// positive, a negative standard deviation, and a matrix that is not a rotation to 1e-6.
std::string Validate(const Alignment& alignment);

// The alignment of a drawing whose coordinates were changed by file_from_model.
Alignment After(const Similarity3d& file_from_model, Alignment alignment);

}  // namespace limn
