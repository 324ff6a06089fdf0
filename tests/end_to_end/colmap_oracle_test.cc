// SPDX-License-Identifier: BSD-3-Clause
// The `colmap` program as an oracle: photographs to drawing by COLMAP's own commands. That its
// model_converter writes what is read here in both flavors is in colmap_ext/model/model_test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Of the sample scene, next to each other.
constexpr const char* kPhotos[] = {"view_01.jpg", "view_02.jpg", "view_03.jpg", "view_05.jpg",
                                   "view_06.jpg", "view_07.jpg", "view_09.jpg"};

class ColmapOracle : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!colmap_ext::HaveColmap()) GTEST_SKIP() << "colmap is not installed";
    for (const char* name : kPhotos) {
      // A space and a folder in every name.
      const fs::path copy = Path("images/left side") / name;
      fs::create_directories(copy.parent_path());
      fs::copy(fs::path(LIMN_SAMPLE_DIR) / "day" / "images" / name, copy);
    }
    fs::create_directories(Path("sparse"));
    fs::create_directories(Path("dense"));
  }

  fs::path Path(const std::string& name) const { return dir_ / name; }
  std::string Quoted(const std::string& name) const { return "'" + Path(name).string() + "'"; }

  // A command of COLMAP's, whose output the test shows when it fails.
  void Colmap(const std::string& command, const std::string& arguments) const {
    ASSERT_TRUE(colmap_ext::RunColmap(command + " " + arguments, Path("log")))
        << command << "\n"
        << ReadTree(dir_.path()).at("log");
  }

  // Photographs to sparse/0. The intrinsics of the sample scene are given.
  void Reconstruct() const {
    const std::string project =
        " --database_path " + Quoted("database.db") + " --image_path " + Quoted("images");
    Colmap("feature_extractor",
           "--random_seed 0 --SiftExtraction.use_gpu 0 --SiftExtraction.num_threads 2 "
           "--SiftExtraction.max_num_features 1500 --SiftExtraction.first_octave 0 "
           "--ImageReader.single_camera 1 --ImageReader.camera_model PINHOLE "
           "--ImageReader.camera_params 640,640,316,244" +
               project);
    Colmap("exhaustive_matcher",
           "--random_seed 0 --SiftMatching.use_gpu 0 --SiftMatching.num_threads 2 "
           "--database_path " +
               Quoted("database.db"));
    Colmap("mapper",
           "--random_seed 0 --Mapper.num_threads 2 --Mapper.ba_refine_focal_length 0 "
           "--Mapper.ba_refine_extra_params 0 --output_path " +
               Quoted("sparse") + project);
  }

  void Undistort(const std::string& output, const std::string& type) const {
    Colmap("image_undistorter", "--image_path " + Quoted("images") + " --input_path " +
                                    Quoted("sparse/0") + " --output_path " + Quoted(output) +
                                    " --output_type " + type);
  }

  // What `limn automatic_drawer` prints on a workspace.
  LimnRun Draw(const std::string& workspace) const {
    const LimnRun run = RunLimn({"automatic_drawer", "--workspace_path", Path(workspace).string(),
                                 "--quality", "low", "--num_threads", "2"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run;
  }

  size_t NumLinks(const std::string& folder) const {
    return ReadDrawingJson((Path(folder) / "drawing.json").string()).graph.links.size();
  }

  TempDir dir_;
};

// The scene has some hundred straight edges and the outlines of a few round things; seven views
// see most of them.
constexpr size_t kFewestLinks = 50;
constexpr size_t kMostLinks = 2000;

TEST_F(ColmapOracle, PhotographsToDrawing) {
  ASSERT_NO_FATAL_FAILURE(Reconstruct());
  const size_t num_registered = colmap_ext::ReadModel(Path("sparse/0")).images.size();
  ASSERT_GE(num_registered, 5u);

  ASSERT_NO_FATAL_FAILURE(Undistort("dense/0", "COLMAP"));
  EXPECT_THAT(Draw(".").out, HasSubstr("dense/0/sparse (" + std::to_string(num_registered)));
  EXPECT_GT(NumLinks("dense/0"), kFewestLinks);
  EXPECT_LT(NumLinks("dense/0"), kMostLinks);

  // The same cameras, except for the six digits of PMVS and the JPEG files written again.
  ASSERT_NO_FATAL_FAILURE(Undistort("for pmvs", "PMVS"));
  EXPECT_THAT(Draw("for pmvs").out, HasSubstr("for pmvs/pmvs/visualize"));
  EXPECT_NEAR(static_cast<double>(NumLinks("for pmvs/pmvs")),
              static_cast<double>(NumLinks("dense/0")),
              0.25 * static_cast<double>(NumLinks("dense/0")));
  const auto names =
      ReadDrawingJson((Path("for pmvs/pmvs") / "drawing.json").string()).metadata.view_names;
  EXPECT_THAT(names, ::testing::Contains("left side/view_05.jpg"));
}

// Real files of COLMAP's, in both flavors, and the PMVS cameras made from them.
TEST_F(ColmapOracle, PmvsCamerasAreThoseOfTheModel) {
  fs::remove_all(Path("images"));
  fs::copy(LIMN_SAMPLE_DIR "/day/images", Path("images"));
  fs::copy(LIMN_SAMPLE_DIR "/day/sparse", Path("sparse/0"));
  ASSERT_NO_FATAL_FAILURE(Undistort("out", "PMVS"));
  const colmap_ext::SparseModel given = colmap_ext::ReadModel(Path("sparse/0"));
  const colmap_ext::SparseModel pmvs = colmap_ext::ReadModel(Path("out/pmvs"));
  ASSERT_EQ(pmvs.images.size(), given.images.size());
  for (size_t i = 0; i < given.images.size(); ++i) {
    EXPECT_EQ(pmvs.images[i].name, given.images[i].name);
    const Rigid3d difference =
        pmvs.images[i].cam_from_world * Inverse(given.images[i].cam_from_world);
    // Six digits of numbers up to 1000 px: some 1e-5 rad, and as much of the distance (3).
    EXPECT_LT(difference.rotation.angularDistance(Eigen::Quaterniond::Identity()), 3e-5);
    EXPECT_LT(difference.translation.norm(), 1e-4);
  }
  // The points and where they were seen, in one order.
  ASSERT_EQ(pmvs.points.size(), given.points.size());
  EXPECT_TRUE(pmvs.warnings.empty());
  size_t num_seen = 0;
  for (const colmap_ext::ModelPoint& point : pmvs.points) {
    for (const colmap_ext::TrackElement& seen : point.track) {
      const size_t i = seen.image_id - 1;
      const auto& at = pmvs.images[i].observations[seen.observation].position;
      const auto& all = given.images[i].observations;
      ASSERT_TRUE(std::any_of(all.begin(), all.end(), [&](const colmap_ext::Observation& o) {
        return (o.position - at).norm() < 0.02;  // six digits again
      })) << at.transpose();
      ++num_seen;
    }
  }
  EXPECT_GT(num_seen, 2 * given.points.size());
}

}  // namespace
}  // namespace limn::testing
