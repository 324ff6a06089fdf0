#include "limn/pipeline/tiled_scene.h"

#include <limits>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// The half of space below or above z = 0.
Eigen::AlignedBox3d Half(bool above) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d low(-kFar, -kFar, above ? 0 : -kFar);
  const Eigen::Vector3d high(kFar, kFar, above ? kFar : 0);
  return {low, high};
}

// A cube in ten views.
class TiledSceneTest : public ::testing::Test {
 protected:
  TiledSceneTest()
      : views_(testing::DomeViews(10, 5)),
        curves_(testing::ProjectCurves(views_, testing::CubeEdges(0.8))),
        all_(views_.size()) {
    std::iota(all_.begin(), all_.end(), 0);
  }

  DrawingGraph Draw(const std::vector<Tile>& tiles, PipelineOptions options = {}) {
    ResultCache cache("");
    const auto curves_of = [&](const SceneSubset& part) {
      CurvesResult result;
      for (const ViewId view : part.ids) result.curves.push_back(curves_[view]);
      return result;
    };
    return DrawTiles({views_, {}, &cache, tiles, curves_of}, options, {},
                     [&](const StageSummary& summary) { Count(summary); });
  }

  void Count(const StageSummary& summary) {
    for (const auto& [what, count] : summary.dropped) dropped_[what] = count;
    for (const auto& [what, count] : summary.kept) kept_[what] = count;
  }

  static double LengthOf(const DrawingGraph& graph) {
    double sum = 0;
    for (const DrawingLink& link : graph.links) sum += Length(link.points_in_world);
    return sum;
  }

  const std::vector<View> views_;
  const std::vector<ImageCurves> curves_;
  std::vector<ViewId> all_;
  std::map<std::string, int64_t> dropped_;
  std::map<std::string, int64_t> kept_;
};

TEST_F(TiledSceneTest, TwoTilesGiveTheWholeCube) {
  const Eigen::AlignedBox3d below(Half(false).min(), Eigen::Vector3d(9, 9, 0.3));
  const Eigen::AlignedBox3d above(Eigen::Vector3d(-9, -9, -0.3), Half(true).max());
  const DrawingGraph graph = Draw({{Half(false), below, all_}, {Half(true), above, all_}});
  EXPECT_NEAR(LengthOf(graph), 12 * 1.6, 0.5);
  EXPECT_EQ(kept_["links joined at borders"], 4);
  EXPECT_EQ(dropped_["tiles: nothing to triangulate"], 0);
}

TEST_F(TiledSceneTest, TilesThatCannotBeDrawnAreTold) {
  const DrawingGraph graph =
      Draw({{Half(false), Half(false), {3}}, {Half(true), Half(true), all_}});
  EXPECT_GT(LengthOf(graph), 4 * 1.6);
  EXPECT_EQ(dropped_["tiles: nothing to triangulate"], 1);
  EXPECT_TRUE(Draw({{Half(false), Half(false), {}}}).links.empty());
}

TEST_F(TiledSceneTest, PosesAreNotRefined) {
  PipelineOptions options;
  options.refinement.refine_poses = true;
  EXPECT_THROW(Draw({{Half(true), Half(true), all_}}, options), OptionError);
}

}  // namespace
}  // namespace limn
