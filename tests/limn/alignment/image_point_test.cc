// SPDX-License-Identifier: BSD-3-Clause
#include "limn/alignment/image_point.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/alignment/drawing_span.h"
#include "limn/alignment/known_lengths.h"
#include "limn/alignment/wire_room.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// A camera at the origin that looks along z, and links before it, the second in front of the first.
class ImagePointTest : public ::testing::Test {
 protected:
  ImagePointTest() {
    testing::AddLine({-1, 0, 4}, {3, 0, 8}, &graph_);
    testing::AddLine({-1, 0.01, 2}, {1, 0.01, 2}, &graph_);
    RebuildIncidence(&graph_);
  }

  // COLMAP's pixel of a point.
  ImagePoint At(const Eigen::Vector3d& point) const {
    return {"a.jpg", *view_.Project(point) + Eigen::Vector2d(0.5, 0.5)};
  }
  DrawingPlace Snap(const ImagePoint& point) const {
    return SnapToDrawing(point, view_, 0, graph_);
  }

  View view_ = testing::ForwardView(401, 401, 200);
  DrawingGraph graph_;
};

TEST_F(ImagePointTest, TheLinkInFrontIsMeant) {
  const DrawingPlace place = Snap(At({0.25, 0.01, 2}));
  EXPECT_EQ(place.link, 1);
  EXPECT_LT((place.position - Eigen::Vector3d(0.25, 0.01, 2)).norm(), 1e-9);
  EXPECT_NEAR(place.distance_px, 0, 1e-9);
}

TEST_F(ImagePointTest, LinksThatTheImageSupportsComeFirst) {
  graph_.links[0].supporting_views = {0};
  const Eigen::Vector3d on_first(0, 0, 5);
  EXPECT_LT((Snap(At(on_first)).position - on_first).norm(), 1e-9);
}

// In space the middle of what is seen is nearer to the far end.
TEST_F(ImagePointTest, PlacesAreThoseInSpace) {
  graph_.links[0].supporting_views = {0};
  for (const double share : {0.1, 0.3, 0.45}) {
    const Eigen::Vector3d on_first(-1 + 4 * share, 0, 4 + 4 * share);
    ImagePoint point = At(on_first);
    point.pixel.y() += 3;
    const DrawingPlace place = Snap(point);
    EXPECT_LT((place.position - on_first).norm(), 1e-9);
    EXPECT_NEAR(place.distance_px, 3, 1e-9);
  }
}

// The image shows the end behind the camera, or beside it, of no link.
TEST_F(ImagePointTest, LinksThatAreSeenInPartAreFound) {
  testing::AddLine({0, 0.5, 6}, {0, 0.5, -3}, &graph_);
  testing::AddLine({0, -0.5, 4}, {40, -0.5, 4}, &graph_);
  RebuildIncidence(&graph_);
  for (const Eigen::Vector3d& on_link : {Eigen::Vector3d(0, 0.5, 5), Eigen::Vector3d(2, -0.5, 4)}) {
    EXPECT_LT((Snap(At(on_link)).position - on_link).norm(), 1e-9);
  }
}

// Across by the link, along by how well a pixel is clicked, here 2 / focal length.
TEST_F(ImagePointTest, PlacesTellTheirCovariance) {
  const Eigen::Vector3d sigmas = Snap(At({0, 0.01, 2})).covariance.diagonal().cwiseSqrt();
  const double click = kClickSigmaPx * 2 / view_.camera.fx;
  EXPECT_NEAR(sigmas.y(), graph_.links[0].sigma[0], 1e-9);
  EXPECT_NEAR(sigmas.x(), std::hypot(sigmas.y(), click), 1e-9);
}

TEST_F(ImagePointTest, AnUnknownSigmaStaysUnknown) {
  graph_.links[1].sigma = {0.0005, std::numeric_limits<double>::infinity()};
  EXPECT_TRUE(Snap(At({-1, 0.01, 2})).covariance.isZero());
}

TEST_F(ImagePointTest, PixelsWithoutALinkAreAnError) {
  EXPECT_THAT(
      [&] {
        Snap({"a.jpg", {100.5, 50.5}});
      },
      ThrowsMessage<InputError>("no link of the drawing is within 6 px of a.jpg 100.5,50.5"));
}

TEST(DrawingSpan, IsALinkTwoNodesOrTwoPixels) {
  EXPECT_EQ(ParseSpan("link 12 ")->link, 12);
  EXPECT_EQ(ParseSpan("from 3 to 7")->node1, 7);
  for (const char* text : {"sub/a b.jpg 120,340.5 to c.jpg 500,220",
                           "from sub/a b.jpg 120,340.5  to c.jpg 500,220 "}) {
    const auto span = ParseSpan(text);
    ASSERT_TRUE(span) << text;
    ASSERT_EQ(span->pixels.size(), 2u);
    EXPECT_EQ(span->pixels[0].image, "sub/a b.jpg");
    EXPECT_EQ(span->pixels[0].pixel, Eigen::Vector2d(120, 340.5));
    EXPECT_EQ(span->pixels[1].image, "c.jpg");
    EXPECT_EQ(span->pixels[1].pixel, Eigen::Vector2d(500, 220));
  }
  for (const char* text : {"", "link", "a.jpg 1,2", "a.jpg 1,2 to", "a.jpg 1,2 to b.jpg 3",
                           "a.jpg 1..2,2 to b.jpg 3,4", "1,2 to 3,4"}) {
    EXPECT_FALSE(ParseSpan(text)) << text;
  }
}

TEST_F(ImagePointTest, LengthsBetweenPixelsTellTheScale) {
  auto lengths = ParseKnownLengths({"a.jpg 1,2 to a.jpg 3,4 = 3 m"});
  for (const double x : {-0.5, 0.5}) {
    lengths[0].span.places.push_back(Snap(At({x, 0.01, 2})));
  }
  const LengthFit fit = FitLengths(graph_, lengths);
  EXPECT_NEAR(fit.scale, 3, 1e-9);
  lengths[0].span.places[1] = lengths[0].span.places[0];
  EXPECT_THAT([&] { FitLengths(graph_, lengths); },
              ThrowsMessage<OptionError>(HasSubstr("both places are the same")));
}

}  // namespace
}  // namespace limn
