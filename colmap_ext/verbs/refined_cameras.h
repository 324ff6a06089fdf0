#pragma once

#include <optional>

#include "colmap_ext/host/job.h"
#include "colmap_ext/host/project.h"
#include "limn/pipeline/refine_cameras.h"

namespace limn::colmap_ext {

// RefineCameras for a scene, unless `how` is kOff; says what was found.
std::optional<RefinedCameras> RefineSceneCameras(const Job& job, CameraRefinement how);

// Call it before the work (it does nothing if cameras are never refined): throws OptionError if
// refined/, beside the drawing, is the input model itself, and IoError if it has files that must
// not be replaced.
void CheckRefinedFolder(const Project& project, const RunOptions& options);

// Writes refined/, in the flavor of the input model: that model with refined poses, parameters of
// cameras and points (see ApplyRefinement), and, if it has some, rigs and frames with poses that go
// with these; and curves/cameras.csv. Without refined
// cameras it only warns if an earlier run left some. Call it before the drawing is written, so that
// no drawing lacks its cameras.
void WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                       Console* console);

}  // namespace limn::colmap_ext
