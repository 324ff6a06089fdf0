// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/nvm.h"

#include "colmap_ext/import/import_test_base.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/workspace/model_folder.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr char kNvmFormat[] = "nvm";

std::string CameraLine(const SparseModel& model, const ModelImage& image,
                       const std::string& distortion) {
  const Eigen::Quaterniond& q = image.cam_from_world.rotation;
  return image.name + "\t" + Text(model.CameraOf(image).params[0]) + Text(q.w()) + Text(q.x()) +
         Text(q.y()) + Text(q.z()) + Text(Inverse(image.cam_from_world).translation) + distortion +
         " 0\n";
}

// Measurements from the center of the image, unless the origin is moved.
std::string ModelText(const SparseModel& model, const std::string& distortion = "0",
                      const Eigen::Vector2d& origin = {320, 240}) {
  std::string text = std::to_string(model.images.size()) + "\n";
  for (const ModelImage& image : model.images) text += CameraLine(model, image, distortion);
  text += "\n" + std::to_string(model.points.size()) + "\n";
  for (const ModelPoint& point : model.points) {
    text += Text(point.position);
    for (const uint8_t channel : point.color) text += std::to_string(channel) + " ";
    text += std::to_string(point.track.size());
    for (const TrackElement& element : point.track) {
      const ModelImage& image = model.images[element.image_id - 1];
      text += " " + std::to_string(element.image_id - 1) + " 5 " +
              Text(image.observations[element.observation].position - origin);
    }
    text += "\n";
  }
  return text;
}

class Nvm : public ImportTest {
 protected:
  std::string Write(const std::string& models) {
    return dir_.WriteFile("scene.nvm", "NVM_V3 \n\n" + models);
  }
  std::string ErrorWith(const std::string& models) { return Error(kNvmFormat, Write(models)); }
};

TEST_F(Nvm, GivesTheSameProjectionsAndPoints) {
  const SparseModel known = CenteredModel();
  Write(ModelText(known) + "\n0\n#the last part of the file\n0\n");
  const SparseModel model = Import(kNvmFormat, dir_.path());
  ExpectSameProjections(model, known);
  EXPECT_THAT(warnings_, IsEmpty());
  ExpectSamePoints(model, known);
  ASSERT_EQ(model.cameras.size(), 1u);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kSimplePinhole);
}

TEST_F(Nvm, MeasurementsMayBeFromTheCorner) {
  const SparseModel known = CenteredModel();
  const SparseModel model = Import(kNvmFormat, Write(ModelText(known, "0", {0, 0})));
  ExpectSamePoints(model, known);
  EXPECT_THAT(notes_, Contains(HasSubstr("from the corner of the image")));
}

// VisualSFM's lens: the pinhole's position is m (1 + r |m|^2) for the measured m.
TEST_F(Nvm, DistortionIsTurnedRound) {
  const SparseModel known = CenteredModel();
  for (const double r : {0.15, 0.02, -0.08}) {
    const SparseModel model = Import(kNvmFormat, Write(ModelText(known, Text(r))));
    double max_error = 0;
    for (size_t i = 0; i < known.images.size(); ++i) {
      for (const Eigen::Vector3d& point : CubePoints()) {
        const Eigen::Vector2d center(320, 240);
        const Eigen::Vector2d measured = (Project(model, model.images[i], point) - center) / 600.25;
        const Eigen::Vector2d again = measured * (1 + r * measured.squaredNorm());
        const Eigen::Vector2d pinhole = (Project(known, known.images[i], point) - center) / 600.25;
        max_error = std::max(max_error, 600.25 * (again - pinhole).norm());
      }
    }
    EXPECT_LT(max_error, 1e-3) << r;
  }
}

TEST_F(Nvm, DistortionThatFoldsIsRefused) {
  const SparseModel known = CenteredModel();
  EXPECT_THAT(ErrorWith(ModelText(known, "-0.9")),
              HasSubstr("scene.nvm: line 4: the radial distortion -0.900000 is too strong"));
}

TEST_F(Nvm, TheLargestModelWithPointsIsRead) {
  const SparseModel known = CenteredModel();
  SparseModel small = known;
  small.points.clear();
  small.images.resize(1);
  SparseModel unregistered = known;
  unregistered.points.clear();
  const std::string path =
      Write(ModelText(small) + ModelText(known) + ModelText(unregistered) + "0\n");
  ExpectSamePoints(Import(kNvmFormat, path), known);
  EXPECT_THAT(notes_, Contains(HasSubstr("model 1 of 3")));
  Arguments arguments;
  arguments.model_index = 0;
  EXPECT_EQ(Import(kNvmFormat, path, arguments).images.size(), 1u);
  arguments.model_index = 3;
  EXPECT_THAT(Error(kNvmFormat, path, arguments), HasSubstr("there are only 3 models"));
}

TEST_F(Nvm, NamesMayHoldBlanks) {
  SparseModel known = CenteredModel();
  fs::rename(images_ / "img_2.png", images_ / "img 2 b.png");
  for (const char* name : {"img 2 b.png", "img\"2\"b.png"}) {
    known.images[1].name = name;
    EXPECT_EQ(Import(kNvmFormat, Write(ModelText(known))).images[1].name, "img 2 b.png");
  }
}

TEST_F(Nvm, FoldersOfOtherComputersAreLeftOff) {
  SparseModel known = CenteredModel();
  known.images[1].name = "C:\\my project\\img_2.png";
  known.images[2].name = "/home/nobody/img_10.png";
  const SparseModel model = Import(kNvmFormat, Write(ModelText(known)));
  EXPECT_EQ(model.images[1].name, "img_2.png");
  EXPECT_EQ(model.images[2].name, "img_10.png");
}

TEST_F(Nvm, BadFilesAreRefused) {
  const SparseModel known = CenteredModel();
  const std::string text = ModelText(known);
  EXPECT_THAT(Error(kNvmFormat, dir_.WriteFile("a.nvm", "NVM_V2\n" + text)),
              HasSubstr("a.nvm: line 1: \"NVM_V3\" expected"));
  EXPECT_THAT(Error(kNvmFormat, dir_.WriteFile("a.nvm", "NVM_V3 FixedK 600 320 600 240\n" + text)),
              HasSubstr("line 1: \"NVM_V3 FixedK 600 320 600 240\": a fixed calibration"));
  EXPECT_THAT(ErrorWith(""), HasSubstr("the file holds no model"));
  EXPECT_THAT(ErrorWith("2\nimg_1.png 600 1 0 0 0 0 0 -6 0 0\n"),
              HasSubstr("the file ends before its last camera"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 600 1 0 0 0 0 0 0 0\n0\n"),
              HasSubstr("line 4: a camera is a name and ten numbers"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 600 1 0 0 x 0 0 -6 0 0\n0\n"),
              HasSubstr("line 4: quaternion expected, not \"x\""));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 600 nan 0 0 0 0 0 -6 0 0\n0\n"),
              HasSubstr("line 4: quaternion is not finite"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 600 0 0 0 0 0 0 -6 0 0\n0\n"),
              HasSubstr("line 4: img_1.png: the rotation is a zero quaternion"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 0 1 0 0 0 0 0 -6 0 0\n0\n"),
              HasSubstr("line 4: the focal length is not positive"));
  EXPECT_THAT(ErrorWith("1\nnone.png 600 1 0 0 0 0 0 -6 0 0\n0\n"),
              HasSubstr("line 4: image \"none.png\" is not in the image folder"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 600 1 0 0 0 0 0 -6 0 0\n2\n0 0 0 1 1 1 0\n"),
              HasSubstr("the file ends before its last point"));
  EXPECT_THAT(ErrorWith("1\nimg_1.png 600 1 0 0 0 0 0 -6 0 0\n1\n0 0 0 1 1 1 1 1 0 2 3\n"),
              HasSubstr("line 6: camera index 1, but there are only 1 cameras"));
}

TEST_F(Nvm, ReadsWhatColmapWrites) {
  if (!HaveColmap()) GTEST_SKIP() << "the colmap program is not installed";
  const fs::path day = fs::path(LIMN_SAMPLE_DIR) / "day";
  ASSERT_TRUE(RunColmap("model_converter --output_type NVM --input_path '" +
                            (day / "sparse").string() + "' --output_path '" +
                            (dir_ / "day.nvm").string() + "'",
                        dir_ / "log"));
  images_ = day / "images";
  const SparseModel model = Import(kNvmFormat, dir_ / "day.nvm");
  ExpectSameAfterExport(model, ReadModel(day / "sparse"), {0, 0}, Repeats::kFirst);
}

}  // namespace
}  // namespace limn::colmap_ext
