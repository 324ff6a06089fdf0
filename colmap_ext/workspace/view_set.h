// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "colmap_ext/model/panorama.h"
#include "colmap_ext/workspace/image_form.h"
#include "colmap_ext/workspace/image_size.h"
#include "colmap_ext/workspace/last_decoded.h"
#include "colmap_ext/workspace/photo_store.h"
#include "limn/cameras/camera_mounts.h"
#include "limn/model/image.h"
#include "limn/model/scene_hints.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// Where the pixels of a view come from: an image, or a part of a panorama.
struct ViewFile {
  std::string image_name;  // that of the view, unless this is a part
  std::string image_path;
  std::string mask_path;  // empty = no mask
  ImageSize stored_size;  // before max_image_size; after turning, if the form says so
  // As CheckJpeg says; then all of it is masked.
  bool is_damaged = false;
  ImageForm form = {};
  // Of a part: where it is in the image, after max_image_size, and how it is turned in it.
  std::optional<ImageWindow> window = std::nullopt;
  Eigen::Quaterniond view_from_image = Eigen::Quaterniond::Identity();
};

// Whole images of which parts are read, after max_image_size.
struct DecodedPanoramas {
  LastDecoded<Image> images;
  LastDecoded<std::vector<unsigned char>> masks;
};

// Views and their files. Nothing but model indices depends on the order or ids of the model's
// images and cameras.
struct ViewSet {
  std::vector<View> views;      // sorted by name of the image and part; View::id is the index
  std::vector<ViewFile> files;  // per view
  SceneHints hints;             // points sorted by id
  CameraMounts mounts;          // by rigs and frames, and by panoramas
  std::shared_ptr<DecodedPanoramas> decoded;  // panoramas kept by ReadViewImage and ReadViewMask
  int max_image_size = -1;
  PhotoStore photos;  // what is at the paths of the images
  std::vector<std::string> warnings;
  std::vector<std::string> notes;     // what else the user should know
  std::vector<std::string> left_out;  // the warnings that name images that were left out, and why

  bool HasPanoramas() const;
  const std::string& ImageName(ViewId view) const { return files[view].image_name; }
  // Distinct images among these views.
  size_t CountImages(const std::vector<ViewId>& of_views) const;
  // The longer side, px, that the file of a view is shrunk to; -1 = as stored.
  int MaxFileSize(ViewId view) const;
  // Of the image that ReadViewImage returns, px.
  ImageSize ReadSize(ViewId view) const;
  // The median of the views' scales: lengths in messages are in pixels of the images.
  double TypicalScale() const;
  // Null if the view is not part of a panorama.
  const ImageWindow* Window(ViewId view) const {
    return files[view].window ? &*files[view].window : nullptr;
  }
};

// The longer side, px, that a file is shrunk to: a panorama is four quarter turns wide. -1 = as
// stored.
int MaxSizeOfFile(bool is_panorama, int max_image_size);

// A view of the set (with a refined camera, maybe), with the name of its image, and pixels of the
// whole image as it is stored, whatever the size at which it is used. Columns of a panorama
// continue across its left border: they run from -1/8 to 7/8 of its width. For tracks: of views
// with a lens cameras stay.
View InStoredImage(const ViewSet& view_set, ViewId id, View view);
std::vector<View> InStoredImages(const ViewSet& view_set, std::vector<View> views);

// Views with pixels as large as those of the images that are read: for lengths in footprints.
std::vector<View> InImagePixels(std::vector<View> views);

// The mask of a file, which is that of its own file and its alpha channel, after max_image_size;
// empty if it has neither. Throws IoError.
std::vector<unsigned char> ReadFileMask(const ViewFile& file, int max_image_size);

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
