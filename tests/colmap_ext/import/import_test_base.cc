// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/import_test_base.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include <opencv2/imgcodecs.hpp>

#include "colmap_ext/import/new_model_folder.h"
#include "colmap_ext/model/camera_projection.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kNames = {"img_1.png", "img_2.png", "img_10.png"};

const ModelImage* FindImage(const SparseModel& model, const std::string& name) {
  for (const ModelImage& image : model.images) {
    if (image.name == name) return &image;
  }
  return nullptr;
}

void Measure(const Eigen::Vector3d& position, size_t num_images, SparseModel* model) {
  ModelPoint point;
  point.id = model->points.size() + 1;
  point.position = position;
  point.color = {static_cast<uint8_t>(10 * point.id), 200, 255};
  for (size_t i = 0; i < num_images; ++i) {
    ModelImage& image = model->images[i];
    point.track.push_back({image.id, static_cast<uint32_t>(image.observations.size())});
    image.observations.push_back({Project(*model, image, position), point.id});
  }
  model->points.push_back(point);
}

}  // namespace

SparseModel KnownModel() {
  SparseModel model;
  Camera camera;
  camera.id = 1;
  camera.width = 640;
  camera.height = 480;
  camera.params = {600.25, 611.5, 316.75, 251.125};
  model.cameras = {camera};
  for (size_t i = 0; i < kNames.size(); ++i) {
    ModelImage image;
    image.id = static_cast<uint32_t>(i + 1);
    image.camera_id = 1;
    image.name = kNames[i];
    const double angle = 2.3 * static_cast<double>(i) - 1.1;
    image.cam_from_world.rotation =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -0.5).normalized());
    image.cam_from_world.translation = {0.1 * angle, -0.25, 6.0 + 0.3 * angle};
    model.images.push_back(image);
  }
  return model;
}

SparseModel CenteredModel(double k1, double k2) {
  SparseModel model = KnownModel();
  Camera& camera = model.cameras.front();
  camera.model = CameraModelId::kSimplePinhole;
  camera.params = {600.25, 320, 240};
  if (k1 != 0 || k2 != 0) {
    camera.model = CameraModelId::kRadial;
    camera.params.insert(camera.params.end(), {k1, k2});
  }
  Measure({0.5, -0.25, 0.75}, 3, &model);
  Measure({-0.9, 0.1, 0.2}, 3, &model);
  Measure({0.1, 0.8, -0.6}, 2, &model);
  return model;
}

std::vector<Eigen::Vector3d> CubePoints() {
  std::vector<Eigen::Vector3d> points;
  for (const double x : {-1.0, 0.1, 1.0}) {
    for (const double y : {-1.0, 0.2, 1.0}) {
      for (const double z : {-1.0, 0.3, 1.0}) points.emplace_back(x, y, z);
    }
  }
  return points;
}

Eigen::Vector2d Project(const SparseModel& model, const ModelImage& image,
                        const Eigen::Vector3d& point) {
  const Eigen::Vector3d in_cam = image.cam_from_world * point;
  EXPECT_GT(in_cam.z(), 0) << image.name;
  const CameraProjection projection(IntrinsicsOf(model.CameraOf(image)));
  const auto pixel = projection.PixelFromRay(in_cam.hnormalized());
  EXPECT_TRUE(pixel.has_value()) << image.name;
  return pixel.value_or(Eigen::Vector2d::Constant(NAN));
}

void ExpectSameProjections(const SparseModel& actual, const SparseModel& expected,
                           double tolerance_px) {
  ASSERT_EQ(actual.images.size(), expected.images.size());
  for (const ModelImage& image : expected.images) {
    const ModelImage* other = FindImage(actual, image.name);
    ASSERT_NE(other, nullptr) << image.name;
    for (const Eigen::Vector3d& point : CubePoints()) {
      const Eigen::Vector2d difference =
          Project(actual, *other, point) - Project(expected, image, point);
      EXPECT_LT(difference.norm(), tolerance_px) << image.name;
    }
  }
}

void ExpectSamePoints(const SparseModel& actual, const SparseModel& expected) {
  ASSERT_EQ(actual.points.size(), expected.points.size());
  for (size_t i = 0; i < expected.points.size(); ++i) {
    const ModelPoint& a = actual.points[i];
    const ModelPoint& e = expected.points[i];
    EXPECT_EQ(a.position, e.position);
    EXPECT_EQ(a.color, e.color);
    ASSERT_EQ(a.track.size(), e.track.size());
    for (size_t k = 0; k < e.track.size(); ++k) {
      const ModelImage& image_a = actual.images[a.track[k].image_id - 1];
      const ModelImage& image_e = expected.images[e.track[k].image_id - 1];
      EXPECT_EQ(image_a.name, image_e.name);
      const Observation& measured_a = image_a.observations.at(a.track[k].observation);
      const Observation& measured_e = image_e.observations.at(e.track[k].observation);
      EXPECT_EQ(measured_a.point3D_id, a.id);
      EXPECT_LT((measured_a.position - measured_e.position).norm(), 1e-6);
    }
  }
}

void ExpectSameAfterExport(const SparseModel& actual, const SparseModel& original,
                           const Eigen::Vector2d& shift_px, Repeats repeats) {
  ASSERT_EQ(actual.images.size(), original.images.size());
  ASSERT_EQ(actual.points.size(), original.points.size());
  std::map<std::array<double, 3>, const ModelPoint*> points;
  const auto key = [](const ModelPoint& point) {
    return std::array{point.position.x(), point.position.y(), point.position.z()};
  };
  for (const ModelPoint& point : actual.points) points[key(point)] = &point;
  const auto principal_point = [](const Camera& camera) {
    const Intrinsics intrinsics = IntrinsicsOf(camera);
    return Eigen::Vector2d(intrinsics.cx, intrinsics.cy);
  };
  for (const ModelPoint& point : original.points) {
    const auto same = points.find(key(point));
    ASSERT_NE(same, points.end()) << point.id;
    EXPECT_EQ(same->second->color, point.color);
    std::set<uint32_t> seen;
    size_t num_measurements = 0;
    for (const TrackElement& element : point.track) {
      if (!seen.insert(element.image_id).second && repeats == Repeats::kFirst) continue;
      ++num_measurements;
      const auto of_id = [&](const ModelImage& image) { return image.id == element.image_id; };
      const ModelImage& image =
          *std::find_if(original.images.begin(), original.images.end(), of_id);
      const ModelImage* imported = FindImage(actual, image.name);
      ASSERT_NE(imported, nullptr) << image.name;
      if (point.id % 10 == 0) {  // it takes long
        EXPECT_LT(
            (Project(actual, *imported, point.position) -
             principal_point(actual.CameraOf(*imported)) -
             Project(original, image, point.position) + principal_point(original.CameraOf(image)))
                .norm(),
            1e-6);
      }
      const Eigen::Vector2d measured = image.observations[element.observation].position + shift_px;
      const auto is_measured = [&](const Observation& observation) {
        return observation.point3D_id == same->second->id &&
               (observation.position - measured).norm() < 1e-3;
      };
      EXPECT_TRUE(
          std::any_of(imported->observations.begin(), imported->observations.end(), is_measured))
          << image.name << ", point " << point.id;
    }
    EXPECT_EQ(same->second->track.size(), num_measurements);
  }
}

std::string Text(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value << ' ';
  return text.str();
}

std::string Text(const Eigen::MatrixXd& matrix) {
  std::string text;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      text += Text(matrix(row, column));
    }
  }
  return text;
}

ImportTest::ImportTest() : images_(dir_ / "images") {
  fs::create_directories(images_);
  for (const std::string& name : kNames) {
    cv::imwrite((images_ / name).string(), cv::Mat(480, 640, CV_8UC1, cv::Scalar(0)));
  }
}

SparseModel ImportTest::Import(const std::string& format, const fs::path& path) {
  Arguments arguments;
  arguments.pixel_centers = FindImportFormat(format)->pixel_centers;
  return Import(format, path, arguments);
}

SparseModel ImportTest::Import(const std::string& format, const fs::path& path,
                               const Arguments& arguments) {
  ImageFolder images(images_, arguments.skip_missing);
  ImportedScene scene =
      FindImportFormat(format)->read({path, &images, arguments.list_path, arguments.model_index});
  notes_ = scene.notes;
  SparseModelOptions options;
  options.pixel_centers = arguments.pixel_centers;
  const SparseModel model = ToSparseModel(std::move(scene), options);
  const TempDir output;
  WriteNewModel(model, output / "bin", ModelFlavor::kBinary);
  WriteNewModel(model, output / "txt", ModelFlavor::kText);
  SparseModel read = ReadModel(output / "bin");
  ExpectSameModel(ReadModel(output / "txt"), read);
  warnings_ = read.warnings;
  return read;
}

std::string ImportTest::Error(const std::string& format, const fs::path& path) {
  return Error(format, path, Arguments());
}

std::string ImportTest::Error(const std::string& format, const fs::path& path,
                              const Arguments& arguments) {
  return ErrorText<IoError>([&] { Import(format, path, arguments); });
}

}  // namespace limn::colmap_ext
