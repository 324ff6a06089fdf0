// SPDX-License-Identifier: BSD-3-Clause
// The example program that links COLMAP, against `limn` on the files of the same model.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model.h"
#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kModel = LIMN_SAMPLE_DIR "/day/sparse";
constexpr const char* kImages = LIMN_SAMPLE_DIR "/day/images";

// Median distance of the observations of new points from where their cameras see these, px.
double MedianError(const colmap_ext::SparseModel& model, size_t first) {
  std::vector<double> errors;
  for (size_t p = first; p < model.points.size(); ++p) {
    for (const colmap_ext::TrackElement& element : model.points[p].track) {
      const auto image = std::find_if(model.images.begin(), model.images.end(),
                                      [&](const auto& i) { return i.id == element.image_id; });
      const colmap_ext::Intrinsics k = colmap_ext::IntrinsicsOf(model.CameraOf(*image));
      const Eigen::Vector2d uv = (image->cam_from_world * model.points[p].position).hnormalized();
      const Eigen::Vector2d pixel(k.fx * uv.x() + k.cx, k.fy * uv.y() + k.cy);
      errors.push_back((image->observations[element.observation].position - pixel).norm());
    }
  }
  std::nth_element(errors.begin(), errors.begin() + errors.size() / 2, errors.end());
  return errors[errors.size() / 2];
}

TEST(DrawReconstruction, DrawsWhatAutomaticDrawerDraws) {
  const TempDir dir;
  const LimnRun drawn =
      RunProgram(DRAW_RECONSTRUCTION_PROGRAM, {kModel, kImages, (dir / "linked").string()});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_EQ(drawn.out, "");
  EXPECT_THAT(drawn.err, HasSubstr("Model in memory (24 registered images)"));
  const LimnRun run = RunLimn({"automatic_drawer", "--input_path", kModel, "--image_path", kImages,
                               "--output_path", (dir / "files").string()});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  auto linked = ReadTree(dir / "linked");
  auto files = ReadTree(dir / "files");
  ASSERT_GT(files["drawing.json"].size(), 1000u);
  EXPECT_TRUE(linked["drawing.json"] == files["drawing.json"]);
  EXPECT_TRUE(linked["drawing.ply"] == files["drawing.ply"]);
  EXPECT_TRUE(linked["curves/tracks.txt"] == files["curves/tracks.txt"]);

  const size_t num_before = colmap_ext::ReadColmapModel(kModel).points.size();
  auto model = colmap_ext::ReadColmapModel(dir / "linked/sparse-with-curves");
  EXPECT_TRUE(model.warnings.empty());
  // New points have the highest ids; COLMAP writes all in the order of a hash table.
  std::sort(model.points.begin(), model.points.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  EXPECT_GT(model.points.size(), num_before + 1000);
  for (size_t p = num_before; p < model.points.size(); ++p) {
    ASSERT_GE(model.points[p].track.size(), 2u);
  }
  EXPECT_LT(MedianError(model, num_before), 1e-6);
}

TEST(DrawReconstruction, SaysWhatIsWrong) {
  const TempDir dir;
  const std::string none = (dir / "none").string();
  const LimnRun no_model =
      RunProgram(DRAW_RECONSTRUCTION_PROGRAM, {none, kImages, dir.path().string()});
  EXPECT_EQ(no_model.exit_code, 1);
  EXPECT_THAT(no_model.err, HasSubstr(none + ": no such folder"));
  const LimnRun run = RunProgram(DRAW_RECONSTRUCTION_PROGRAM,
                                 {kModel, (dir / "none").string(), dir.path().string()});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("Curve drawing failed: " + (dir / "none").string() +
                                 ": no such folder (image_path)"));
}

}  // namespace
}  // namespace limn::testing
