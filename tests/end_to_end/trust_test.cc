// SPDX-License-Identifier: BSD-3-Clause
// What a run says of its own drawing, with right and with wrong cameras.
#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using colmap_ext::SparseModel;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const fs::path kDay = fs::path(LIMN_SAMPLE_DIR) / "day";
constexpr size_t kViewStride = 3;

// Every third view of the sample scene, whose model can be spoiled.
class Trust : public ::testing::Test {
 protected:
  Trust() : model_(colmap_ext::ReadModel(kDay / "sparse")) {
    std::string names;
    for (size_t i = 0; i < model_.images.size(); i += kViewStride) {
      names += model_.images[i].name + "\n";
    }
    list_ = dir_.WriteFile("list.txt", names);
  }

  // Without tracks.
  void ForgetPoints() {
    model_.points.clear();
    for (colmap_ext::ModelImage& image : model_.images) image.observations.clear();
  }

  // What the commands print.
  std::string Draw(std::vector<std::string> more = {}) const {
    fs::create_directories(dir_ / "sparse");
    colmap_ext::WriteModelBinary(model_, dir_ / "sparse");
    more.insert(more.end(), {"--page", "0"});
    return Run("automatic_drawer", more);
  }

  std::string Run(const std::string& command, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {command,
                                          "--input_path",
                                          (dir_ / "sparse").string(),
                                          "--image_path",
                                          (kDay / "images").string(),
                                          "--output_path",
                                          (dir_ / "out").string(),
                                          "--image_list_path",
                                          list_,
                                          "--max_image_size",
                                          "480"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const LimnRun run = RunLimn(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  }

  TempDir dir_;
  SparseModel model_;
  std::string list_;
};

TEST_F(Trust, RightCamerasGiveNoWarning) {
  EXPECT_THAT(Draw(), AllOf(HasSubstr("% of the edges of an image (median)"),
                            HasSubstr("expected error"), Not(HasSubstr("WARNING"))));
}

// Also by the command that does the last stages, which mark what only that pose supports.
TEST_F(Trust, OneWrongPoseIsNamed) {
  model_.images[kViewStride].cam_from_world.translation.x() += 0.3;
  const std::string name = model_.images[kViewStride].name;
  const std::string out = Draw({"--refine_cameras", "0"});
  EXPECT_THAT(out, HasSubstr("miss 1 of 8 images by more than 2 px: " + name));
  const std::string less = "1 of 8 images agree much less with the drawing: " + name;
  EXPECT_THAT(Run("curve_drawer", {"--overwrite", "1"}),
              AllOf(HasSubstr("of the edges of an image (median)"), HasSubstr("expected error"),
                    HasSubstr("Warnings of this run (1):\n")));
  for (const std::string& said : {out, Run("drawing_refiner")}) {
    EXPECT_THAT(said, AllOf(HasSubstr("WARNING: " + less), HasSubstr("expected error"),
                            HasSubstr("Warnings of this run (2):\n"), HasSubstr("\n  " + less)));
  }
}

TEST_F(Trust, OneWrongPoseIsRefined) {
  const Rigid3d right = model_.images[kViewStride].cam_from_world;
  model_.images[kViewStride].cam_from_world.translation.x() += 0.3;
  const std::string name = model_.images[kViewStride].name;
  EXPECT_THAT(Draw(), HasSubstr("the cameras of 1 of 8 images seem wrong and moved far: " + name));
  const SparseModel refined = colmap_ext::ReadModel(dir_ / "out/refined");
  const auto center = [](const Rigid3d& pose) { return Inverse(pose).translation; };
  for (size_t i = 0; i < model_.images.size(); i += kViewStride) {
    const Rigid3d& truth = i == kViewStride ? right : model_.images[i].cam_from_world;
    EXPECT_LT((center(refined.images[i].cam_from_world) - center(truth)).norm(), 0.005)
        << model_.images[i].name;
  }
}

TEST_F(Trust, CurvesTellOfExchangedNames) {
  ForgetPoints();
  std::vector<std::string> names;
  for (const colmap_ext::ModelImage& image : model_.images) names.push_back(image.name);
  std::ranges::rotate(names, names.begin() + kViewStride);
  for (size_t i = 0; i < names.size(); ++i) model_.images[i].name = names[i];
  EXPECT_THAT(Draw(), HasSubstr("WARNING: the drawing explains next to nothing"));
}

TEST_F(Trust, BoxBesideTheScene) {
  EXPECT_THAT(Draw({"--box", "50,51,50,51,50,51"}), HasSubstr("a box beside the scene"));
  EXPECT_THAT(Run("drawing_refiner"), HasSubstr("a box beside the scene"));
}

}  // namespace
}  // namespace limn::testing
