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
  // Folder of masks, <mask_path>/<image name>.png as in COLMAP: pixels where they are 0 are not
  // used. An image without a mask is used entirely, with a warning. Empty = no masks.
  std::string mask_path;
  // Longer side of the images in pixels, of panoramas that of a quarter of their width; larger ones
  // are shrunk by an area filter, which is faster and coarser. -1 = as stored.
  int max_image_size = -1;
  // Width of the ignored strip along the image borders, pixels: lenses are worst there, and filters
  // reach beyond the image.
  double border_margin_px = 8;
  // Images whose sparse points are off by more than this in the median, px of the images as used,
  // are left out. 0 = keep all, and only warn.
  double max_reprojection_px = 0;

  bool operator==(const ViewOptions&) const = default;
  // Throws OptionError.
  void Check() const;
};

// Whole images of which parts are read, after max_image_size.
struct DecodedPanoramas {
  LastDecoded<Image> images;
  LastDecoded<std::vector<unsigned char>> masks;
};

// Views and their files, by view; a panorama has a view per part, each with its file. Nothing but
// model indices depends on the order or ids of the model's images and cameras.
struct ViewSet {
  std::vector<View> views;  // sorted by name of the image and part; View::id is the index
  SceneHints hints;         // points sorted by id
  std::vector<std::string> image_paths;
  std::vector<std::string> mask_paths;  // empty string = no mask
  std::vector<ImageSize> stored_sizes;  // of the files, before max_image_size
  // Damaged files (CheckJpeg), which are masked entirely.
  std::vector<char> is_damaged;
  // For a view of a panorama: its part of the image after max_image_size, its orientation there,
  // and the name of the image. Empty if there are no panoramas.
  std::vector<std::optional<ImageWindow>> windows;
  std::vector<Eigen::Quaterniond> view_from_image;
  std::vector<std::string> image_names;
  std::shared_ptr<DecodedPanoramas> decoded;  // panoramas kept by ReadViewImage and ReadViewMask
  int max_image_size = -1;
  PhotoStore photos;  // what is at image_paths
  std::vector<std::string> warnings;
  std::vector<std::string> left_out;  // the warnings that name images that were left out, and why

  bool HasPanoramas() const { return !windows.empty(); }
  const std::string& ImageName(ViewId view) const {
    return HasPanoramas() ? image_names[view] : views[view].name;
  }
  // Distinct images among these views.
  size_t CountImages(const std::vector<ViewId>& of_views) const;
  // The longer side, px, that the file of a view is shrunk to; -1 = as stored.
  int MaxFileSize(ViewId view) const;
  // Null if the view is no part of a panorama.
  const ImageWindow* Window(ViewId view) const {
    return HasPanoramas() && windows[view] ? &*windows[view] : nullptr;
  }
};

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
// Throws IoError: an image is missing or unreadable, its size does not match its camera, a name in
// the list is not registered, a mask has the wrong size. Throws InputError if no image is left.
ViewSet ToViews(const SparseModel& model, const std::filesystem::path& image_dir,
                const ViewOptions& options, const RunContext& context = {},
                const PhotoStore& photos = {});

// A pixel of the image of a view, as stored, in the model's camera, COLMAP's pixels: the view may
// be of another size.
Eigen::Vector2d ModelPixel(const View& view, const Camera& camera,
                           const Eigen::Vector2d& stored_px);

// These views of the set (with refined cameras, maybe), with the names of their images, and stored
// pixels of the whole images. Columns of a panorama continue across its left border: they run from
// -1/8 to 7/8 of its width. For tracks: the sizes of parts stay.
std::vector<View> InWholeImages(const ViewSet& view_set, std::vector<View> views);

// One byte per pixel of the view, 0 = do not use; all 0 if the photograph is damaged. Empty = all
// pixels may be used. Throws IoError.
std::vector<unsigned char> ReadViewMask(const ViewSet& view_set, ViewId view);

// The photograph of a view with its mask, at the size of the view; black and masked entirely if it
// is damaged. Throws IoError.
Image ReadViewImage(const ViewSet& view_set, ViewId view);

// Frees what the two keep to read other parts of a panorama: up to one whole panorama and its mask
// per thread. Call it after a loop over views.
void ReleaseDecoded(const ViewSet& view_set);

}  // namespace limn::colmap_ext
