#pragma once

#include <optional>

#include "colmap_ext/host/project.h"
#include "limn/refinement/refinement.h"

namespace limn::colmap_ext {

// Call it before the work (it does nothing unless poses are refined): throws OptionError if
// refined/, beside the drawing, is the input model itself, or has binary files that would be read
// instead of the text files.
void CheckRefinedFolder(const Project& project, const RunOptions& options);

// Writes refined/cameras.txt, images.txt and points3D.txt: the input model with refined poses,
// focal lengths and points (see ApplyRefinement), and, if it has some, rigs.txt and frames.txt with
// poses fitted to these (FitRigs). Reports how far the cameras moved, and how far images of
// multi-camera rigs are then from their refined poses. Without refined cameras it only warns if an
// earlier run left some. Call it before the drawing is written, so that no drawing lacks its
// cameras.
void WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                       Console* console);

}  // namespace limn::colmap_ext
