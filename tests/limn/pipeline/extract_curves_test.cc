// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/extract_curves.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "limn/cache/curves_key.h"
#include "limn/model/usable_edgels.h"
#include "support/synthetic_image.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 120;
constexpr int kHeight = 90;

// Maps only what is left of a column, unchanged.
class HalfLens : public LensMap {
 public:
  std::optional<Eigen::Vector2d> VirtualFromStored(const Eigen::Vector2d& stored) const override {
    return Half(stored);
  }
  std::optional<Eigen::Vector2d> StoredFromVirtual(const Eigen::Vector2d& pixel) const override {
    return Half(pixel);
  }

 private:
  static std::optional<Eigen::Vector2d> Half(const Eigen::Vector2d& pixel) {
    if (pixel.x() > kWidth / 2) return std::nullopt;
    return pixel;
  }
};

// Two views of a bright square and a source of their photographs that counts how often it is asked.
class ExtractCurvesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    cache_ = fs::temp_directory_path() / ("limn_extract_" + std::to_string(getpid()));
    views_.resize(2);
    views_[0].name = "sub/a.png";
    views_[1].name = "b.png";
    for (View& view : views_) {
      view.camera.width = kWidth;
      view.camera.height = kHeight;
    }
    images_.read = [this](ViewId id) {
      ++num_read_;
      Image image = testing::ConstantImage(kWidth, kHeight, {80});
      const double x = 30 + 0.3 * id;
      testing::Paint(testing::Polygon({{x, 20}, {x + 60, 20}, {x + 60, 70}, {x, 70}}), {160},
                     &image);
      return image;
    };
    images_.identity = [this](ViewId id) { return identity_ + std::to_string(id); };
  }
  void TearDown() override { fs::remove_all(cache_); }

  CurvesResult Extract(const std::string& cache_dir = "", int num_threads = 1) {
    RunContext context;
    context.num_threads = num_threads;
    num_read_ = 0;
    ResultCache cache(cache_dir);
    const CurvesResult result = ExtractCurves({views_, images_, &cache}, edges_, linking_, context);
    use_ = cache.Use(CachedKind::kFragments);
    return result;
  }

  fs::path cache_;
  std::vector<View> views_;
  ImageSource images_;
  std::string identity_ = "square";
  EdgeDetectionOptions edges_;
  LinkingOptions linking_;
  std::atomic<int> num_read_ = 0;
  CacheUse use_;  // by the last call
};

std::string Key(const std::vector<View>& views, const std::vector<ImageCurves>& curves) {
  return CurvesKey(views, curves, RunContext());
}

int64_t Count(const StageSummary::Counts& counts, const std::string& unit) {
  for (const auto& [name, count] : counts) {
    if (name == unit) return count;
  }
  ADD_FAILURE() << "no count of " << unit;
  return -1;
}

TEST_F(ExtractCurvesTest, ReleasesWhatTheSourceKeepsAfterTheLastView) {
  std::vector<int> read_before;
  images_.release = [&] { read_before.push_back(num_read_); };
  Extract();
  EXPECT_EQ(read_before, std::vector<int>{2});
  ResultCache cache("");
  ExtractEdgeMaps({views_, images_, &cache}, edges_, {});
  EXPECT_EQ(read_before, (std::vector<int>{2, 4}));
}

TEST_F(ExtractCurvesTest, FindsTheSquareAndAccountsForEveryEdgel) {
  const CurvesResult result = Extract();
  ASSERT_EQ(result.curves.size(), 2u);
  double length = 0;
  const ImageCurves& curves = result.curves[0];
  for (const CurveFragment& fragment : curves.fragments) {
    for (size_t i = 1; i < fragment.edgel_ids.size(); ++i) {
      length += (curves.edge_map.edgels[fragment.edgel_ids[i]].position_px -
                 curves.edge_map.edgels[fragment.edgel_ids[i - 1]].position_px)
                    .norm();
    }
  }
  EXPECT_NEAR(length, 220, 30);  // less what the corners lose
  const StageSummary& summary = result.summary;
  EXPECT_EQ(Count(summary.in, "views"), 2);
  int64_t accounted = Count(summary.kept, "edgels");
  for (const auto& [reason, count] : summary.dropped) accounted += count;
  EXPECT_EQ(accounted, Count(summary.in, "edgels"));
}

TEST_F(ExtractCurvesTest, ThreadsChangeNothing) {
  EXPECT_EQ(Key(views_, Extract("", 1).curves), Key(views_, Extract("", 2).curves));
}

TEST_F(ExtractCurvesTest, TheSecondRunComesFromTheCache) {
  const CurvesResult first = Extract(cache_.string());
  EXPECT_EQ(num_read_, 2);
  EXPECT_EQ(use_.reused, 0);
  EXPECT_EQ(use_.outdated, 0);
  EXPECT_EQ(use_.NumKept(), 2);
  const CurvesResult second = Extract(cache_.string());
  EXPECT_EQ(num_read_, 0);
  EXPECT_EQ(use_.reused, 2);
  EXPECT_EQ(Key(views_, second.curves), Key(views_, first.curves));
  EXPECT_EQ(second.summary.kept, first.summary.kept);
  EXPECT_EQ(second.summary.dropped, first.summary.dropped);
}

TEST_F(ExtractCurvesTest, KeptEdgeMapsAreUsed) {
  const CurvesResult direct = Extract();
  ResultCache cache(cache_.string());
  ExtractEdgeMaps({views_, images_, &cache}, edges_, RunContext());
  const CurvesResult result = Extract(cache_.string());
  EXPECT_EQ(num_read_, 0);
  EXPECT_EQ(use_.reused, 0);
  EXPECT_EQ(Key(views_, result.curves), Key(views_, direct.curves));
}

TEST_F(ExtractCurvesTest, GivenEdgelsAreLinkedAndGivenFragmentsStay) {
  const CurvesResult detected = Extract();
  ResultCache none("");
  const std::vector<EdgeMap> maps =
      ExtractEdgeMaps({views_, images_, &none}, edges_, RunContext()).edge_maps;
  GivenEdges given;
  images_.given_edges = [&](ViewId id) {
    given.curves.edge_map = maps[id];
    return given;
  };
  const CurvesResult linked = Extract();
  EXPECT_EQ(num_read_, 0);
  EXPECT_EQ(Key(views_, linked.curves), Key(views_, detected.curves));

  given.are_linked = true;
  given.curves.fragments = {{{0, 1}, false}};
  const CurvesResult stay = Extract();
  ASSERT_EQ(stay.curves[0].fragments.size(), 1u);
  EXPECT_EQ(stay.curves[0].fragments[0].edgel_ids, (std::vector<EdgelId>{0, 1}));
}

// Of other edges, which the identity tells.
TEST_F(ExtractCurvesTest, GivenFragmentsDoNotComeFromKeptEdgeMaps) {
  images_.given_edges = [](ViewId) {
    GivenEdges given;
    given.are_linked = true;
    given.curves.edge_map.width = kWidth;
    given.curves.edge_map.height = kHeight;
    given.curves.edge_map.edgels.resize(3);
    given.curves.fragments = {{{0, 2}, false}};
    return given;
  };
  ResultCache cache(cache_.string());
  EXPECT_EQ(
      ExtractEdgeMaps({views_, images_, &cache}, edges_, RunContext()).edge_maps[1].edgels.size(),
      3u);
  EXPECT_EQ(Extract(cache_.string()).curves[1].fragments.size(), 1u);
  EXPECT_EQ(Extract(cache_.string()).curves[1].fragments.size(), 1u);
  EXPECT_EQ(use_.reused, 2);
}

TEST_F(ExtractCurvesTest, FragmentsAreToldBeforeTheLens) {
  views_[0].lens = std::make_shared<HalfLens>();
  ResultCache none("");
  std::vector<ImageCurves> told(2);
  const ExtractionInput input = {views_, images_, &none, std::nullopt,
                                 [&](ViewId id, const ImageCurves& curves) { told[id] = curves; }};
  const CurvesResult result = ExtractCurves(input, edges_, linking_, RunContext());
  EXPECT_EQ(told[0].edge_map.num_outside_lens, 0);
  EXPECT_GT(result.curves[0].edge_map.num_outside_lens, 0);
  EXPECT_EQ(Key(views_, {told[1], told[1]}), Key(views_, {result.curves[1], result.curves[1]}));
}

TEST_F(ExtractCurvesTest, OtherLinkingIsComputedAgain) {
  Extract(cache_.string());
  linking_.min_length_px = 20;
  Extract(cache_.string());
  EXPECT_EQ(use_.reused, 0);
  EXPECT_EQ(use_.outdated, 2);
}

TEST_F(ExtractCurvesTest, AnotherChannelIsComputedAgain) {
  Extract(cache_.string());
  edges_.channel = EdgeChannel::kColor;
  Extract(cache_.string());
  EXPECT_EQ(num_read_, 2);
  EXPECT_EQ(use_.outdated, 2);
}

TEST_F(ExtractCurvesTest, ForksBetweenKeptEdgesNeedThePhotograph) {
  ResultCache cache(cache_.string());
  ExtractEdgeMaps({views_, images_, &cache}, edges_, RunContext());
  linking_.forks = ForkChoice::kHypotheses;
  Extract(cache_.string());
  EXPECT_EQ(num_read_, 2);
}

TEST_F(ExtractCurvesTest, OtherPixelsAreComputedAgain) {
  Extract(cache_.string());
  identity_ = "another square";
  Extract(cache_.string());
  EXPECT_EQ(num_read_, 2);
  EXPECT_EQ(use_.outdated, 2);
  Extract(cache_.string());
  EXPECT_EQ(use_.reused, 2);
}

TEST_F(ExtractCurvesTest, DamagedCacheIsComputedAgain) {
  const CurvesResult first = Extract(cache_.string());
  const fs::path file = cache_ / "fragments" / "b.png.bin";
  ASSERT_TRUE(fs::exists(file));
  fs::resize_file(file, fs::file_size(file) / 2);
  const CurvesResult second = Extract(cache_.string());
  EXPECT_EQ(num_read_, 1);
  EXPECT_EQ(use_.reused, 1);
  EXPECT_EQ(use_.damaged, 1);
  EXPECT_TRUE(use_.damage.starts_with(file.string() + ": ")) << use_.damage;
  EXPECT_EQ(Key(views_, second.curves), Key(views_, first.curves));
}

TEST_F(ExtractCurvesTest, WhatTheLensCannotMapIsInNoFragment) {
  const CurvesResult whole = Extract();
  views_[0].lens = std::make_shared<HalfLens>();
  const CurvesResult half = Extract();
  // Edgels keep their ids.
  EXPECT_EQ(half.curves[0].edge_map.edgels.size(), whole.curves[0].edge_map.edgels.size());
  EXPECT_GT(Count(half.summary.dropped, "edgels: outside the lens model"), 0);
  EXPECT_FALSE(half.curves[0].fragments.empty());
  for (const CurveFragment& fragment : half.curves[0].fragments) {
    EXPECT_FALSE(fragment.closed);
    for (const EdgelId id : fragment.edgel_ids) {
      EXPECT_LT(half.curves[0].edge_map.edgels[id].position_px.x(), kWidth / 2);
    }
  }
}

TEST_F(ExtractCurvesTest, KeyFollowsPosesAndEdgels) {
  const CurvesResult result = Extract();
  const std::string key = Key(views_, result.curves);
  views_[1].cam_from_world.translation.x() += 1e-9;
  EXPECT_NE(Key(views_, result.curves), key);
  views_[1].cam_from_world.translation.x() = 0;
  EXPECT_EQ(Key(views_, result.curves), key);
  views_[0].region.max_px.x() += 1;
  EXPECT_NE(Key(views_, result.curves), key);
  views_[0].region.max_px.x() -= 1;
  std::vector<ImageCurves> changed = result.curves;
  changed[0].edge_map.edgels[0].position_px.x() += 1e-9;
  EXPECT_NE(Key(views_, changed), key);
  changed = result.curves;
  changed[0].edge_map.edgels[0].tangent_rad += 1e-9;
  EXPECT_NE(Key(views_, changed), key);
  changed = result.curves;
  std::reverse(changed[0].fragments[0].edgel_ids.begin(), changed[0].fragments[0].edgel_ids.end());
  EXPECT_NE(Key(views_, changed), key);
}

ImageCurves OneFragment(int size, bool closed) {
  ImageCurves curves;
  curves.edge_map.edgels.resize(size);
  curves.fragments.resize(1);
  curves.fragments[0].closed = closed;
  for (int i = 0; i < size; ++i) curves.fragments[0].edgel_ids.push_back(i);
  return curves;
}

TEST(RemoveUnusableEdgels, KeepsWhatIsUsable) {
  ImageCurves curves = OneFragment(4, true);
  RemoveUnusableEdgels({true, true, true, true}, &curves);
  ASSERT_EQ(curves.fragments.size(), 1u);
  EXPECT_TRUE(curves.fragments[0].closed);
}

// 0 1 x 3 x 5 6: the lone 3 is no fragment.
TEST(RemoveUnusableEdgels, CutsAnOpenFragment) {
  ImageCurves curves = OneFragment(7, false);
  RemoveUnusableEdgels({true, true, false, true, false, true, true}, &curves);
  ASSERT_EQ(curves.fragments.size(), 2u);
  EXPECT_EQ(curves.fragments[0].edgel_ids, (std::vector<EdgelId>{0, 1}));
  EXPECT_EQ(curves.fragments[1].edgel_ids, (std::vector<EdgelId>{5, 6}));
}

// A ring 0 1 x 3 4 (back to 0) opens at the gap.
TEST(RemoveUnusableEdgels, OpensAClosedFragmentAtTheGap) {
  ImageCurves curves = OneFragment(5, true);
  RemoveUnusableEdgels({true, true, false, true, true}, &curves);
  ASSERT_EQ(curves.fragments.size(), 1u);
  EXPECT_FALSE(curves.fragments[0].closed);
  EXPECT_EQ(curves.fragments[0].edgel_ids, (std::vector<EdgelId>{3, 4, 0, 1}));
}

TEST(RemoveUnusableEdgels, NothingUsableLeavesNothing) {
  ImageCurves curves = OneFragment(3, true);
  RemoveUnusableEdgels({false, false, false}, &curves);
  EXPECT_TRUE(curves.fragments.empty());
}

}  // namespace
}  // namespace limn
