// SPDX-License-Identifier: BSD-3-Clause
// A straight edge in space, rendered through COLMAP's camera models in COLMAP's pixels, comes back
// where it is: nothing on the way from the file to the edgel shifts by half a pixel or forgets the
// lens.
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/model/camera_projection.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/edges/edge_detection.h"
#include "support/synthetic_image.h"

namespace limn::colmap_ext {
namespace {

// The line from a to b, in front of the camera; it passes the optical axis at some 120 pixels, so
// that a lens bends it.
const Eigen::Vector3d kA(-0.8, 0.35, 2);
const Eigen::Vector3d kB(0.9, 0.65, 2.2);

// Signed distance, pixels of an image `scale` times as large as the camera, to the projected line.
limn::testing::Shape ProjectedSide(const CameraProjection& projection, double scale) {
  const Eigen::Vector3d normal = kA.cross(kB);
  return [&projection, normal, scale](const Eigen::Vector2d& pixel) {
    // Pixel (0, 0) of Limn is the center of the pixel that COLMAP has at (0.5, 0.5).
    const auto side = [&](double dx, double dy) {
      const Eigen::Vector2d colmap_px = (pixel + Eigen::Vector2d(dx + 0.5, dy + 0.5)) / scale;
      const auto ray = projection.RayFromPixel(colmap_px);
      return ray ? normal.dot(Eigen::Vector3d(ray->x(), ray->y(), 1)) : 1.0;
    };
    const double here = side(0, 0);
    const double estimate_px = here / normal.head<2>().norm() * projection.intrinsics().fx * scale;
    if (std::abs(estimate_px) > 30) return estimate_px;
    const Eigen::Vector2d gradient(0.5 * (side(1, 0) - side(-1, 0)),
                                   0.5 * (side(0, 1) - side(0, -1)));
    return here / gradient.norm();
  };
}

// Mean signed distance, stored pixels, of the edgels from the line that the view says it should be.
double Bias(CameraModelId model_id, double scale) {
  const TempDir dir;
  SparseModel model;
  model.cameras = {MakeCamera(model_id, 1)};
  model.images = {{1, Rigid3d(), 1, "line.png", {}}};
  const CameraProjection projection(IntrinsicsOf(model.cameras[0]));
  Image image = limn::testing::ConstantImage(static_cast<int>(800 * scale),
                                             static_cast<int>(600 * scale), {90});
  limn::testing::Paint(ProjectedSide(projection, scale), {150}, &image);
  cv::Mat pixels(image.height, image.width, CV_8UC1);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      pixels.at<uint8_t>(y, x) =
          static_cast<uint8_t>(std::lround(image.data[static_cast<size_t>(y) * image.width + x]));
    }
  }
  EXPECT_TRUE(cv::imwrite((dir / "line.png").string(), pixels));

  const ViewSet set = ToViews(model, dir.path(), {});
  const View& view = set.views.at(0);
  EdgeMap edge_map = DetectEdges(ReadViewImage(set, 0), {});
  const std::vector<bool> usable = ApplyLens(view.lens.get(), &edge_map);
  const Eigen::Vector2d a = view.camera.Project(kA);
  const Eigen::Vector2d along = (view.camera.Project(kB) - a).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  double sum = 0;
  int count = 0;
  for (size_t i = 0; i < edge_map.edgels.size(); ++i) {
    if (!usable[i]) continue;
    const Edgel& edgel = edge_map.edgels[i];
    const double virtual_px = across.dot(edgel.position_px - a);
    const Eigen::Vector2d tangent = edgel.stored_from_virtual.cast<double>() * along;
    const Eigen::Vector2d normal = Eigen::Vector2d(-tangent.y(), tangent.x()).normalized();
    sum += normal.dot(edgel.stored_from_virtual.cast<double>() * (virtual_px * across));
    ++count;
  }
  EXPECT_GT(count, 200 * scale);
  return sum / count;
}

class RenderedLineTest : public ::testing::TestWithParam<CameraModelId> {};

TEST_P(RenderedLineTest, ComesBackWithoutBias) { EXPECT_LT(std::abs(Bias(GetParam(), 1)), 0.05); }

TEST_P(RenderedLineTest, ComesBackWithoutBiasFromASmallerFile) {
  EXPECT_LT(std::abs(Bias(GetParam(), 0.5)), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Models, RenderedLineTest,
                         ::testing::Values(CameraModelId::kPinhole, CameraModelId::kSimpleRadial,
                                           CameraModelId::kOpencv, CameraModelId::kOpencvFisheye));

}  // namespace
}  // namespace limn::colmap_ext
