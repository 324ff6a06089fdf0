#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/cache/result_cache.h"
#include "limn/cameras/camera_mounts.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"
#include "limn/pipeline/extract_curves.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/parallel.h"

namespace limn {

struct CameraRefinementInput {
  const std::vector<View>& views;
  const SceneHints& hints;
  const ImageSource& images;
  std::optional<Eigen::AlignedBox3d> box;
  // Image curves of earlier runs, where new ones are stored. Never null.
  ResultCache* cache;
  const CameraMounts& mounts;
};

// What became of the camera of a view.
struct CameraChange {
  // Motion of the image of the scene that is not common to all cameras.
  double moved_px = 0;
  // Of the edgels that curves were fitted to: number, and median distance before the last step.
  int num_edgels = 0;
  double residual_px = 0;
  // Standard deviation of the image of the scene, as far as edgels are independent; 0 = not known.
  double certain_by_px = 0;
  // Moved much farther than most: it was wrong, and may still be.
  bool is_misfit = false;
};

// The refined cameras, in the frame of the given ones.
struct RefinedCameras {
  std::vector<View> views;  // as in the input, with other poses and optics
  SceneHints hints;         // the same points, elsewhere
  std::vector<CameraChange> of_view;
  double median_move_px = 0;
};

// Refines the cameras by the curves that they see (ours; algorithm/cameras.md), from small pictures
// to the pictures as stored. Of smaller pictures each is drawn until the cameras settle; the
// pictures as stored are not drawn. Returns nothing if the views show too little. With
// CameraRefinement::kAuto it returns nothing, too, unless a drawing of small pictures says that
// cameras are off by about a pixel or more; less is seen in the drawing itself (CamerasAreOff).
// Throws OptionError, what `images` throws, and Cancelled. Time: a large part of that of a drawing;
// a small one if it stops after the first look.
std::optional<RefinedCameras> RefineCameras(const CameraRefinementInput& input,
                                            const PipelineOptions& options,
                                            const RunContext& context);

// Whether the edgels along a drawing of the pictures as stored, not refined yet, fit much better
// when the cameras move. `curves` belong to the views.
bool CamerasAreOff(const DrawingGraph& graph, const std::vector<View>& views,
                   const std::vector<ImageCurves>& curves, const SceneHints& hints,
                   const CameraMounts& mounts, const PipelineOptions& options,
                   const RunContext& context);

}  // namespace limn
