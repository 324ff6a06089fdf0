// SPDX-License-Identifier: BSD-3-Clause
#include "bench/measures/render_drawing.h"

#include <gtest/gtest.h>

#include "limn/formats/small_drawing.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

TEST(RenderDrawing, OrbitSeesTheWholeDrawing) {
  const DrawingGraph graph = SmallDrawing();
  OrbitOptions orbit;
  orbit.kept_share = 1;
  orbit.width = 300;
  orbit.height = 200;
  const Eigen::Vector3d up = Eigen::Vector3d(0.1, 0.2, 1).normalized();
  for (const double azimuth : {0.0, 77.0, 200.0}) {
    orbit.azimuth_deg = azimuth;
    const View view = OrbitView(graph, up, orbit);
    EXPECT_NEAR(view.cam_from_world.rotation.toRotationMatrix().determinant(), 1, 1e-9);
    for (const DrawingLink& link : graph.links) {
      for (const Eigen::Vector3d& point : link.points_in_world) {
        EXPECT_TRUE(view.Project(point)) << azimuth;
      }
    }
    // What is higher in the world is higher in the picture.
    const Eigen::Vector3d center = graph.links[0].points_in_world[0];
    EXPECT_LT(view.Project(center + 0.1 * up)->y(), view.Project(center)->y());
    const Picture picture = RenderDrawing(graph, view);
    EXPECT_EQ(picture.width, 300);
    EXPECT_TRUE(std::any_of(picture.rgb.begin(), picture.rgb.end(),
                            [](uint8_t value) { return value < 100; }));
  }
  EXPECT_THROW(OrbitView({}, up, orbit), InputError);
}

TEST(RenderDrawing, UpIsAgainstTheImagesYAxis) {
  EXPECT_NEAR((UpDirection({View{}}) + Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
  EXPECT_EQ(UpDirection({}), Eigen::Vector3d::UnitZ());
}

}  // namespace
}  // namespace limn
