// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/realitycapture.h"

#include <cmath>

#include "colmap_ext/import/import_test_base.h"
#include "limn/util/angles.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

constexpr char kRealityCaptureFormat[] = "realitycapture";
constexpr char kColumns[] = "#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\n";
// In pixels 640 * 33.75 / 36 = 600.
constexpr char kPinhole[] = "33.75,-0.005078125,0.0173828125";

// The angles of a camera, from the matrix that they make.
std::string PoseWords(const Rigid3d& cam_from_world) {
  const Rigid3d world_from_cam = Inverse(cam_from_world);
  const Eigen::Matrix3d m =
      world_from_cam.rotation.toRotationMatrix() * Eigen::DiagonalMatrix<double, 3>(1, -1, -1);
  std::string words;
  for (const double number : {world_from_cam.translation.x(), world_from_cam.translation.y(),
                              world_from_cam.translation.z(), std::atan2(m(0, 1), m(1, 1)) / kDeg,
                              std::asin(m(2, 1)) / kDeg, std::atan2(-m(2, 0), m(2, 2)) / kDeg}) {
    words += "," + Text(number);
  }
  return words;
}

std::string RowsOf(const SparseModel& model, const std::string& lens) {
  std::string rows;
  for (const ModelImage& image : model.images) {
    rows += image.name + PoseWords(image.cam_from_world) + "," + kPinhole + "," + lens + "\n";
  }
  return rows;
}

class RealityCapture : public ImportTest {
 protected:
  RealityCapture() { known_.cameras[0].params = {600, 600, 316.75, 251.125}; }
  std::string Write(const std::string& text) { return dir_.WriteFile("cameras.csv", text); }
  std::string ErrorWith(const std::string& text) {
    return Error(kRealityCaptureFormat, Write(text));
  }

  SparseModel known_ = KnownModel();
};

TEST_F(RealityCapture, GivesTheSameProjections) {
  const std::string rows = RowsOf(known_, "0,0,0,0,0,0");
  Write(kColumns + rows);
  const SparseModel model = Import(kRealityCaptureFormat, dir_.path());
  ExpectSameProjections(model, known_);
  EXPECT_EQ(model.cameras.size(), 1u);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kPinhole);
  ExpectSameProjections(Import(kRealityCaptureFormat,
                               Write("\xEF\xBB\xBF#cameras 3\r\n" + std::string(kColumns) + rows)),
                        known_);
  known_.cameras[0].model = CameraModelId::kFullOpencv;
  known_.cameras[0].params = {600, 600, 316.75, 251.125, -.1, .05, .001, -.002, .01, 0, 0, 0};
  ExpectSameProjections(
      Import(kRealityCaptureFormat, Write(kColumns + RowsOf(known_, "-.1,.05,.01,0,.001,-.002"))),
      known_);
}

// Straight down, the upper side to the north.
TEST_F(RealityCapture, WithoutAnglesCamerasLookDown) {
  const auto project = [&](const std::string& angles, const Eigen::Vector3d& point) {
    const SparseModel model =
        Import(kRealityCaptureFormat,
               Write("#name,x,y,alt,heading,pitch,roll,f\nimg_1.png,0,0,10," + angles + ",36\n"));
    const Eigen::Vector2d px = Project(model, model.images[0], point);
    return Eigen::Vector2d(px.x() - 320, px.y() - 240);
  };
  EXPECT_LT((project("0,0,0", {1, 2, 0}) - Eigen::Vector2d(64, -128)).norm(), 1e-6);
  // To the east: what is in the east is at the top.
  EXPECT_LT((project("90,0,0", {1, 0, 0}) - Eigen::Vector2d(0, -64)).norm(), 1e-6);
  // Ahead, to the north.
  EXPECT_LT((project("0,90,0", {1, 10, 11}) - Eigen::Vector2d(64, -64)).norm(), 1e-6);
}

TEST_F(RealityCapture, ColumnsMayBeInAnyOrder) {
  const std::string path =
      Write("#f,name,color,alt,y,x,roll,pitch,heading\n36,img_2.png,red,3,2,1,0,0,0\n\n");
  const SparseModel model = Import(kRealityCaptureFormat, path);
  ASSERT_EQ(model.images.size(), 1u);
  const Eigen::Vector3d center = Inverse(model.images[0].cam_from_world).translation;
  EXPECT_LT((center - Eigen::Vector3d(1, 2, 3)).norm(), 1e-12);
  EXPECT_EQ(model.cameras[0].params, (std::vector<double>{640, 640, 320, 240}));
}

TEST_F(RealityCapture, BadFilesAreRefused) {
  const std::string rows = RowsOf(known_, "0,0,0,0,0,0");
  EXPECT_THAT(ErrorWith(""), HasSubstr("no line with the names of the columns"));
  EXPECT_THAT(ErrorWith("#name,x,y,alt,heading,pitch,roll\n"),
              HasSubstr("line 1: no column \"f\": export Internal/External"));
  EXPECT_THAT(ErrorWith(kColumns + rows + "img_1.png,1,2\n"),
              HasSubstr("line 5: there are 16 columns, but 3 words"));
  EXPECT_THAT(ErrorWith(kColumns + std::string("img_1.png,1,2,3,0,0,0,x,0,0,0,0,0,0,0,0\n")),
              HasSubstr("line 2: \"f\" is not a finite number"));
  EXPECT_THAT(ErrorWith(kColumns + std::string("img_1.png,nan,2,3,0,0,0,35,0,0,0,0,0,0,0,0\n")),
              HasSubstr("\"x\" is not a finite number"));
  EXPECT_THAT(ErrorWith(kColumns + std::string("img_1.png,1,2,3,0,0,0,-35,0,0,0,0,0,0,0,0\n")),
              HasSubstr("the focal length is not positive"));
  EXPECT_THAT(ErrorWith(kColumns + std::string("none.png,1,2,3,0,0,0,35,0,0,0,0,0,0,0,0\n")),
              HasSubstr("image \"none.png\" is not in the image folder"));
}

}  // namespace
}  // namespace limn::colmap_ext
