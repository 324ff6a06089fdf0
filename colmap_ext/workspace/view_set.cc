// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/view_set.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "limn/model/shrunk.h"
#include "limn/util/errors.h"
#include "limn/util/median.h"

namespace limn::colmap_ext {
namespace {

// From the pixels of a view to those of its file.
class FileLens : public LensMap {
 public:
  FileLens(std::shared_ptr<const LensMap> lens, const Eigen::Array2d& file_per_view,
           const Eigen::Array2d& origin_px)
      : lens_(std::move(lens)), file_per_view_(file_per_view), origin_px_(origin_px) {}

  std::optional<Eigen::Vector2d> VirtualFromStored(const Eigen::Vector2d& file_px) const override {
    const Eigen::Vector2d px =
        ((file_px.array() + 0.5) / file_per_view_ - 0.5 - origin_px_).matrix();
    return lens_->VirtualFromStored(px);
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const override {
    const auto px = lens_->StoredFromVirtual(virtual_px);
    if (!px) return std::nullopt;
    return ((px->array() + origin_px_ + 0.5) * file_per_view_ - 0.5).matrix();
  }

 private:
  std::shared_ptr<const LensMap> lens_;
  Eigen::Array2d file_per_view_;
  Eigen::Array2d origin_px_;  // of the view in the whole image, px of the view
};

// A pinhole with so many pixels per pixel.
View Resized(View view, const Eigen::Array2d& scale) {
  const auto resize = [&](double x, double y) -> Eigen::Vector2d {
    return ((Eigen::Array2d(x, y) + 0.5) * scale - 0.5).matrix();
  };
  PinholeCamera& camera = view.camera;
  camera.fx *= scale.x();
  camera.fy *= scale.y();
  const Eigen::Vector2d center = resize(camera.cx, camera.cy);
  camera.cx = center.x();
  camera.cy = center.y();
  camera.width = static_cast<int>(std::lround(camera.width * scale.x()));
  camera.height = static_cast<int>(std::lround(camera.height * scale.y()));
  ImageRegion& region = view.region;
  region.min_px = resize(region.min_px.x(), region.min_px.y());
  region.max_px = resize(region.max_px.x(), region.max_px.y());
  region.cell_px *= scale.mean();
  return view;
}

Image BlackImage(const ImageSize& size) {
  Image image;
  image.width = size.width;
  image.height = size.height;
  image.channels = 1;
  image.data.assign(size.NumPixels(), 0);
  return image;
}

bool IsLastPart(const ViewSet& set, ViewId view) {
  const size_t next = static_cast<size_t>(view) + 1;
  return next == set.views.size() || set.files[next].image_path != set.files[view].image_path;
}

Image Cut(const Image& image, const ImageWindow& window) {
  Image part;
  part.width = window.width;
  part.height = window.height;
  part.channels = image.channels;
  part.data = CutPixels(image.data, window, image.channels);
  return part;
}

Image ReadPixels(const ViewSet& set, ViewId view) {
  if (set.files[view].is_damaged) return BlackImage(set.ReadSize(view));
  const std::string& path = set.files[view].image_path;
  const auto decode = [&] {
    return set.photos.Read(path, set.MaxFileSize(view), set.files[view].form);
  };
  const ImageWindow* window = set.Window(view);
  if (!window) return decode();
  const auto whole = set.decoded->images.Get(path, IsLastPart(set, view), decode);
  return window->IsOf(whole->width, whole->height) ? Cut(*whole, *window) : *whole;
}

}  // namespace

size_t ViewSet::CountImages(const std::vector<ViewId>& of_views) const {
  std::set<std::string> names;
  for (const ViewId view : of_views) names.insert(ImageName(view));
  return names.size();
}

bool ViewSet::HasPanoramas() const {
  return std::ranges::any_of(files, [](const ViewFile& file) { return file.window.has_value(); });
}

int ViewSet::MaxFileSize(ViewId view) const {
  return MaxSizeOfFile(Window(view) != nullptr, max_image_size);
}

double ViewSet::TypicalScale() const {
  std::vector<double> scales;
  for (const View& view : views) scales.push_back(view.scale);
  return Median(std::move(scales));
}

ImageSize ViewSet::ReadSize(ViewId view) const {
  if (const ImageWindow* window = Window(view)) return {window->width, window->height};
  return ShrunkSize(files[view].stored_size, MaxFileSize(view));
}

int MaxSizeOfFile(bool is_panorama, int max_image_size) {
  return is_panorama && max_image_size > 0 ? 4 * max_image_size : max_image_size;
}

View InStoredImage(const ViewSet& view_set, ViewId id, View view) {
  const ViewFile& file = view_set.files[id];
  const ImageWindow* window = view_set.Window(id);
  const Eigen::Array2d stored(file.stored_size.width, file.stored_size.height);
  const Eigen::Array2d used(window ? window->image_width : view.camera.width,
                            window ? window->image_height : view.camera.height);
  if (!window && (stored == used).all()) return view;
  const Eigen::Array2d origin =
      window ? Eigen::Array2d(window->x, window->y) : Eigen::Array2d(Eigen::Array2d::Zero());
  if (window) view.name = file.image_name;
  if (view.lens) {
    view.lens = std::make_shared<FileLens>(view.lens, stored / used, origin);
  } else {
    view = Resized(std::move(view), stored / used);
    view.scale = 1;
  }
  return view;
}

std::vector<View> InStoredImages(const ViewSet& view_set, std::vector<View> views) {
  for (size_t v = 0; v < views.size(); ++v) {
    views[v] = InStoredImage(view_set, static_cast<ViewId>(v), std::move(views[v]));
  }
  return views;
}

std::vector<View> InImagePixels(std::vector<View> views) {
  for (View& view : views) view = Shrunk(view, view.scale);
  return views;
}

namespace {

bool HasMask(const ViewFile& file) { return !file.mask_path.empty() || file.form.has_mask; }

// Of the image of the view.
std::vector<unsigned char> ReadImageMask(const ViewSet& view_set, ViewId view) {
  if (view_set.files[view].is_damaged) {
    return std::vector<unsigned char>(view_set.ReadSize(view).NumPixels(), 0);
  }
  const ViewFile& file = view_set.files[view];
  const auto decode = [&] { return ReadFileMask(file, view_set.MaxFileSize(view)); };
  const ImageWindow* window = view_set.Window(view);
  if (!window || !HasMask(file)) return decode();
  return CutPixels(
      *view_set.decoded->masks.Get(file.image_path, IsLastPart(view_set, view), decode), *window,
      1);
}

}  // namespace

std::vector<unsigned char> ReadFileMask(const ViewFile& file, int max_image_size) {
  std::vector<unsigned char> mask;
  if (!file.mask_path.empty()) {
    mask = ReadMask(file.mask_path, file.stored_size, max_image_size, file.form.orientation);
  }
  if (!file.form.has_mask) return mask;
  std::vector<unsigned char> alpha = ReadAlpha(file.image_path, max_image_size, file.form);
  if (mask.empty()) return alpha;
  if (alpha.size() != mask.size()) {
    throw IoError(file.image_path, "the image changed its size while Limn was running");
  }
  for (size_t i = 0; i < mask.size(); ++i) mask[i] = mask[i] && alpha[i];
  return mask;
}

std::vector<unsigned char> ReadViewMask(const ViewSet& view_set, ViewId view) {
  const PinholeCamera& camera = view_set.views[view].camera;
  const size_t size = static_cast<size_t>(camera.width) * camera.height;
  std::vector<unsigned char> mask = ReadImageMask(view_set, view);
  if (mask.empty() || mask.size() == size) return mask;
  const ImageSize image = view_set.ReadSize(view);
  std::vector<unsigned char> enlarged(size);
  for (int y = 0; y < camera.height; ++y) {
    const size_t row = (2 * static_cast<size_t>(y) + 1) * image.height / (2 * camera.height);
    for (int x = 0; x < camera.width; ++x) {
      const size_t column = (2 * static_cast<size_t>(x) + 1) * image.width / (2 * camera.width);
      enlarged[static_cast<size_t>(y) * camera.width + x] = mask[row * image.width + column];
    }
  }
  return enlarged;
}

Image ReadViewImage(const ViewSet& view_set, ViewId view) {
  const PinholeCamera& camera = view_set.views[view].camera;
  Image image = ReadPixels(view_set, view);
  const ImageSize expected = view_set.ReadSize(view);
  if (image.width != expected.width || image.height != expected.height) {
    throw IoError(view_set.files[view].image_path,
                  "the image changed its size while Limn was running");
  }
  image.mask = ReadImageMask(view_set, view);
  image.scale = {camera.width / static_cast<double>(image.width),
                 camera.height / static_cast<double>(image.height)};
  return image;
}

void ReleaseDecoded(const ViewSet& view_set) {
  if (!view_set.decoded) return;
  view_set.decoded->images.Clear();
  view_set.decoded->masks.Clear();
}

}  // namespace limn::colmap_ext
