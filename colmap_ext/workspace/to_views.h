// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include <Eigen/Core>

#include "colmap_ext/model/model.h"
#include "colmap_ext/workspace/photo_store.h"
#include "colmap_ext/workspace/view_set.h"
#include "limn/model/view.h"
#include "limn/util/parallel.h"

namespace limn::colmap_ext {

// Which images are used, and at which size.
struct ViewOptions {
  // Text file with the names of the images to use, one per line. Empty = all registered images.
  std::string image_list_path;
  // Leave out, with a warning, images without a file instead of refusing them.
  bool skip_missing_images = false;
  // Folder of masks, list of masks or mask of all images (FindMasks): pixels where they are 0 are
  // not used. An image without a mask is used entirely, with a warning. Empty = no masks.
  std::string mask_path;
  // Longer side of the images in pixels, of panoramas that of a quarter of their width; larger ones
  // are shrunk by an area filter, which is faster and coarser. -1 = as stored.
  int max_image_size = -1;
  // Images that resolve more than their pixels show are used as if they were enlarged, at most so
  // many times (ScaleOf). 1 = never. Panoramas never are.
  double max_scale = 1;
  // Width of the ignored strip along the image borders, pixels: lenses are worst there, and filters
  // reach beyond the image.
  double border_margin_px = 8;
  // Images whose sparse points are off by more than this in the median, px of the images as used,
  // are left out. 0 = keep all, and only warn.
  double max_reprojection_px = 0;
  // Text file with the names of images whose cameras are not refined, one per line. Empty = none.
  std::string hold_images;

  bool operator==(const ViewOptions&) const = default;
  // Throws OptionError.
  void Check() const;
};

// Pixels of the view per pixel of an image whose edges are blurred by so many px (MeasureEdgeBlur):
// such that they are blurred by 0.8 px of the view, in quarters, at least 1.
double ScaleOf(double edge_blur_px, double max_scale);

// The only place where COLMAP's conventions become Limn's. Principal points move by -0.5 pixel;
// cameras with distortion get a LensMap onto a virtual pinhole of the same focal length and
// principal point. An EQUIRECTANGULAR image gives a view per part (model/panorama.h), named <image
// name>.part00 and so on. Intrinsics are rescaled to the size of the file, if its aspect is the
// camera's within one pixel, and to max_image_size. Headers of all images, the codes of JPEG files
// and masks are read, in parallel. Views of damaged images show nothing, with a warning. Left out,
// with warnings, are duplicates (FindDuplicateImages), images and points far outside the scene of
// the others (SceneReach) and, on request (max_reprojection_px), cameras that do not fit the
// points. Photographs may be in memory: those that `photos` has at <image_dir>/<image name>.
//
// Photographs are turned and stretched, and masked by their alpha channels, as SetForms says; 2D
// points that are pixels of pictures of another size count where they belong (FindPointFrames).
//
// Throws IoError: an image is missing or unreadable, its size does not match its camera, a name in
// the list is not registered, a mask has another aspect, and what FindMasks throws. Throws
// InputError if no image is left, and what HoldImages throws.
ViewSet ToViews(const SparseModel& model, const std::filesystem::path& image_dir,
                const ViewOptions& options, const RunContext& context = {},
                const PhotoStore& photos = {});

// A pixel of the image of a view, as stored, in the model's camera, COLMAP's pixels: the view may
// be of another size.
Eigen::Vector2d ModelPixel(const View& view, const Camera& camera,
                           const Eigen::Vector2d& stored_px);

}  // namespace limn::colmap_ext
