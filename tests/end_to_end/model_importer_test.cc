// SPDX-License-Identifier: BSD-3-Clause
// Cameras of other programs become a model that the other commands run on.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using namespace colmap_ext;

// The cameras of the sample scene as projection matrices, 17 digits, pixels with their centers at
// integers.
class ModelImporter : public ::testing::Test {
 protected:
  ModelImporter() {
    for (const ModelImage& image : sample_.images) {
      const Intrinsics camera = IntrinsicsOf(sample_.CameraOf(image));
      Eigen::Matrix3d k;
      k << camera.fx, 0, camera.cx - 0.5, 0, camera.fy, camera.cy - 0.5, 0, 0, 1;
      Eigen::Matrix<double, 3, 4> projection;
      projection << image.cam_from_world.rotation.toRotationMatrix(),
          image.cam_from_world.translation;
      std::ostringstream text;
      text.precision(17);
      text << Eigen::MatrixXd(k * projection) << "\n";
      dir_.WriteFile("cameras/" + fs::path(image.name).stem().string() + ".projmatrix", text.str());
    }
  }

  LimnRun Run(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"model_importer", "--output_path", output_.string()};
    const auto add_default = [&](const std::string& name, const fs::path& value) {
      if (std::find(more.begin(), more.end(), name) != more.end()) return;
      arguments.insert(arguments.end(), {name, value.string()});
    };
    add_default("--input_path", dir_ / "cameras");
    add_default("--image_path", images_);
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  // One line, exit code 1, nothing written.
  void ExpectRefused(const std::vector<std::string>& more, const auto& line_matcher) const {
    const auto before = ReadTree(dir_.path());
    const LimnRun run = Run(more);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, StartsWith("ERROR: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_THAT(run.err, line_matcher);
    EXPECT_EQ(ReadTree(dir_.path()), before);
  }

  const fs::path images_ = fs::path(LIMN_SAMPLE_DIR) / "day" / "images";
  const SparseModel sample_ = ReadModel(fs::path(LIMN_SAMPLE_DIR) / "day" / "sparse");
  const TempDir dir_;
  const fs::path output_ = dir_ / "project" / "sparse" / "0";
};

TEST_F(ModelImporter, TheModelIsThatOfTheCameras) {
  for (const char* type : {"bin", "txt"}) {
    fs::remove_all(output_);
    const LimnRun run = Run({"--output_type", type});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, AllOf(HasSubstr("Format projection_matrices"),
                               HasSubstr("24 of 24 camera files matched to images by name")));
    EXPECT_TRUE(fs::exists(output_ / (std::string("images.") + type)));
    const SparseModel model = ReadModel(output_);
    ASSERT_EQ(model.images.size(), sample_.images.size());
    ASSERT_EQ(model.cameras.size(), 1u);
    for (size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(model.cameras[0].params[i], sample_.cameras[0].params[i], 1e-8);
    }
    for (const ModelImage& image : model.images) {
      const auto same = std::find_if(sample_.images.begin(), sample_.images.end(),
                                     [&](const ModelImage& s) { return s.name == image.name; });
      ASSERT_NE(same, sample_.images.end()) << image.name;
      const Rigid3d& a = image.cam_from_world;
      EXPECT_LT(a.rotation.angularDistance(same->cam_from_world.rotation), 1e-10);
      EXPECT_LT((a.translation - same->cam_from_world.translation).norm(), 1e-9);
    }
  }
}

TEST_F(ModelImporter, OtherCommandsRunOnTheModel) {
  ASSERT_EQ(Run().exit_code, 0);
  const std::string list = dir_.WriteFile("list.txt", "view_00.jpg\nview_01.jpg\n");
  const LimnRun run = RunLimn({"edge_extractor", "--input_path", output_.string(), "--image_path",
                               images_.string(), "--output_path", (dir_ / "drawing").string(),
                               "--image_list_path", list, "--max_image_size", "160"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(fs::is_empty(dir_ / "drawing" / "curves" / "cache" / "edges"));
}

TEST_F(ModelImporter, AModelIsNotOverwritten) {
  ASSERT_EQ(Run().exit_code, 0);
  ExpectRefused({"--output_type", "txt"}, HasSubstr("holds a model already"));
}

TEST_F(ModelImporter, BadInputIsRefused) {
  ExpectRefused({"--input_path", (dir_ / "nowhere").string()},
                HasSubstr("nowhere: no such file or folder"));
  ExpectRefused({"--image_path", (dir_ / "nowhere").string()},
                HasSubstr("nowhere: no such folder of images"));
  ExpectRefused({"--input_type", "nvm"}, HasSubstr("cameras: no file *.nvm in this folder"));
  ExpectRefused({"--input_type", "unknown"}, HasSubstr("input_type = unknown"));
  ExpectRefused({"--share_cameras_px", "-1"}, HasSubstr("share_cameras_px = -1"));
  ExpectRefused({"--input_path", ""}, HasSubstr("--input_path must be given"));
  dir_.WriteFile("cameras/view_07.projmatrix", "1 2 3 4\n5 6 7 8\n9 10 11\n");
  ExpectRefused({}, HasSubstr("view_07.projmatrix: line 4: the file ends before"));
}

}  // namespace
}  // namespace limn::testing
