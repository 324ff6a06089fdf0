// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/panorama.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "limn/util/angles.h"

namespace limn::colmap_ext {
namespace {

// As LensMap says.
constexpr double kMaxOffAxisRad = 75 * kDeg;
// Of the borders between rings of parts, from above.
constexpr double kElevationsDeg[] = {80, 30, -30, -80};
constexpr int kPartsPerRing = 4;

// Azimuth from the middle of the image to the right, and elevation, of a place in COLMAP's pixels.
struct Sphere {
  double width, height;

  double Azimuth(double x) const { return 2 * M_PI * (x / width - 0.5); }
  double Elevation(double y) const { return M_PI * (0.5 - y / height); }
  double X(double azimuth) const { return width * (azimuth / (2 * M_PI) + 0.5); }
  double Y(double elevation) const { return height * (0.5 - elevation / M_PI); }
};

Eigen::Vector3d RayOf(double azimuth, double elevation) {
  return {std::cos(elevation) * std::sin(azimuth), -std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

class PartLensMap : public LensMap {
 public:
  // `azimuth` is that of the middle of the window, by its columns.
  PartLensMap(const PanoramaPart& part, double azimuth)
      : window_(part.window),
        camera_(part.camera),
        part_from_image_(part.part_from_image.toRotationMatrix()),
        azimuth_(azimuth) {}

  std::optional<Eigen::Vector2d> VirtualFromStored(
      const Eigen::Vector2d& stored_px) const override {
    const Sphere sphere = SphereOfImage();
    const double elevation = sphere.Elevation(stored_px.y() + window_.y + 0.5);
    if (std::abs(elevation) > M_PI / 2) return std::nullopt;
    const double azimuth = sphere.Azimuth(stored_px.x() + window_.x + 0.5);
    if (std::abs(azimuth - azimuth_) > M_PI) return std::nullopt;
    const Eigen::Vector3d ray = part_from_image_ * RayOf(azimuth, elevation);
    if (ray.z() < std::cos(kMaxOffAxisRad)) return std::nullopt;
    return camera_.Project(ray);
  }

  std::optional<Eigen::Vector2d> StoredFromVirtual(
      const Eigen::Vector2d& virtual_px) const override {
    const Sphere sphere = SphereOfImage();
    const Eigen::Vector3d ray = camera_.RayFromPixel(virtual_px).normalized();
    if (ray.z() < std::cos(kMaxOffAxisRad)) return std::nullopt;
    const Eigen::Vector3d in_image = part_from_image_.transpose() * ray;
    const double turned = std::atan2(in_image.x(), in_image.z()) - azimuth_;
    const double elevation = std::asin(std::clamp(-in_image.y(), -1.0, 1.0));
    const double azimuth = azimuth_ + std::remainder(turned, 2 * M_PI);
    return Eigen::Vector2d(sphere.X(azimuth) - 0.5 - window_.x,
                           sphere.Y(elevation) - 0.5 - window_.y);
  }

 private:
  Sphere SphereOfImage() const {
    return {static_cast<double>(window_.image_width), static_cast<double>(window_.image_height)};
  }

  ImageWindow window_;
  PinholeCamera camera_;
  Eigen::Matrix3d part_from_image_;
  double azimuth_;
};

// Looks at this direction with a level x axis.
Eigen::Quaterniond LookingAt(double azimuth, double elevation) {
  const Eigen::Vector3d z = RayOf(azimuth, elevation);
  const Eigen::Vector3d x(std::cos(azimuth), 0, -std::sin(azimuth));
  Eigen::Matrix3d part_from_image;
  part_from_image << x.transpose(), z.cross(x).transpose(), z.transpose();
  return Eigen::Quaterniond(part_from_image);
}

PanoramaPart PartOf(const ImageWindow& window) {
  const Sphere sphere{static_cast<double>(window.image_width),
                      static_cast<double>(window.image_height)};
  const double azimuth = sphere.Azimuth(window.x + window.width / 2.0);
  const double elevation = sphere.Elevation(window.y + window.height / 2.0);
  PanoramaPart part;
  part.window = window;
  part.part_from_image = LookingAt(azimuth, elevation);
  part.camera.fx = part.camera.fy = sphere.width / (2 * M_PI);
  part.camera.cx = (window.width - 1) / 2.0;
  part.camera.cy = (window.height - 1) / 2.0;
  part.camera.width = window.width;
  part.camera.height = window.height;
  part.lens = std::make_shared<PartLensMap>(part, azimuth);
  return part;
}

}  // namespace

Eigen::Vector2d ImageWindow::WindowFromImage(const Eigen::Vector2d& image_px) const {
  const double middle = x + width / 2.0;
  const double column = middle + std::remainder(image_px.x() - middle, image_width);
  return {column - x, image_px.y() - y};
}

std::vector<PanoramaPart> PanoramaParts(int width, int height, int margin_px) {
  const Sphere sphere{static_cast<double>(width), static_cast<double>(height)};
  // So that the middle of the image is in the middle of a part.
  const auto column = [&](int k) {
    return static_cast<int>(std::lround(width * ((k - 0.5) / kPartsPerRing)));
  };
  const auto row = [&](int ring) {
    return static_cast<int>(std::lround(sphere.Y(kElevationsDeg[ring] * kDeg)));
  };
  std::vector<PanoramaPart> parts;
  for (int ring = 0; ring < kNumPanoramaParts / kPartsPerRing; ++ring) {
    const int top = std::max(row(ring) - margin_px, 0);
    const int bottom = std::min(row(ring + 1) + margin_px, height);
    for (int k = 0; k < kPartsPerRing; ++k) {
      const int left = column(k) - margin_px, right = column(k + 1) + margin_px;
      parts.push_back(PartOf({left, top, right - left, bottom - top, width, height}));
    }
  }
  return parts;
}

}  // namespace limn::colmap_ext
