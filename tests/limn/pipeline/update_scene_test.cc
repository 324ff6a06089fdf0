// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/update_scene.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/temporary_folder.h"
#include "limn/geometry/polyline.h"
#include "limn/tiles/tile_graphs.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::LengthOf;

// Views that show the rod; too few of them are left without 6, 11 and 16.
const std::vector<int> kWithRod = {1, 2, 6, 11, 14, 16};
const std::vector<int> kOldWithRod = {1, 2, 14};

// A cube in thirty views, of which some are drawn first. Some of the views show a rod beside it.
class UpdateSceneTest : public ::testing::Test {
 protected:
  UpdateSceneTest() : all_views_(testing::DomeViews(30, 5)) {}

  // The views now, and those of them that show the rod.
  void See(const std::vector<int>& views, const std::vector<int>& with_rod) {
    views_.clear();
    curves_.clear();
    for (const int v : views) {
      views_.push_back(all_views_[v]);
      views_.back().name = "view " + std::to_string(100 + v);
      std::vector<testing::SceneCurve> scene = testing::CubeEdges(0.6);
      if (std::ranges::count(with_rod, v) > 0) scene.push_back(rod_);
      curves_.push_back(testing::ProjectCurves(views_.back(), scene));
    }
  }

  PipelineInput Input() { return {views_, hints_, images_, box_, &cache_}; }

  DrawingGraph Draw() {
    const DrawnCurves drawn =
        DrawCurves({views_, curves_, hints_, box_}, options_, &cache_, {}, ignore_);
    DrawingGraph graph =
        RefineAndJudge({{views_, curves_}, drawn.drawing.graph}, options_, {}, ignore_);
    graph = DescribeLinks(std::move(graph), views_, images_.read, options_, {}, ignore_);
    RecordWriter(Input(), curves_, drawn.sketch.plans, graph, options_, {})();
    return graph;
  }

  std::optional<PipelineResult> Update() {
    std::vector<ImageCurves> curves = curves_;
    counts_.clear();
    auto result = UpdateScene(
        Input(), &curves, options_, {},
        [&](const StageSummary& summary) {
          if (summary.stage != "update") return;
          for (const auto& [what, count] : summary.kept) counts_[what] = count;
          for (const auto& [what, count] : summary.dropped) counts_[what] = count;
        },
        &why_not_);
    if (result) result->keep();
    EXPECT_THAT(result ? Validate(result->graph) : std::vector<std::string>(), IsEmpty());
    return result;
  }

  bool HasRod(const DrawingGraph& graph) const {
    double length = 0;
    for (const DrawingLink& link : graph.links) {
      for (size_t k = 1; k < link.points_in_world.size(); ++k) {
        const Eigen::Vector3d& a = link.points_in_world[k - 1];
        const Eigen::Vector3d& b = link.points_in_world[k];
        const auto on_rod = [&](const Eigen::Vector3d& point) {
          return std::sqrt(ClosestPoint(rod_.points, point).squared_distance) < 0.01;
        };
        if (on_rod(a) && on_rod(b)) length += (b - a).norm();
      }
    }
    return length > 0.9 * Length(rod_.points);
  }

  static std::vector<int> Numbers(int count, std::vector<int> without = {}) {
    std::vector<int> numbers;
    for (int i = 0; i < count; ++i) {
      if (std::ranges::count(without, i) == 0) numbers.push_back(i);
    }
    return numbers;
  }

  const std::vector<View> all_views_;
  const testing::SceneCurve rod_ = testing::Segment({-0.5, -0.9, -0.6}, {0.5, -0.9, -0.6});
  TemporaryFolder folder_;
  ResultCache cache_{folder_.Path("cache")};
  std::vector<View> views_;
  std::vector<ImageCurves> curves_;
  SceneHints hints_;
  ImageSource images_;
  std::optional<Eigen::AlignedBox3d> box_;
  PipelineOptions options_;
  StageObserver ignore_ = [](const StageSummary&) {};
  std::map<std::string, int64_t> counts_;
  std::string why_not_;
};

TEST_F(UpdateSceneTest, WithoutChangesTheDrawingIsTheSame) {
  See(Numbers(30), {});
  const DrawingGraph drawn = Draw();
  ASSERT_NEAR(LengthOf(drawn), 12 * 1.2, 0.3);
  const auto updated = Update();
  ASSERT_TRUE(updated) << why_not_;
  EXPECT_EQ(counts_["images: new or changed"], 0);
  EXPECT_EQ(counts_["places drawn again"], 0);
  EXPECT_THAT(*updated->new_views, IsEmpty());
  ASSERT_EQ(updated->graph.links.size(), drawn.links.size());
  for (size_t l = 0; l < drawn.links.size(); ++l) {
    EXPECT_EQ(updated->graph.links[l].points_in_world, drawn.links[l].points_in_world);
    EXPECT_EQ(updated->graph.links[l].supporting_views, drawn.links[l].supporting_views);
  }
}

TEST_F(UpdateSceneTest, ANewViewOfWhatIsDrawnJoinsItsSupport) {
  See(Numbers(30, {7}), {});
  const DrawingGraph drawn = Draw();
  See(Numbers(30), {});
  const auto updated = Update();
  ASSERT_TRUE(updated) << why_not_;
  EXPECT_EQ(counts_["images: unchanged"], 29);
  EXPECT_EQ(counts_["images: new or changed"], 1);
  EXPECT_EQ(counts_["places drawn again"], 0);
  EXPECT_EQ(*updated->new_views, std::vector<ViewId>{7});
  ASSERT_EQ(updated->graph.links.size(), drawn.links.size());
  for (size_t l = 0; l < drawn.links.size(); ++l) {
    EXPECT_EQ(updated->graph.links[l].points_in_world, drawn.links[l].points_in_world);
    // Those of before, whose ids have moved from the seventh on, and the new one.
    std::vector<ViewId> expected = {7};
    for (const ViewId v : drawn.links[l].supporting_views) expected.push_back(v + (v >= 7));
    std::ranges::sort(expected);
    EXPECT_EQ(updated->graph.links[l].supporting_views, expected);
  }
}

TEST_F(UpdateSceneTest, WhatNewViewsShowIsDrawn) {
  See(Numbers(30, {6, 11, 16}), kWithRod);
  EXPECT_FALSE(HasRod(Draw()));
  See(Numbers(30), kWithRod);
  const auto updated = Update();
  ASSERT_TRUE(updated) << why_not_;
  EXPECT_GE(counts_["places drawn again"], 1);
  EXPECT_TRUE(HasRod(updated->graph));
  EXPECT_NEAR(LengthOf(updated->graph), 12 * 1.2 + 1, 0.3);
  for (const DrawingLink& link : updated->graph.links) EXPECT_TRUE(link.primitive);

  // And the next update starts from there.
  const auto again = Update();
  ASSERT_TRUE(again) << why_not_;
  EXPECT_EQ(counts_["images: new or changed"], 0);
  EXPECT_TRUE(HasRod(again->graph));
}

TEST_F(UpdateSceneTest, WhatLosesItsViewsGoes) {
  See(Numbers(30), kWithRod);
  ASSERT_TRUE(HasRod(Draw()));
  See(Numbers(30, {6, 11, 16}), kOldWithRod);
  const auto updated = Update();
  ASSERT_TRUE(updated) << why_not_;
  EXPECT_EQ(counts_["images: gone, or as they were before they changed"], 3);
  EXPECT_FALSE(HasRod(updated->graph));
  EXPECT_NEAR(LengthOf(updated->graph), 12 * 1.2, 0.3);
  for (const DrawingLink& link : updated->graph.links) {
    EXPECT_LT(link.supporting_views.back(), 27);
  }
}

TEST_F(UpdateSceneTest, ChangedViewsAreNewOnes) {
  See(Numbers(30), kOldWithRod);
  Draw();
  See(Numbers(30), kWithRod);
  const auto updated = Update();
  ASSERT_TRUE(updated) << why_not_;
  EXPECT_EQ(*updated->new_views, (std::vector<ViewId>{6, 11, 16}));
  EXPECT_TRUE(HasRod(updated->graph));
}

TEST_F(UpdateSceneTest, SaysWhyEverythingMustBeDrawn) {
  See(Numbers(15), {});
  EXPECT_FALSE(Update());
  EXPECT_THAT(why_not_, HasSubstr("no drawing made with these options"));
  Draw();
  EXPECT_TRUE(Update()) << why_not_;

  See(Numbers(20), {});
  EXPECT_FALSE(Update());
  EXPECT_THAT(why_not_, HasSubstr("5 of 20 images are new"));

  See(Numbers(15), {});
  std::swap(views_[3], views_[4]);
  std::swap(curves_[3], curves_[4]);
  EXPECT_FALSE(Update());
  EXPECT_THAT(why_not_, HasSubstr("another order"));

  See(Numbers(15), {});
  options_.drawing.topology.min_link_length_px += 1;
  EXPECT_FALSE(Update());
  EXPECT_THAT(why_not_, HasSubstr("no drawing made with these options"));
  options_ = {};

  std::filesystem::remove(folder_.Path("cache/sketch/view 103.bin"));
  EXPECT_FALSE(Update());
  EXPECT_THAT(why_not_, HasSubstr("view 103"));

  std::filesystem::resize_file(folder_.Path("cache/scene/drawing.bin"), 1000);
  EXPECT_FALSE(Update());
  EXPECT_THAT(why_not_, HasSubstr("drawing.bin"));
}

TEST_F(UpdateSceneTest, ThreadsDoNotMatter) {
  See(Numbers(30, {6, 11, 16}), kWithRod);
  Draw();
  See(Numbers(30), kWithRod);
  std::vector<std::vector<Eigen::Vector3d>> links;
  for (const int num_threads : {1, 3}) {
    const std::string copy = folder_.Path("copy " + std::to_string(num_threads));
    std::filesystem::copy(folder_.Path("cache"), copy, std::filesystem::copy_options::recursive);
    ResultCache cache(copy);
    std::vector<ImageCurves> curves = curves_;
    RunContext context;
    context.num_threads = num_threads;
    const auto updated = UpdateScene({views_, hints_, images_, box_, &cache}, &curves, options_,
                                     context, ignore_, &why_not_);
    ASSERT_TRUE(updated) << why_not_;
    std::vector<std::vector<Eigen::Vector3d>> now;
    for (const DrawingLink& link : updated->graph.links) now.push_back(link.points_in_world);
    if (num_threads > 1) {
      EXPECT_EQ(now, links);
    }
    links = std::move(now);
  }
}

TEST_F(UpdateSceneTest, SomeDrawingsAreNeverUpdated) {
  EXPECT_TRUE(IsUpdatable(options_));
  const auto expect_refused = [](const PipelineOptions& options) {
    EXPECT_FALSE(IsUpdatable(options));
    EXPECT_THROW(CheckUpdatable(options), OptionError);
  };
  PipelineOptions regular = options_;
  regular.regularize = true;
  expect_refused(regular);
  PipelineOptions paper = options_;
  paper.method = DrawingMethod::kPaper;
  expect_refused(paper);
  PipelineOptions original = options_;
  original.mode = SketchMode::kOriginal;
  expect_refused(original);
  PipelineOptions cameras = options_;
  cameras.refine_cameras = CameraRefinement::kOn;
  expect_refused(cameras);
}

}  // namespace
}  // namespace limn
