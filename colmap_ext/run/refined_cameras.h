#pragma once

#include <optional>
#include <vector>

#include "colmap_ext/run/project.h"
#include "limn/refinement/refinement.h"

namespace limn::colmap_ext {

// The refined cameras go to refined/ beside the drawing. To be called before any work: throws
// OptionError if the model that is read is there itself, or binary files, rigs or frames that
// would be read with the text files or instead of them. Does nothing unless poses are refined.
void CheckRefinedFolder(const Project& project, const RunOptions& options);

// The views that the drawing fits: refined ones if there are any.
const std::vector<View>& ViewsOfDrawing(const Project& project,
                                        const std::optional<RefinedCameras>& cameras);

// Write refined/cameras.txt, images.txt and points3D.txt: the model that was read, with refined
// poses, focal lengths and points (see ApplyRefinement). Rigs and frames are not written: the poses
// were refined each for itself, which is said, as is how far the cameras moved. Without refined
// cameras this only warns of those that an earlier run has left there. To be called before the
// drawing is written: no drawing without its cameras.
void WriteRefinedModel(const Project& project, const std::optional<RefinedCameras>& cameras,
                       Console* console);

}  // namespace limn::colmap_ext
