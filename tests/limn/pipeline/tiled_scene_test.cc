// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/tiled_scene.h"

#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "limn/tiles/tile_graphs.h"
#include "limn/util/errors.h"
#include "support/synthetic_image.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using testing::kInfinity;
using testing::LengthOf;
using testing::SlabBetween;

const Eigen::AlignedBox3d kLeft = SlabBetween(-kInfinity, 0);
const Eigen::AlignedBox3d kRight = SlabBetween(0, kInfinity);

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
    // The kinds of edges are no matter here.
    const auto gray = [&](ViewId view) {
      const PinholeCamera& camera = views_[view].camera;
      return testing::ConstantImage(camera.width, camera.height, {128});
    };
    return DrawTiles({views_, {}, &cache, tiles, curves_of, gray}, options, {},
                     [&](const StageSummary& summary) { Count(summary); });
  }

  void Count(const StageSummary& summary) {
    for (const auto& [what, count] : summary.dropped) dropped_[what] = count;
    for (const auto& [what, count] : summary.kept) kept_[what] = count;
  }

  const std::vector<View> views_;
  const std::vector<ImageCurves> curves_;
  std::vector<ViewId> all_;
  std::map<std::string, int64_t> dropped_;
  std::map<std::string, int64_t> kept_;
};

TEST_F(TiledSceneTest, TwoTilesGiveTheWholeCube) {
  const DrawingGraph graph = Draw(
      {{kLeft, SlabBetween(-kInfinity, 0.3), all_}, {kRight, SlabBetween(-0.3, kInfinity), all_}});
  EXPECT_NEAR(LengthOf(graph), 12 * 1.6, 0.5);
  EXPECT_EQ(kept_["links joined at borders"], 4);
  EXPECT_EQ(dropped_["tiles: nothing to triangulate"], 0);
}

TEST_F(TiledSceneTest, TilesThatCannotBeDrawnAreTold) {
  const DrawingGraph graph = Draw({{kLeft, kLeft, {3}}, {kRight, kRight, all_}});
  EXPECT_GT(LengthOf(graph), 4 * 1.6);
  EXPECT_EQ(dropped_["tiles: nothing to triangulate"], 1);
  EXPECT_TRUE(Draw({{kLeft, kLeft, {}}}).links.empty());
}

}  // namespace
}  // namespace limn
