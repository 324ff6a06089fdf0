#include "colmap_ext/verbs/trust.h"

#include <gtest/gtest.h>

#include "support/synthetic_scene.h"

namespace limn::colmap_ext {
namespace {

// Twelve views of the origin, each four of one image.
ViewSet ThreeImagesInParts() {
  ViewSet set;
  set.views = limn::testing::DomeViews(12, 5);
  for (int v = 0; v < 12; ++v) {
    ViewFile file;
    file.image_name = std::string(1, static_cast<char>('a' + v / 4));
    file.window = ImageWindow{v % 4, 0, 1, 1, 4, 1};
    set.files.push_back(file);
  }
  return set;
}

DrawingLink LinkSeenBy(std::vector<ViewId> views, double length) {
  DrawingLink link;
  link.points_in_world = {{0, 0, 0}, {length, 0, 0}};
  link.sigma = {0.01, 0.01};
  link.supporting_views = std::move(views);
  return link;
}

TEST(MeasureTrust, CountsImagesNotTheirParts) {
  ViewSet set = ThreeImagesInParts();
  DrawingGraph graph;
  graph.links = {LinkSeenBy({0, 1, 4, 5, 8, 9}, 0.75), LinkSeenBy({0, 4, 8}, 0.25)};
  const Trust of_parts = MeasureTrust(set, set.views, {}, graph);
  EXPECT_EQ(of_parts.num_images, 3u);
  EXPECT_EQ(of_parts.well_seen.value(), 0);
  for (size_t v = 0; v < set.files.size(); ++v) set.files[v].image_name = std::to_string(v);
  const Trust of_images = MeasureTrust(set, set.views, {}, graph);
  EXPECT_EQ(of_images.num_images, 12u);
  EXPECT_DOUBLE_EQ(of_images.well_seen.value(), 0.75);
}

TEST(MeasureTrust, TellsWhatHasNoMeasuredDepth) {
  const ViewSet set = ThreeImagesInParts();
  DrawingGraph graph;
  graph.links = {LinkSeenBy({0, 4}, 1), LinkSeenBy({0, 4}, 2), LinkSeenBy({0, 4}, 1)};
  graph.links[1].tentative = graph.links[2].tentative = true;
  graph.links[1].doubt = LinkDoubt::kDepth;
  graph.links[2].doubt = LinkDoubt::kChance;
  const Trust trust = MeasureTrust(set, set.views, {}, graph);
  EXPECT_DOUBLE_EQ(trust.tentative.value(), 0.75);
  EXPECT_DOUBLE_EQ(trust.unmeasured.value(), 0.5);
}

}  // namespace
}  // namespace limn::colmap_ext
