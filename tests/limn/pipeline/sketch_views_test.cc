// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/sketch_views.h"

#include <atomic>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "limn/cache/curve_sketch_file.h"
#include "limn/cache/curves_key.h"
#include "limn/cache/stage_file.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/byte_stream.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

// Of a stage file.
std::string IdentityOf(const std::string& path) {
  const std::string bytes = TemporaryFolder::Read(path);
  ByteReader in(path, bytes);
  in.Take(16);  // magic, version, kind
  return in.GetString();
}

// A cube in ten views.
class SketchViewsTest : public ::testing::Test {
 protected:
  SketchViewsTest()
      : views_(testing::DomeViews(10, 5)),
        curves_(testing::ProjectCurves(views_, testing::CubeEdges(0.8))) {}

  SketchResult Sketch(const std::string& cache_dir, SketchMode mode = SketchMode::kSweep,
                      const RunContext& context = {}) {
    ResultCache cache(cache_dir);
    const SketchResult result =
        SketchViews(mode, {{views_, curves_, hints_, box_}}, options_, &cache, context);
    use_ = cache.Use(CachedKind::kSketch);
    return result;
  }

  // The sketch as bytes.
  std::string Bytes(const CurveSketch& sketch) const {
    DrawingMetadata metadata;
    metadata.view_names.resize(views_.size());
    metadata.options_json = "{}";
    WriteCurveSketch(folder_.Path("sketch.bin"), sketch, metadata, "");
    return TemporaryFolder::Read(folder_.Path("sketch.bin"));
  }

  std::string Kept(int view) const { return Cache() + "/sketch/" + views_[view].name + ".bin"; }
  std::string Cache() const { return folder_.Path("cache"); }

  TemporaryFolder folder_;
  std::vector<View> views_;
  std::vector<ImageCurves> curves_;
  SceneHints hints_;
  std::optional<Eigen::AlignedBox3d> box_;
  SketchOptions options_;
  CacheUse use_;  // by the last call
};

TEST_F(SketchViewsTest, KeptSketchesAreTheSameBytes) {
  for (const SketchMode mode : {SketchMode::kSweep, SketchMode::kEnhanced}) {
    const SketchResult plain = Sketch("", mode);
    ASSERT_GT(plain.sketch.curves.size(), 20u);
    std::filesystem::remove_all(Cache());
    const SketchResult first = Sketch(Cache(), mode);
    EXPECT_EQ(use_.stored, 10);
    const SketchResult second = Sketch(Cache(), mode);
    EXPECT_EQ(use_.reused, 10);
    for (const SketchResult* result : {&first, &second}) {
      EXPECT_TRUE(Bytes(result->sketch) == Bytes(plain.sketch));
      EXPECT_EQ(result->fates, plain.fates);
      EXPECT_EQ(result->summary.kept, plain.summary.kept);
      EXPECT_EQ(result->summary.dropped, plain.summary.dropped);
    }
  }
}

TEST_F(SketchViewsTest, TheOriginalSketchIsNotKept) {
  Sketch(Cache(), SketchMode::kOriginal);
  EXPECT_EQ(use_.total, 0);
  EXPECT_FALSE(std::filesystem::exists(Cache()));
}

TEST_F(SketchViewsTest, ModeOptionsAndBoxMakeAllAnew) {
  Sketch(Cache());
  const auto expect_all_outdated = [&](const char* what, SketchMode mode = SketchMode::kSweep) {
    Sketch(Cache(), mode);
    EXPECT_EQ(use_.outdated, 10) << what;
  };
  expect_all_outdated("mode", SketchMode::kEnhanced);
  expect_all_outdated("mode back");
  options_.min_supporting_views = 4;
  expect_all_outdated("options");
  options_.view_selection.max_second_views = 5;
  expect_all_outdated("view selection");
  box_.emplace(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(0, 1, 1));
  expect_all_outdated("box");
  box_->max().x() = 0.1;
  expect_all_outdated("larger box");
}

TEST_F(SketchViewsTest, WhatIsMadeAgainIsWhatAChangeTouches) {
  options_.view_selection.max_second_views = 2;
  options_.view_selection.max_confirmation_views = 4;
  Sketch(Cache());
  // An edgel that moves in one view concerns the view and those that look there.
  curves_[3].edge_map.edgels[0].position_px.x() += 0.01;
  Sketch(Cache());
  EXPECT_GE(use_.outdated, 2);
  EXPECT_LE(use_.outdated, 9);
  EXPECT_EQ(use_.outdated + use_.reused, 10);
  views_[7].cam_from_world.translation.x() += 1e-6;
  const SketchResult kept = Sketch(Cache());
  EXPECT_GE(use_.outdated, 2);
  EXPECT_TRUE(Bytes(kept.sketch) == Bytes(Sketch("").sketch));
}

TEST_F(SketchViewsTest, GoesOnWhereItWasStopped) {
  const std::string whole = Bytes(Sketch("").sketch);
  std::atomic<bool> stop = false;
  RunContext context;
  context.num_threads = 1;
  context.cancelled = &stop;
  context.progress = [&](const std::string& stage, size_t done, size_t) {
    if (stage == "swept sketch" && done == 4) stop = true;
  };
  EXPECT_THROW(Sketch(Cache(), SketchMode::kSweep, context), Cancelled);
  const SketchResult result = Sketch(Cache());
  EXPECT_EQ(use_.reused, 4);
  EXPECT_EQ(use_.stored, 6);
  EXPECT_TRUE(Bytes(result.sketch) == whole);
}

TEST_F(SketchViewsTest, DamagedOnesAreMadeAgain) {
  const std::string whole = Bytes(Sketch(Cache()).sketch);
  std::filesystem::resize_file(Kept(2), 100);
  std::filesystem::copy_file(Kept(5), Kept(4), std::filesystem::copy_options::overwrite_existing);
  EXPECT_TRUE(Bytes(Sketch(Cache()).sketch) == whole);
  EXPECT_EQ(use_.damaged, 1);
  EXPECT_EQ(use_.outdated, 1);
  EXPECT_EQ(use_.reused, 8);
}

// A shared folder may hold anything, with the right checksum and identity.
TEST_F(SketchViewsTest, ForeignIdsAreMadeAgain) {
  const std::string whole = Bytes(Sketch(Cache()).sketch);
  const std::vector<std::string> payloads = {"", "no depths", std::string(100, '\0'),
                                             *ReadStageFile(Kept(4), StageKind::kViewSketch, "")};
  for (int view = 0; view < 4; ++view) {
    WriteStageFile(Kept(view), StageKind::kViewSketch, IdentityOf(Kept(view)), payloads[view]);
  }
  EXPECT_TRUE(Bytes(Sketch(Cache()).sketch) == whole);
  EXPECT_EQ(use_.damaged, 4);
  EXPECT_EQ(use_.reused, 6);
}

TEST_F(SketchViewsTest, SomeViewsAreMadeFromTheCurvesOfTheirPlansOnly) {
  options_.view_selection.max_second_views = 2;
  options_.view_selection.max_confirmation_views = 4;
  const std::string whole = Bytes(Sketch("").sketch);
  const auto plans = SelectViews(views_, hints_, options_.view_selection, {});
  const std::vector<ImageCurves> all_curves = curves_;
  for (const std::vector<ViewId>& part : {std::vector<ViewId>{0, 1, 2}, {3, 4, 5, 6, 7, 8, 9}}) {
    std::set<ViewId> needed(part.begin(), part.end());
    for (const ViewId v : part) {
      needed.insert(plans[v].second_views.begin(), plans[v].second_views.end());
      needed.insert(plans[v].confirmation_views.begin(), plans[v].confirmation_views.end());
    }
    curves_.assign(views_.size(), {});
    for (const ViewId v : needed) curves_[v] = all_curves[v];
    ResultCache cache(Cache());
    SketchViews(SketchMode::kSweep, {{views_, curves_, hints_, box_}, part}, options_, &cache, {});
    EXPECT_EQ(cache.Use(CachedKind::kSketch).stored, static_cast<int64_t>(part.size()));
  }
  curves_ = all_curves;
  EXPECT_TRUE(Bytes(Sketch(Cache()).sketch) == whole);
  EXPECT_EQ(use_.reused, 10);
}

TEST_F(SketchViewsTest, CountsAreOfOneStage) {
  ResultCache cache(Cache());
  for (const int64_t reused : {0, 10, 10}) {
    SketchViews(SketchMode::kSweep, {{views_, curves_, hints_, box_}}, options_, &cache, {});
    EXPECT_EQ(cache.Use(CachedKind::kSketch).reused, reused);
    EXPECT_EQ(cache.Use(CachedKind::kSketch).NumKept(), 10);
  }
}

TEST_F(SketchViewsTest, AFolderThatCannotBeMadeCostsTheCacheOnly) {
  const std::string file = folder_.Write("file", "");
  const SketchResult result = Sketch(file);
  EXPECT_EQ(use_.not_stored, 10);
  EXPECT_NE(use_.write_error.find(file), std::string::npos);
  EXPECT_TRUE(Bytes(result.sketch) == Bytes(Sketch("").sketch));
}

TEST_F(SketchViewsTest, ViewsThatASketchDoesNotNeedMayGo) {
  // The first views look at each other only.
  std::vector<ViewPlan> plans = SelectViews(views_, hints_, options_.view_selection, {});
  const auto is_late = [](ViewId v) { return v == 0 || v > 6; };
  for (ViewId v = 1; v <= 6; ++v) {
    std::erase_if(plans[v].second_views, is_late);
    std::erase_if(plans[v].confirmation_views, is_late);
  }
  const auto sketch = [&] {
    ResultCache cache(Cache());
    SketchResult result =
        SketchViews(SketchMode::kSweep, {{views_, curves_, hints_, box_}, std::nullopt, &plans},
                    options_, &cache, {});
    use_ = cache.Use(CachedKind::kSketch);
    return std::move(result.sketch.curves);
  };
  const std::vector<Curve3D> before = sketch();
  for (const ViewId gone : {9, 0}) {
    views_.erase(views_.begin() + gone);
    curves_.erase(curves_.begin() + gone);
    plans.erase(plans.begin() + gone);
  }
  plans[6].is_primary = plans[7].is_primary = false;
  for (ViewPlan& plan : plans) {
    for (ViewId& view : plan.second_views) --view;
    for (ViewId& view : plan.confirmation_views) --view;
  }
  const std::vector<Curve3D> after = sketch();
  EXPECT_EQ(use_.reused, 6);
  EXPECT_EQ(use_.outdated, 0);
  std::vector<Curve3D> expected;
  for (const Curve3D& curve : before) {
    if (!is_late(curve.anchor.view)) expected.push_back(curve);
  }
  ASSERT_EQ(after.size(), expected.size());
  for (size_t c = 0; c < after.size(); ++c) {
    EXPECT_EQ(after[c].anchor.view, expected[c].anchor.view - 1);
    EXPECT_EQ(after[c].points_in_world, expected[c].points_in_world);
    ASSERT_EQ(after[c].support.edgels.size(), expected[c].support.edgels.size());
    for (size_t i = 0; i < after[c].support.edgels.size(); ++i) {
      EXPECT_EQ(after[c].support.edgels[i].view, expected[c].support.edgels[i].view - 1);
    }
  }
}

}  // namespace
}  // namespace limn
