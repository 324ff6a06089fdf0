// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/metashape.h"

#include "colmap_ext/import/import_test_base.h"
#include "limn/geometry/similarity3.h"

namespace limn::colmap_ext {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr char kMetashapeFormat[] = "metashape";

std::string Tag(const std::string& name, const std::string& content) {
  return "<" + name + ">" + content + "</" + name + ">\n";
}

// Of KnownModel.
std::string PinholeTags() {
  return Tag("f", "611.5") + Tag("b1", "-11.25") + Tag("cx", "-3.25") + Tag("cy", "11.125");
}

std::string SensorWith(const std::string& type, const std::string& calibration) {
  const std::string size = "<resolution width=\"640\" height=\"480\"/>";
  return "<sensors><sensor id=\"5\" type=\"" + type + "\">" + size + "<calibration type=\"" + type +
         "\" class=\"initial\">" + size + Tag("f", "1") + "</calibration><calibration type=\"" +
         type + "\" class=\"adjusted\">" + size + calibration +
         "</calibration></sensor></sensors>\n";
}

// Some labels with extension, some without; one in a group.
std::string CamerasOf(const SparseModel& model, const Similarity3d& world_from_chunk) {
  std::string cameras;
  for (const ModelImage& image : model.images) {
    const Rigid3d chunk_from_cam =
        Inverse(CamFromB(image.cam_from_world, Inverse(world_from_chunk)));
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = chunk_from_cam.rotation.toRotationMatrix();
    matrix.topRightCorner<3, 1>() = chunk_from_cam.translation;
    const bool is_second = image.name == "img_2.png";
    const std::string label = is_second ? "img_2" : image.name;
    const std::string camera = "<camera id=\"" + label + "\" sensor_id=\"5\" component_id=\"8\"" +
                               " label=\"" + label + "\">" + Tag("transform", Text(matrix)) +
                               "</camera>\n";
    cameras += is_second ? "<group>" + camera + "</group>" : camera;
  }
  return Tag("cameras", cameras + "<camera id=\"9\" sensor_id=\"5\" label=\"not_aligned\"/>");
}

std::string DocumentOf(const std::string& chunk) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<document version=\"2.0.0\">\n" +
         Tag("chunk", chunk) + "</document>\n";
}

class Metashape : public ImportTest {
 protected:
  std::string Write(const std::string& calibration, const std::string& type = "frame",
                    const std::string& cameras = CamerasOf(KnownModel(), {})) {
    return dir_.WriteFile("cameras.xml", DocumentOf(SensorWith(type, calibration) + cameras));
  }
  std::string ErrorWith(const std::string& calibration, const std::string& type = "frame") {
    return Error(kMetashapeFormat, Write(calibration, type));
  }

  const SparseModel known_ = KnownModel();
};

TEST_F(Metashape, GivesTheSameProjections) {
  Write(PinholeTags());
  const SparseModel model = Import(kMetashapeFormat, dir_.path());
  ExpectSameProjections(model, known_);
  ASSERT_EQ(model.cameras.size(), 1u);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kPinhole);
  EXPECT_THAT(notes_, Contains("1 cameras are not aligned and are left out"));
}

// P1 and P2 are OpenCV's p2 and p1.
TEST_F(Metashape, LensesBecomeColmaps) {
  const auto expect = [&](CameraModelId id, const std::vector<double>& extra,
                          const std::string& tags, const std::string& type) {
    SparseModel expected = known_;
    expected.cameras[0].model = id;
    expected.cameras[0].params.insert(expected.cameras[0].params.end(), extra.begin(), extra.end());
    const SparseModel model = Import(kMetashapeFormat, Write(PinholeTags() + tags, type));
    EXPECT_EQ(model.cameras[0].model, id);
    ExpectSameProjections(model, expected);
  };
  const std::string radial = Tag("k1", "-0.12") + Tag("k2", "0.04") + Tag("k3", "0.01");
  const std::string tangential = Tag("p1", "-0.002") + Tag("p2", "0.001");
  expect(CameraModelId::kFullOpencv, {-0.12, 0.04, 0.001, -0.002, 0.01, 0, 0, 0},
         radial + tangential, "frame");
  expect(CameraModelId::kOpencvFisheye, {-0.12, 0.04, 0.01, 0.02}, radial + Tag("k4", "0.02"),
         "fisheye");
  expect(CameraModelId::kThinPrismFisheye, {-0.12, 0.04, 0.001, -0.002, 0.01, 0.02, 0, 0},
         radial + tangential + Tag("k4", "0.02"), "equidistant_fisheye");
}

TEST_F(Metashape, TransformsOfComponentOrChunkLeadToTheWorld) {
  Similarity3d world;
  world.scale = 2.5;
  world.rotation = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  world.translation = {40, -30, 20};
  const std::string transform =
      Tag("transform", "<rotation locked=\"true\">" + Text(Eigen::MatrixXd(world.rotation)) +
                           "</rotation>" + Tag("translation", "40 -30 20") + Tag("scale", "2.5"));
  const std::string chunk = SensorWith("frame", PinholeTags()) + CamerasOf(known_, world);
  for (const std::string& more :
       {transform, transform + "<components><component id=\"3\"/></components>",
        "<components><component id=\"8\">" + transform + "</component></components>" +
            Tag("transform", Tag("scale", "7"))}) {
    const std::string path = dir_.WriteFile("cameras.xml", DocumentOf(chunk + more));
    ExpectSameProjections(Import(kMetashapeFormat, path), known_);
  }
}

TEST_F(Metashape, OfSeveralChunksTheLargestIsRead) {
  const std::string full = SensorWith("frame", PinholeTags()) + CamerasOf(known_, {});
  SparseModel few = known_;
  few.images.resize(1);
  const std::string path =
      dir_.WriteFile("cameras.xml", DocumentOf(SensorWith("frame", PinholeTags()) +
                                               CamerasOf(few, {}) + "</chunk>\n<chunk>" + full));
  EXPECT_EQ(Import(kMetashapeFormat, path).images.size(), 3u);
  EXPECT_THAT(notes_, Contains(HasSubstr("chunk 1 of 2 (counted from 0)")));
  Arguments arguments;
  arguments.model_index = 0;
  EXPECT_EQ(Import(kMetashapeFormat, path, arguments).images.size(), 1u);
}

TEST_F(Metashape, LittleSkewIsDropped) {
  ExpectSameProjections(Import(kMetashapeFormat, Write(PinholeTags() + Tag("b2", "-0.3"))), known_);
  EXPECT_THAT(notes_, Contains(HasSubstr("b2 is dropped, which moves pixels by up to 0.117")));
  EXPECT_THAT(ErrorWith(PinholeTags() + Tag("b2", "3")), HasSubstr("b2 skews the pixels by 1.1"));
}

TEST_F(Metashape, BadFilesAreRefused) {
  EXPECT_THAT(ErrorWith(Tag("cx", "1")), HasSubstr("<calibration> has no <f>"));
  EXPECT_THAT(ErrorWith(Tag("f", "-611.5")), HasSubstr("the focal length is not positive"));
  EXPECT_THAT(ErrorWith(Tag("f", "nan")), HasSubstr("cameras.xml: line "));
  EXPECT_THAT(ErrorWith(Tag("f", "1 2")), HasSubstr("<f> is not 1 numbers"));
  EXPECT_THAT(ErrorWith(PinholeTags() + Tag("p3", "0.1")), HasSubstr("P3 and P4"));
  EXPECT_THAT(ErrorWith(PinholeTags(), "spherical"), HasSubstr("\"spherical\" are not read"));
  const auto error_of = [&](const std::string& from, const std::string& to) {
    std::string text = DocumentOf(SensorWith("frame", PinholeTags()) + CamerasOf(known_, {}));
    for (size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
    return Error(kMetashapeFormat, dir_.WriteFile("cameras.xml", text));
  };
  EXPECT_THAT(error_of("sensor_id=\"5\"", "sensor_id=\"6\""),
              HasSubstr("sensor \"6\" is not among the sensors"));
  EXPECT_THAT(error_of("calibration", "no"), HasSubstr("has no <calibration>: align"));
  EXPECT_THAT(error_of("width=\"640\"", "width=\"100\""), HasSubstr("another aspect"));
  EXPECT_THAT(error_of("width=\"640\"", ""), HasSubstr("is not 1 numbers"));
  EXPECT_THAT(error_of("img_1.png", "img_7.png"), HasSubstr("image \"img_7.png\" is not in"));
  EXPECT_THAT(error_of("<transform>", "<transform>7 "), HasSubstr("is not 16 numbers"));
  EXPECT_THAT(error_of("</transform>", "0</transform>"), HasSubstr("line"));
  EXPECT_THAT(error_of("chunk>", "block>"), HasSubstr("no <chunk> of Metashape"));
  EXPECT_THAT(error_of("</chunk>", ""), HasSubstr("not XML"));
}

}  // namespace
}  // namespace limn::colmap_ext
