#include "colmap_ext/workspace/view_set.h"

#include <algorithm>
#include <set>
#include <utility>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// From the pixels of a part to those of the image.
class WholeImageLens : public LensMap {
 public:
  WholeImageLens(std::shared_ptr<const LensMap> part, const ImageWindow& window)
      : part_(std::move(part)), origin_px_(window.x, window.y) {}

  std::optional<Eigen::Vector2d> VirtualFromStored(
      const Eigen::Vector2d& stored_px) const override {
    return part_->VirtualFromStored(stored_px - origin_px_);
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const override {
    const auto stored_px = part_->StoredFromVirtual(virtual_px);
    if (!stored_px) return std::nullopt;
    return *stored_px + origin_px_;
  }

 private:
  std::shared_ptr<const LensMap> part_;
  Eigen::Vector2d origin_px_;
};

Image BlackImage(int width, int height) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = 1;
  image.data.assign(static_cast<size_t>(width) * height, 0);
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
  const std::string& path = set.files[view].image_path;
  const auto decode = [&] { return set.photos.Read(path, set.MaxFileSize(view)); };
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

int MaxSizeOfFile(bool is_panorama, int max_image_size) {
  return is_panorama && max_image_size > 0 ? 4 * max_image_size : max_image_size;
}

std::vector<View> InWholeImages(const ViewSet& view_set, std::vector<View> views) {
  for (size_t v = 0; v < views.size(); ++v) {
    const ImageWindow* window = view_set.Window(static_cast<ViewId>(v));
    if (!window) continue;
    views[v].name = view_set.files[v].image_name;
    views[v].lens = std::make_shared<WholeImageLens>(views[v].lens, *window);
  }
  return views;
}

std::vector<unsigned char> ReadViewMask(const ViewSet& view_set, ViewId view) {
  const PinholeCamera& camera = view_set.views[view].camera;
  if (view_set.files[view].is_damaged) {
    return std::vector<unsigned char>(static_cast<size_t>(camera.width) * camera.height, 0);
  }
  const std::string& path = view_set.files[view].mask_path;
  if (path.empty()) return {};
  const auto decode = [&] {
    return ReadMask(path, view_set.files[view].stored_size, view_set.MaxFileSize(view));
  };
  const ImageWindow* window = view_set.Window(view);
  if (!window) return decode();
  return CutPixels(*view_set.decoded->masks.Get(path, IsLastPart(view_set, view), decode), *window,
                   1);
}

Image ReadViewImage(const ViewSet& view_set, ViewId view) {
  const PinholeCamera& camera = view_set.views[view].camera;
  Image image;
  if (view_set.files[view].is_damaged) {
    image = BlackImage(camera.width, camera.height);
  } else {
    image = ReadPixels(view_set, view);
  }
  if (image.width != camera.width || image.height != camera.height) {
    throw IoError(view_set.files[view].image_path,
                  "the image changed its size while Limn was running");
  }
  image.mask = ReadViewMask(view_set, view);
  return image;
}

void ReleaseDecoded(const ViewSet& view_set) {
  if (!view_set.decoded) return;
  view_set.decoded->images.Clear();
  view_set.decoded->masks.Clear();
}

}  // namespace limn::colmap_ext
