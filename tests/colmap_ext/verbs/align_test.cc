// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/align.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/test_database.h"
#include "limn/alignment/geodetic.h"
#include "limn/alignment/wire_room.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using limn::testing::DatabaseVersion;
using limn::testing::StoredPrior;
using limn::testing::WriteDatabase;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr int kNumImages = 8;

// Keeps the lines.
class LineConsole : public Console {
 public:
  LineConsole() : Console(1) {}
  void ShowTable(const std::string&) override {}
  const std::string& text() const { return text_; }

 private:
  void ShowLine(const std::string& line) override { text_ += line + "\n"; }
  void ShowStage(const RunLog::Stage&) override {}

  std::string text_;
};

// The place this many meters east, north and up of one in Switzerland.
Eigen::Vector3d GeographicAt(const Eigen::Vector3d& meters) {
  constexpr double kLatitude = 47, kLongitude = 8, kFlatness = 0.00669438, kRadius = 6378137;
  const double sine = std::sin(kLatitude * kDeg);
  const double root = std::sqrt(1 - kFlatness * sine * sine);
  const double north = kRadius * (1 - kFlatness) / (root * root * root);
  const double east = kRadius / root * std::cos(kLatitude * kDeg);
  return {kLatitude + meters.y() / north / kDeg, kLongitude + meters.x() / east / kDeg,
          400 + meters.z()};
}

// A room in meters with cameras in it, and the workspace W/dense/0 of a model that was turned and
// scaled. The images show nothing.
class AlignmentRun : public ::testing::Test {
 protected:
  AlignmentRun() {
    const auto height = [](int i) { return i % 3 == 0 ? 0.6 : 1.0 + 0.1 * i; };
    for (int i = 0; i < kNumImages; ++i) {
      const double azimuth = 2 * M_PI * i / kNumImages;
      cameras_.push_back(limn::testing::LookAt(
          {1.5 * std::cos(azimuth), 1.2 * std::sin(azimuth), height(i)}, {0, 0, 1}));
    }
  }

  // Files with images of this camera, and the scene.
  void Write(const Camera& camera) {
    SparseModel model;
    model.cameras = {camera};
    for (const char* folder : {"images", "sparse"}) {
      fs::create_directories(dir_ / "dense/0" / folder);
    }
    for (int i = 0; i < kNumImages; ++i) {
      ModelImage image;
      image.id = i + 1;
      image.camera_id = camera.id;
      image.name = Name(i);
      image.cam_from_world = CamFromB(cameras_[i].cam_from_world, Inverse(world_from_model_));
      // Images of the same bytes are duplicates.
      const cv::Mat pixels(static_cast<int>(camera.height), static_cast<int>(camera.width), CV_8UC1,
                           cv::Scalar(90 + i));
      cv::imwrite((dir_ / "dense/0/images" / image.name).string(), pixels);
      model.images.push_back(image);
    }
    WriteModelText(model, dir_ / "dense/0/sparse");
    options_.layout.workspace_path = (dir_ / "dense/0").string();
    scene_.emplace(ResolveLayout(options_.layout), options_, &console_);
  }
  void WritePhotographs() { Write({1, CameraModelId::kPinhole, 64, 48, {50, 50, 32, 24}}); }
  void WritePanoramas() { Write({1, CameraModelId::kEquirectangular, 256, 128, {256, 128}}); }

  static std::string Name(int image) { return std::to_string(image) + ".png"; }
  std::string Database() const { return (dir_ / "database.db").string(); }

  // Gravity and geographic positions, off by a millimeter, of all images.
  std::vector<StoredPrior> Priors() const {
    std::mt19937 random(1);
    std::vector<StoredPrior> priors;
    for (int i = 0; i < kNumImages; ++i) {
      const Eigen::Vector3d error = 0.001 * limn::testing::RandomDirection(&random);
      StoredPrior prior{Name(i), GeographicAt(cameras_[i].CenterInWorld() + error)};
      prior.gravity = cameras_[i].cam_from_world.rotation * Eigen::Vector3d(0, 0, -9.81);
      priors.push_back(prior);
    }
    return priors;
  }

  Alignment Align(const std::string& database_path = "") {
    AlignOptions options;
    options.mode = AlignOptions::Mode::kAuto;
    options.database_path = database_path;
    return AlignWith(options);
  }

  Alignment AlignWith(const AlignOptions& options) {
    const SceneAligner aligner(*scene_, options_.layout, options, &console_);
    const DrawingGraph graph =
        limn::testing::Moved(limn::testing::WireRoom(), Inverse(world_from_model_));
    return *aligner.Align(scene_->views(), graph, &console_);
  }

  void ExpectTruth(const Alignment& found, double max_deg = 0.01) const {
    const Similarity3d& world_from_model = found.world_from_model;
    EXPECT_NEAR(world_from_model.scale / world_from_model_.scale, 1, 1e-3);
    for (const int axis : {0, 2}) {
      EXPECT_LT(limn::testing::AngleDeg(world_from_model.rotation.row(axis),
                                        world_from_model_.rotation.row(axis)),
                max_deg)
          << axis;
    }
  }

  const Similarity3d world_from_model_ = limn::testing::RandomSimilarity(2, 5);
  std::vector<View> cameras_;
  TempDir dir_;
  RunOptions options_;
  LineConsole console_;
  std::optional<Scene> scene_;
};

TEST_F(AlignmentRun, GravityAndPlacesOfADatabaseAboveTheModel) {
  WritePhotographs();
  WriteDatabase(Database(), DatabaseVersion::k4_1, Priors());
  const Alignment alignment = Align();
  EXPECT_EQ(alignment.up, UpSource::kGravity);
  EXPECT_EQ(alignment.scale, ScaleSource::kPositions);
  ExpectTruth(alignment);
  EXPECT_THAT(console_.text(), HasSubstr("alignment: " + Database() +
                                         " has positions of 8 and gravity of 8 of 8 images\n"));
  EXPECT_THAT(console_.log().warnings, IsEmpty());
}

TEST_F(AlignmentRun, EarthCenteredPositionsAreGeographicOnes) {
  WritePhotographs();
  std::vector<StoredPrior> priors = Priors();
  for (StoredPrior& prior : priors) {
    const Eigen::Vector3d at = prior.position;
    prior.position = EarthFixed({at.x(), at.y(), at.z()});
    prior.coordinate_system = 1;
    prior.gravity.setConstant(limn::testing::kNotGiven);
  }
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  const Alignment alignment = Align();
  EXPECT_EQ(alignment.up, UpSource::kPositions);
  EXPECT_EQ(alignment.scale, ScaleSource::kPositions);
  ExpectTruth(alignment, /*max_deg=*/0.05);  // a millimeter across the room is 0.02
  EXPECT_THAT(console_.text(), HasSubstr("earth-centered (ECEF)"));
}

TEST_F(AlignmentRun, GravityThatIsNotUsedGetsAReason) {
  WritePhotographs();
  std::vector<StoredPrior> priors = Priors();
  const auto align = [&] {
    fs::remove(Database());
    WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
    EXPECT_NE(Align().up, UpSource::kGravity);
  };
  for (int i = 0; i < kNumImages; ++i) {
    priors[i].gravity = {i % 2 == 0 ? 1.0 : -1.0, 2, -0.5 * i - 1};  // held in any way
  }
  align();
  EXPECT_THAT(console_.text(), AllOf(HasSubstr("and gravity of 8 of 8 images\n"),
                                     HasSubstr("gravity of 8 cameras is not used: it differs by "),
                                     HasSubstr(" degrees (median)\n")));
  for (int i = 2; i < kNumImages; ++i) priors[i].gravity = {0, 1, 0};
  align();
  EXPECT_THAT(console_.text(),
              AllOf(HasSubstr("and gravity of 2 of 8 images, only the orientation flag of 6\n"),
                    HasSubstr("gravity of 2 cameras is not used: 3 that agree are needed\n")));
}

TEST_F(AlignmentRun, FewPositionsAreNotCalledFar) {
  WritePhotographs();
  std::vector<StoredPrior> priors = Priors();
  priors.resize(5);
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  ExpectTruth(Align());
  EXPECT_THAT(console_.log().warnings, IsEmpty());
  priors.resize(3);
  fs::remove(Database());
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  EXPECT_EQ(Align().scale, ScaleSource::kNone);
  EXPECT_THAT(console_.text(), HasSubstr("positions of 3 cameras are not used: 4 at different"));
}

TEST_F(AlignmentRun, ADatabaseThatIsBeingChangedIsNotUsed) {
  WritePhotographs();
  WriteDatabase(Database(), DatabaseVersion::k4_1, Priors());
  dir_.WriteFile("database.db-wal", "\x37\x7f\x06\x82" + std::string(60, 'x'));
  EXPECT_EQ(Align().up, UpSource::kLines);
  EXPECT_THAT(console_.log().warnings,
              ElementsAre(AllOf(HasSubstr("alignment without a database: " + Database()),
                                HasSubstr("database.db-wal has changes"))));
  EXPECT_THROW(Align(Database()), IoError);
}

TEST_F(AlignmentRun, PositionsThatContradictSomethingAreNamed) {
  WritePhotographs();
  const auto align = [&](bool fails, const std::vector<StoredPrior>& priors,
                         const std::string& text) {
    fs::remove(Database());
    WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
    AlignOptions options;
    options.mode = AlignOptions::Mode::kAuto;
    options.contradictions_fail = fails;
    const size_t num_warnings = console_.log().warnings.size();
    if (fails) {
      EXPECT_THAT([&] { AlignWith(options); },
                  ThrowsMessage<IoError>(AllOf(HasSubstr(Database() + ": positions of "),
                                               HasSubstr(text), HasSubstr("--use_positions 0"))));
      options.use_positions = false;
      EXPECT_EQ(AlignWith(options).scale, ScaleSource::kNone);
      return;
    }
    EXPECT_EQ(AlignWith(options).scale, ScaleSource::kNone);
    ASSERT_EQ(console_.log().warnings.size(), num_warnings + 1);
    EXPECT_THAT(console_.log().warnings.back(), AllOf(HasSubstr(text), HasSubstr("not used")));
  };
  const std::vector<StoredPrior> right = Priors();
  std::vector<StoredPrior> wrong = right;
  for (StoredPrior& prior : wrong) {
    prior.gravity.setConstant(limn::testing::kNotGiven);
    std::swap(prior.position.x(), prior.position.y());
  }
  align(true, wrong, "latitude and longitude are exchanged");
  align(false, wrong, "latitude and longitude are exchanged");
  wrong = right;
  for (int i = 0; i < kNumImages; ++i) {
    wrong[i].coordinate_system = 1;
    wrong[i].position = cameras_[i].CenterInWorld().cwiseProduct(Eigen::Vector3d(1, -1, 1));
  }
  align(true, wrong, "they are mirrored");
  // Against gravity only: y is up.
  for (int i = 0; i < kNumImages; ++i) {
    const Eigen::Vector3d at = cameras_[i].CenterInWorld();
    wrong[i].position = {at.x(), at.z(), -at.y()};
  }
  constexpr int kOrder[] = {3, 6, 1, 4, 7, 2, 0, 5};
  align(true, wrong, "contradict the gravity that 8 measured: their ups are 90 degrees apart");
  for (int i = 0; i < kNumImages; ++i) {
    wrong[i].position = cameras_[kOrder[i]].CenterInWorld();
  }
  align(false, wrong, "no better than in another order");
}

TEST_F(AlignmentRun, ByWrongPositionsPhotographsWouldBeUpsideDown) {
  // On one level: the mirror image fits too.
  for (int i = 0; i < kNumImages; ++i) {
    const double azimuth = 2 * M_PI * i / kNumImages, radius = 1.2 + 0.1 * (i % 3);
    cameras_[i] = limn::testing::LookAt(
        {radius * std::cos(azimuth), radius * std::sin(azimuth), 1.2}, {0, 0, 1});
  }
  WritePhotographs();
  std::vector<StoredPrior> priors = Priors();
  for (int i = 0; i < kNumImages; ++i) {
    const Eigen::Vector3d at = cameras_[i].CenterInWorld();
    priors[i] = {Name(i), {at.y(), at.x(), at.z()}, 1};
  }
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  AlignOptions options;
  options.mode = AlignOptions::Mode::kAuto;
  options.contradictions_fail = true;
  EXPECT_THAT([&] { AlignWith(options); },
              ThrowsMessage<IoError>(HasSubstr("by them 8 of 8 were taken upside down (0.png")));
}

TEST_F(AlignmentRun, KnownLengthsContradictPositionsOfAnotherUnit) {
  WritePhotographs();
  std::vector<StoredPrior> priors = Priors();
  for (int i = 0; i < kNumImages; ++i) {
    priors[i].coordinate_system = 1;
    priors[i].position = cameras_[i].CenterInWorld() / 0.3048;
  }
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  AlignOptions options;
  options.mode = AlignOptions::Mode::kAuto;
  options.known_lengths = {"link 0 = 5 m"};
  EXPECT_EQ(AlignWith(options).scale, ScaleSource::kLengths);
  EXPECT_THAT(console_.log().warnings,
              ElementsAre(HasSubstr("contradict the known length \"link 0 = 5 m\"")));
}

TEST_F(AlignmentRun, PositionsAreFarByTheirAccuracy) {
  WritePhotographs();
  std::vector<StoredPrior> priors = Priors();
  for (StoredPrior& prior : priors) prior.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  priors[2].covariance = 25 * Eigen::Matrix3d::Identity();
  priors[2].position.z() += 5;
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  ExpectTruth(Align());
  EXPECT_THAT(console_.log().warnings, IsEmpty());
  priors[5].position.z() += 0.05;
  fs::remove(Database());
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  ExpectTruth(Align());
  EXPECT_THAT(console_.log().warnings,
              ElementsAre(HasSubstr("far from their cameras are left out: 5.png (")));
}

TEST_F(AlignmentRun, PanoramasCountOnceEach) {
  // Held in any way.
  for (int i = 0; i < kNumImages; ++i) {
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(0.7 * i, Eigen::Vector3d(2, 1, i).normalized()));
    cameras_[i].cam_from_world =
        Rigid3d{turn, Eigen::Vector3d::Zero()} * cameras_[i].cam_from_world;
  }
  WritePanoramas();
  ASSERT_EQ(scene_->views().size(), size_t{kNumImages * kNumPanoramaParts});
  std::vector<StoredPrior> priors = Priors();
  priors[3].gravity = {0, 1, 0};  // not measured
  priors[4].position.x() += 1;    // 100 km off
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  const Alignment alignment = Align();
  EXPECT_EQ(alignment.up, UpSource::kGravity);
  ExpectTruth(alignment);
  EXPECT_THAT(console_.text(), AllOf(HasSubstr("positions of 8 and gravity of 7 of 8 images\n"),
                                     HasSubstr("the gravity that 7 cameras measured")));
  EXPECT_THAT(
      console_.log().warnings,
      ElementsAre(AllOf(HasSubstr("far from their cameras are left out: 4.png"), HasSubstr(" m"))));
}

TEST_F(AlignmentRun, ADatabaseThatWasFoundDoesNotStopIt) {
  WritePhotographs();
  // Of another image: no matter.
  std::vector<StoredPrior> priors = Priors();
  priors.push_back({"other.png", {1, 2, 3}, 1});
  WriteDatabase(Database(), DatabaseVersion::k4_1, priors);
  ExpectTruth(Align());
  // Of another program.
  const std::string foreign = dir_.WriteFile("dense/database.db", "something else");
  EXPECT_EQ(Align().up, UpSource::kLines);
  EXPECT_THAT(console_.log().warnings,
              ElementsAre(HasSubstr("alignment without a database: " + foreign)));
  EXPECT_THROW(Align(foreign), IoError);
}

}  // namespace
}  // namespace limn::colmap_ext
