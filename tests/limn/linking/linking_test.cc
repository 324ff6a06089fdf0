// SPDX-License-Identifier: BSD-3-Clause
#include "limn/linking/linking.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "limn/edges/edge_detection.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

using Eigen::Vector2d;
using testing::AddNoise;
using testing::ConstantImage;
using testing::Disc;
using testing::HalfPlane;
using testing::Paint;
using testing::Polygon;
using testing::Quantize;

LinkingResult DetectAndLink(const Image& image, const LinkingOptions& options = {}) {
  return LinkEdgels(DetectEdges(image, {}), options);
}

double LengthOf(const LinkingResult& result, const CurveFragment& fragment) {
  const auto& edgels = result.curves.edge_map.edgels;
  double length = 0;
  for (size_t i = 1; i < fragment.edgel_ids.size(); ++i) {
    length +=
        (edgels[fragment.edgel_ids[i]].position_px - edgels[fragment.edgel_ids[i - 1]].position_px)
            .norm();
  }
  return length;
}

// What holds for every result: accounting, one fragment per edgel, steps along the tangents.
void CheckInvariants(const LinkingResult& result) {
  const LinkingStats& stats = result.stats;
  const auto& edgels = result.curves.edge_map.edgels;
  EXPECT_EQ(stats.edgels, static_cast<int64_t>(edgels.size()));
  EXPECT_EQ(stats.edgels, stats.edgels_in_fragments + stats.edgels_in_texture +
                              stats.edgels_unlinked + stats.edgels_in_short_chains);
  EXPECT_EQ(stats.fragments, static_cast<int64_t>(result.curves.fragments.size()));
  std::set<EdgelId> used;
  for (const CurveFragment& fragment : result.curves.fragments) {
    const size_t n = fragment.edgel_ids.size();
    for (size_t i = 0; i < n; ++i) {
      EXPECT_TRUE(used.insert(fragment.edgel_ids[i]).second) << "edgel in two fragments";
      if (i + 1 == n && !fragment.closed) break;
      const Edgel& from = edgels[fragment.edgel_ids[i]];
      const Edgel& to = edgels[fragment.edgel_ids[(i + 1) % n]];
      const Vector2d step = to.position_px - from.position_px;
      EXPECT_LE(step.norm(), 4.01);
      EXPECT_GT(from.Tangent().dot(to.Tangent()), 0);
      EXPECT_GT(step.dot(from.Tangent()) + step.dot(to.Tangent()), 0);
    }
  }
  EXPECT_EQ(stats.edgels_in_fragments, static_cast<int64_t>(used.size()));
  EXPECT_TRUE(std::is_sorted(result.link_graph.begin(), result.link_graph.end(),
                             [](const EdgelLink& a, const EdgelLink& b) {
                               return std::pair(a.a, a.b) < std::pair(b.a, b.b);
                             }));
  for (const EdgelLink& link : result.link_graph) {
    EXPECT_LT(link.a, link.b);
    EXPECT_GT(link.votes, 0);
  }
}

TEST(LinkEdgels, SquareBreaksAtCorners) {
  for (const double turn : {0.0, 17.0, 45.0}) {
    Image image = ConstantImage(120, 120, {60});
    std::vector<Vector2d> corners;
    for (int k = 0; k < 4; ++k) {
      const double angle = (turn + 90 * k) * kDeg;
      corners.push_back(Vector2d(60.2, 59.7) + 40 * Vector2d(std::cos(angle), std::sin(angle)));
    }
    Paint(Polygon(corners), {140}, &image);
    const LinkingResult result = DetectAndLink(image);
    CheckInvariants(result);
    ASSERT_EQ(result.curves.fragments.size(), 4u) << turn;
    for (const CurveFragment& fragment : result.curves.fragments) {
      EXPECT_FALSE(fragment.closed);
      EXPECT_GT(LengthOf(result, fragment), 40 * std::numbers::sqrt2 - 6);
    }
  }
}

TEST(LinkEdgels, CircleIsOneClosedFragment) {
  for (const double radius : {6.0, 8.0, 20.0, 40.0}) {
    for (const float inside : {50.f, 150.f}) {
      Image image = ConstantImage(120, 120, {100});
      Paint(Disc(Vector2d(60.2, 59.6), radius), {inside}, &image);
      const LinkingResult result = DetectAndLink(image);
      CheckInvariants(result);
      ASSERT_EQ(result.curves.fragments.size(), 1u) << radius;
      EXPECT_TRUE(result.curves.fragments[0].closed) << radius;
      EXPECT_GT(result.stats.edgels_in_fragments, 0.95 * result.stats.edgels);
    }
  }
}

TEST(LinkEdgels, NoisyCircle) {
  Image image = ConstantImage(160, 160, {100});
  const Vector2d center(80.2, 79.6);
  Paint(Disc(center, 50), {120}, &image);
  AddNoise(5, 4, &image);
  const LinkingResult result = DetectAndLink(image);
  CheckInvariants(result);
  double on_circle = 0;
  int pieces = 0;
  for (const CurveFragment& fragment : result.curves.fragments) {
    const Edgel& middle =
        result.curves.edge_map.edgels[fragment.edgel_ids[fragment.edgel_ids.size() / 2]];
    if (std::abs((middle.position_px - center).norm() - 50) > 1.5) continue;
    on_circle += LengthOf(result, fragment);
    ++pieces;
  }
  EXPECT_GT(on_circle, 0.95 * 2 * std::numbers::pi * 50);
  EXPECT_LE(pieces, 3);
}

// A bright half plane above, and below it one side brighter than the other: the stem ends at the
// bar.
Image TeeImage() {
  Image image = ConstantImage(120, 120, {60});
  Paint(HalfPlane(Vector2d(60.3, 60), Vector2d(1, 0)), {100}, &image);
  Paint(HalfPlane(Vector2d(60, 50.4), Vector2d(0, -1)), {180}, &image);
  return image;
}

TEST(LinkEdgels, TeeMakesThreeFragments) {
  const LinkingResult result = DetectAndLink(TeeImage());
  CheckInvariants(result);
  EXPECT_EQ(result.curves.fragments.size(), 3u);
  EXPECT_EQ(result.stats.junction_breaks, 1);
}

TEST(LinkEdgels, NoiseMakesFewFragments) {
  Image image = ConstantImage(256, 256, {128});
  AddNoise(5, 11, &image);
  Quantize(&image);
  const LinkingResult result = DetectAndLink(image);
  CheckInvariants(result);
  std::cout << "noise 5: " << result.stats.fragments << " fragments in 240 x 240 px\n";
  EXPECT_LT(result.stats.fragments, 30);
}

TEST(LinkEdgels, LongNoisyEdge) {
  double before = 0;
  double after = 0;
  int count = 0;
  for (int degrees = 0; degrees < 180; degrees += 20) {
    const Vector2d normal(std::cos(degrees * kDeg), std::sin(degrees * kDeg));
    const Vector2d point(100.2, 100.4);
    Image image = ConstantImage(200, 200, {100});
    Paint(HalfPlane(point, normal), {120}, &image);
    AddNoise(5, degrees, &image);
    Quantize(&image);
    const EdgeMap detected = DetectEdges(image, {});
    const LinkingResult result = LinkEdgels(detected, {});
    CheckInvariants(result);
    int long_fragments = 0;
    double length = 0;
    for (const CurveFragment& fragment : result.curves.fragments) {
      const Edgel& middle = detected.edgels[fragment.edgel_ids[fragment.edgel_ids.size() / 2]];
      if (std::abs((middle.position_px - point).dot(normal)) > 1.5) continue;
      ++long_fragments;
      length += LengthOf(result, fragment);
      for (const EdgelId id : fragment.edgel_ids) {
        before += std::pow(std::asin(detected.edgels[id].Tangent().dot(normal)), 2);
        after += std::pow(std::asin(result.curves.edge_map.edgels[id].Tangent().dot(normal)), 2);
        // Positions stay what the detector found.
        EXPECT_EQ(result.curves.edge_map.edgels[id].position_px, detected.edgels[id].position_px);
        ++count;
      }
    }
    EXPECT_LE(long_fragments, 2) << degrees;
    EXPECT_GT(length, 175) << degrees;
  }
  const double rms_before = std::sqrt(before / count) / kDeg;
  const double rms_after = std::sqrt(after / count) / kDeg;
  std::cout << "tangents at contrast 20, noise 5: " << rms_before << " degrees detected, "
            << rms_after << " refitted\n";
  EXPECT_LT(rms_after, 0.6 * rms_before);
}

TEST(LinkEdgels, RefittedTangentsOfACircle) {
  Image image = ConstantImage(100, 100, {50});
  const Vector2d center(50.3, 49.8);
  Paint(Disc(center, 12), {150}, &image);
  const LinkingResult result = DetectAndLink(image);
  for (const EdgelId id : result.curves.fragments.at(0).edgel_ids) {
    const Edgel& edgel = result.curves.edge_map.edgels[id];
    const Vector2d ray = (edgel.position_px - center).normalized();
    EXPECT_LT(std::abs(std::asin(edgel.Tangent().dot(ray))) / kDeg, 1.5);
    EXPECT_LT(edgel.Normal().dot(ray), 0);  // bright inside
  }
}

// Edgels on a horizontal line from x0 to x1, one per pixel.
void AddLine(double x0, double x1, double y, double tangent_rad, EdgeMap* map) {
  for (double x = x0; x <= x1; x += 1) {
    Edgel edgel;
    edgel.position_px = Vector2d(x, y);
    edgel.tangent_rad = tangent_rad;
    edgel.strength = 10;
    edgel.position_sigma_px = 0.1f;
    map->edgels.push_back(edgel);
  }
}

TEST(LinkEdgels, BridgesAGapOfThreePixels) {
  EdgeMap map;
  AddLine(10, 30, 20, 0, &map);
  AddLine(33, 60, 20.2, 0, &map);
  LinkingOptions options;
  options.neighbor_radius_px = 2.5;
  const LinkingResult bridged = LinkEdgels(map, options);
  CheckInvariants(bridged);
  EXPECT_EQ(bridged.curves.fragments.size(), 1u);
  EXPECT_EQ(bridged.stats.bridged_gaps, 1);
  options.max_bridge_px = 2;
  EXPECT_EQ(LinkEdgels(map, options).curves.fragments.size(), 2u);
}

TEST(LinkEdgels, TextureIsNotLinked) {
  EdgeMap map;
  AddLine(10, 60, 20, 0, &map);
  const LinkingResult alone = LinkEdgels(map, {});
  AddLine(10, 60, 40, 0, &map);
  const auto num_of_line = static_cast<EdgelId>(alone.curves.edge_map.edgels.size());
  // The first line is texture: ids of the second one stay.
  for (EdgelId id = 0; id < num_of_line; ++id) map.texture.push_back(id);
  const LinkingResult result = LinkEdgels(map, {});
  CheckInvariants(result);
  EXPECT_EQ(result.stats.edgels_in_texture, num_of_line);
  ASSERT_EQ(result.curves.fragments.size(), 1u);
  ASSERT_EQ(alone.curves.fragments.size(), 1u);
  std::vector<EdgelId> ids = alone.curves.fragments[0].edgel_ids;
  for (EdgelId& id : ids) id += num_of_line;
  EXPECT_EQ(result.curves.fragments[0].edgel_ids, ids);
  ASSERT_EQ(result.link_graph.size(), alone.link_graph.size());
  EXPECT_EQ(result.link_graph[3].a, alone.link_graph[3].a + num_of_line);
}

TEST(LinkEdgels, OpposedPolarityIsNotLinked) {
  EdgeMap map;
  AddLine(10, 30, 20, 0, &map);
  AddLine(31, 50, 20, std::numbers::pi, &map);
  const LinkingResult result = LinkEdgels(map, {});
  CheckInvariants(result);
  ASSERT_EQ(result.curves.fragments.size(), 2u);
  // Each runs along its tangents: the second one from right to left.
  EXPECT_EQ(result.curves.fragments[0].edgel_ids.front(), 0);
  EXPECT_EQ(result.curves.fragments[1].edgel_ids.front(), 40);
}

TEST(LinkEdgels, ParallelStrandsStayApart) {
  EdgeMap map;
  AddLine(10, 60, 20, 0, &map);
  AddLine(10.3, 60, 22, 0, &map);
  const LinkingResult result = LinkEdgels(map, {});
  CheckInvariants(result);
  ASSERT_EQ(result.curves.fragments.size(), 2u);
  for (const CurveFragment& fragment : result.curves.fragments) {
    const double y = result.curves.edge_map.edgels[fragment.edgel_ids[0]].position_px.y();
    for (const EdgelId id : fragment.edgel_ids) {
      EXPECT_EQ(result.curves.edge_map.edgels[id].position_px.y(), y);
    }
  }
}

TEST(LinkEdgels, Deterministic) {
  Image image = TeeImage();
  AddNoise(8, 2, &image);
  const LinkingResult first = DetectAndLink(image);
  const LinkingResult second = DetectAndLink(image);
  ASSERT_EQ(first.curves.fragments.size(), second.curves.fragments.size());
  for (size_t i = 0; i < first.curves.fragments.size(); ++i) {
    EXPECT_EQ(first.curves.fragments[i].edgel_ids, second.curves.fragments[i].edgel_ids);
  }
}

TEST(LinkEdgels, HypothesesAtForks) {
  Image image = TeeImage();
  Paint(Disc(Vector2d(80, 85), 14), {120}, &image);
  AddNoise(8, 2, &image);
  LinkingOptions options;
  options.forks = ForkChoice::kHypotheses;
  const LinkingResult result = LinkEdgels(DetectEdges(image, {}), options, &image);
  CheckInvariants(result);
  EXPECT_GT(result.stats.changed_forks, 0);
  EXPECT_EQ(DetectAndLink(image).stats.changed_forks, 0);
}

TEST(LinkEdgels, EmptyAndSingle) {
  CheckInvariants(LinkEdgels({}, {}));
  EdgeMap map;
  AddLine(10, 10, 20, 0, &map);
  const LinkingResult result = LinkEdgels(map, {});
  CheckInvariants(result);
  EXPECT_EQ(result.stats.edgels_unlinked, 1);
  EXPECT_TRUE(result.curves.fragments.empty());
}

TEST(LinkEdgels, BadOptions) {
  LinkingOptions options;
  options.max_bridge_px = -1;
  EXPECT_THROW(LinkEdgels({}, options), OptionError);
}

}  // namespace
}  // namespace limn
