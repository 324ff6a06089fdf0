// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/opensfm.h"

#include <nlohmann/json.hpp>

#include "colmap_ext/import/import_test_base.h"

namespace limn::colmap_ext {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr char kOpensfmFormat[] = "opensfm";

Json VectorJson(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json ShotsOf(const SparseModel& model) {
  Json shots;
  for (const ModelImage& image : model.images) {
    const Eigen::AngleAxisd turn(image.cam_from_world.rotation);
    shots[image.name] = {{"rotation", VectorJson(turn.angle() * turn.axis())},
                         {"translation", VectorJson(image.cam_from_world.translation)},
                         {"camera", "c"}};
  }
  return shots;
}

// Relative to the longer side of 640 px.
Json BrownOf(const SparseModel& model) {
  const std::vector<double>& p = model.cameras[0].params;
  return {{"projection_type", "brown"}, {"width", 640},          {"height", 480},
          {"focal_x", p[0] / 640},      {"focal_y", p[1] / 640}, {"c_x", (p[2] - 320) / 640},
          {"c_y", (p[3] - 240) / 640}};
}

class Opensfm : public ImportTest {
 protected:
  std::string Write(const Json& camera, const Json& shots) {
    return dir_.WriteFile("reconstruction.json",
                          Json{{{"cameras", {{"c", camera}}}, {"shots", shots}}}.dump());
  }
  std::string ErrorWith(const Json& camera, const Json& shots) {
    return Error(kOpensfmFormat, Write(camera, shots));
  }

  const SparseModel known_ = KnownModel();
};

TEST_F(Opensfm, GivesTheSameProjections) {
  Write(BrownOf(known_), ShotsOf(known_));
  const SparseModel model = Import("opensfm", dir_.path());
  ExpectSameProjections(model, known_);
  EXPECT_EQ(model.cameras.size(), 1u);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kPinhole);
}

TEST_F(Opensfm, NullsCountAsMissing) {
  Json camera = BrownOf(known_);
  camera["k1"] = camera["p1"] = nullptr;
  const Json file = {
      {{"cameras", {{"c", camera}}}, {"shots", ShotsOf(known_)}, {"points", nullptr}}};
  ExpectSameProjections(Import(kOpensfmFormat, dir_.WriteFile("reconstruction.json", file.dump())),
                        known_);
}

TEST_F(Opensfm, LensesBecomeColmaps) {
  const auto expect = [&](CameraModelId id, const std::vector<double>& extra, const Json& lens) {
    SparseModel expected = known_;
    expected.cameras[0].model = id;
    expected.cameras[0].params.insert(expected.cameras[0].params.end(), extra.begin(), extra.end());
    Json camera = BrownOf(known_);
    camera.update(lens);
    const SparseModel model = Import(kOpensfmFormat, Write(camera, ShotsOf(known_)));
    EXPECT_EQ(model.cameras[0].model, id);
    ExpectSameProjections(model, expected);
  };
  expect(CameraModelId::kFullOpencv, {-0.12, 0.04, 0.001, -0.002, 0.01, 0, 0, 0},
         {{"k1", -0.12}, {"k2", 0.04}, {"p1", 0.001}, {"p2", -0.002}, {"k3", 0.01}});
  expect(CameraModelId::kOpencv, {-0.12, 0.04, 0, 0},
         {{"projection_type", "radial"}, {"k1", -0.12}, {"k2", 0.04}});
  expect(CameraModelId::kOpencvFisheye, {-0.02, 0.005, -0.003, 0.0005},
         {{"projection_type", "fisheye_opencv"},
          {"k1", -0.02},
          {"k2", 0.005},
          {"k3", -0.003},
          {"k4", 0.0005}});
  const SparseModel centered = CenteredModel(-0.1, 0.05);
  const double focal = centered.cameras[0].params[0] / 640;
  const SparseModel model = Import(kOpensfmFormat, Write({{"projection_type", "perspective"},
                                                          {"width", 640},
                                                          {"height", 480},
                                                          {"focal", focal},
                                                          {"k1", -0.1},
                                                          {"k2", 0.05}},
                                                         ShotsOf(centered)));
  ExpectSameProjections(model, centered);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kRadial);
}

TEST_F(Opensfm, PointsNeedTheTracks) {
  const SparseModel centered = CenteredModel();
  Json points;
  std::string tracks = "OPENSFM_TRACKS_VERSION_v1\n";
  for (const ModelPoint& point : centered.points) {
    const std::string id = "t" + std::to_string(point.id);
    points[id] = {{"coordinates", VectorJson(point.position)},
                  {"color", {point.color[0], point.color[1], point.color[2]}}};
    for (const TrackElement& element : point.track) {
      const ModelImage& image = centered.images[element.image_id - 1];
      const Eigen::Vector2d px = image.observations[element.observation].position;
      tracks += image.name + "\t" + id + "\t5\t" + Json((px.x() - 320) / 640).dump() + "\t" +
                Json((px.y() - 240) / 640).dump() + "\t0.01\t1\t2\t3\r\n";
    }
    tracks += "other.png\t" + id + "\t5\t0\t0\t0.01\t1\t2\t3\n";
  }
  const Json camera = {{"focal", centered.cameras[0].params[0] / 640}};
  const std::string path = dir_.WriteFile(
      "reconstruction.json",
      Json{{{"cameras", {{"c", camera}}}, {"shots", ShotsOf(centered)}, {"points", points}}}
          .dump());
  EXPECT_TRUE(Import(kOpensfmFormat, path).points.empty());
  EXPECT_THAT(notes_, Contains(HasSubstr("tracks.csv")));
  dir_.WriteFile("tracks.csv", tracks);
  ExpectSamePoints(Import(kOpensfmFormat, path), centered);
  dir_.WriteFile("tracks.csv", "img_1.png\tt1\t5\t0\n");
  EXPECT_THAT(Error(kOpensfmFormat, path), HasSubstr("tracks.csv: line 1: image, track, feature"));
  dir_.WriteFile("tracks.csv", tracks + "img_1.png\tt1\t5\t0\tnan\n");
  EXPECT_THAT(Error(kOpensfmFormat, path), HasSubstr("x and y are no finite numbers"));
}

TEST_F(Opensfm, OfSeveralTheLargestIsRead) {
  Json few = ShotsOf(known_);
  few.erase("img_2.png");
  const Json cameras = {{"c", BrownOf(known_)}};
  const std::string path =
      dir_.WriteFile("reconstruction.json", Json{{{"cameras", cameras}, {"shots", few}},
                                                 {{"cameras", cameras}, {"shots", ShotsOf(known_)}}}
                                                .dump());
  EXPECT_EQ(Import(kOpensfmFormat, path).images.size(), 3u);
  EXPECT_THAT(notes_, Contains(HasSubstr("reconstruction 1 of 2 (counted from 0)")));
  Arguments arguments;
  arguments.model_index = 0;
  EXPECT_EQ(Import(kOpensfmFormat, path, arguments).images.size(), 2u);
  arguments.model_index = 2;
  EXPECT_THAT(Error(kOpensfmFormat, path, arguments),
              HasSubstr("there are only 2 reconstructions"));
}

TEST_F(Opensfm, BadFilesAreRefused) {
  const auto camera_error = [&](const Json& change) {
    Json camera = BrownOf(known_);
    camera.update(change);
    const std::string error = ErrorWith(camera, ShotsOf(known_));
    EXPECT_THAT(error, AnyOf(HasSubstr("reconstruction.json: shot 0: "),
                             HasSubstr("reconstruction.json: [0].cameras.c.")))
        << change;
    EXPECT_THAT(error, ::testing::Not(HasSubstr("json.exception")));
    return error;
  };
  EXPECT_THAT(camera_error({{"focal_x", nullptr}}),
              HasSubstr("cameras.c.focal_x: a number expected"));
  EXPECT_THAT(camera_error({{"focal_x", "1"}}), HasSubstr("cameras.c.focal_x: a number expected"));
  EXPECT_THAT(camera_error({{"focal_x", -1}}), HasSubstr("the focal length is not positive"));
  EXPECT_THAT(camera_error({{"projection_type", "dual"}}), HasSubstr("\"dual\" are not read"));
  EXPECT_THAT(camera_error({{"projection_type", 1}}),
              HasSubstr("cameras.c.projection_type: a text expected"));
  EXPECT_THAT(camera_error({{"width", 100}}), HasSubstr("another aspect"));
  EXPECT_THAT(camera_error({{"width", -640}}), HasSubstr("no size of an image"));
  const auto shot_error = [&](const char* key, const Json& value) {
    Json shots = ShotsOf(known_);
    shots["img_1.png"][key] = value;
    return ErrorWith(BrownOf(known_), shots);
  };
  EXPECT_THAT(shot_error("camera", "d"), HasSubstr("camera \"d\" is not among the cameras"));
  EXPECT_THAT(shot_error("rotation", {1, 2}),
              HasSubstr("[0].shots.img_1.png.rotation: a list of 3 numbers expected"));
  EXPECT_THAT(shot_error("translation", {1, 2, "3"}),
              HasSubstr("[0].shots.img_1.png.translation[2]: a number expected"));
  for (const char* text : {"[]", "[{}]", "[7]", "[{\"shots\": 7}]", "[{\"shots\": {}}]"}) {
    EXPECT_THAT(Error(kOpensfmFormat, dir_.WriteFile("reconstruction.json", text)),
                AllOf(HasSubstr("reconstruction.json"), ::testing::Not(HasSubstr("exception"))))
        << text;
  }
}

}  // namespace
}  // namespace limn::colmap_ext
