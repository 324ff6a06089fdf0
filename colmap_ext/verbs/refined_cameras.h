#pragma once

#include <optional>

#include "colmap_ext/host/job.h"
#include "colmap_ext/host/project.h"
#include "limn/pipeline/refine_cameras.h"

namespace limn::colmap_ext {

// Says what has become of the cameras of the set, none = left as they are.
void SayCameras(const std::optional<RefinedCameras>& cameras, const ViewSet& set,
                CameraRefinement how, Console* console);

// Call it before the work (it does nothing if cameras are never refined): throws OptionError if
// refined/, beside the drawing, is the input model itself, or has binary files that would be read
// instead of the text files.
void CheckRefinedFolder(const Project& project, const RunOptions& options);

// Writes refined/cameras.txt, images.txt and points3D.txt: the input model with refined poses,
// parameters of cameras and points (see ApplyRefinement), and, if it has some, rigs.txt and
// frames.txt with poses of frames that go with these; and curves/cameras.csv. Without refined
// cameras it only warns if an earlier run left some. Call it before the drawing is written, so that
// no drawing lacks its cameras.
void WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                       Console* console);

}  // namespace limn::colmap_ext
