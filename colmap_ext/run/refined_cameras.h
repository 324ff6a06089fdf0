#pragma once

#include <optional>
#include <vector>

#include "colmap_ext/run/project.h"
#include "limn/refinement/refinement.h"

namespace limn::colmap_ext {

// To be called before any work if poses are refined (else it does nothing): throws OptionError if
// refined/, beside the drawing, is the input model itself, or has binary files, rigs or frames that
// would be read with or instead of the text files.
void CheckRefinedFolder(const Project& project, const RunOptions& options);

// The views that the drawing fits: the refined ones if there are any.
const std::vector<View>& ViewsOfDrawing(const Project& project,
                                        const std::optional<RefinedCameras>& cameras);

// Writes refined/cameras.txt, images.txt and points3D.txt: the input model with refined poses,
// focal lengths and points (see ApplyRefinement). Prints how far the cameras moved, and that rigs
// and frames are not written since every pose was refined separately. Without refined cameras it
// only warns if an earlier run left some. To be called before the drawing is written, so that no
// drawing lacks its cameras.
void WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                       Console* console);

}  // namespace limn::colmap_ext
