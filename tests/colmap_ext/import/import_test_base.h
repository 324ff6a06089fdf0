// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/import/formats.h"
#include "colmap_ext/import/imported_scene.h"
#include "colmap_ext/temp_dir.h"

namespace limn::colmap_ext {

// Three images of 640 x 480, PINHOLE with unequal focal lengths and the principal point off the
// center, that see the cube [-1, 1]^3 from different sides: img_1.png, img_2.png, img_10.png. In
// COLMAP's pixels, without points.
SparseModel KnownModel();

// The same poses; SIMPLE_PINHOLE with the principal point at the center, or RADIAL if k1 or k2 is
// not zero. With points in the cube, measured exactly by the images (the last point by two only).
SparseModel CenteredModel(double k1 = 0, double k2 = 0);

// Points of the cube, for comparing projections.
std::vector<Eigen::Vector3d> CubePoints();

// Where an image of a model shows a point, COLMAP's pixels.
Eigen::Vector2d Project(const SparseModel& model, const ModelImage& image,
                        const Eigen::Vector3d& point);

// The same image names, and CubePoints() in the same pixels.
void ExpectSameProjections(const SparseModel& actual, const SparseModel& expected,
                           double tolerance_px = 1e-6);

// The same points (in this order), each with the same measurements.
void ExpectSamePoints(const SparseModel& actual, const SparseModel& expected);

// Whether an export keeps all measurements of a point by one image, or the first.
enum class Repeats { kAll, kFirst };

// A model that went through an export of COLMAP's which drops the principal point: the same poses,
// points and focal lengths, and measurements that are moved by `shift_px` and have six digits.
void ExpectSameAfterExport(const SparseModel& actual, const SparseModel& original,
                           const Eigen::Vector2d& shift_px, Repeats repeats);

// The number with enough digits to read back the same.
std::string Text(double value);
// The elements row by row.
std::string Text(const Eigen::MatrixXd& matrix);

// A folder with the images of KnownModel(), and files of cameras.
class ImportTest : public ::testing::Test {
 protected:
  ImportTest();

  struct Arguments {
    PixelCenters pixel_centers = PixelCenters::kHalf;
    std::string list_path;
    int model_index = -1;
    bool skip_missing = false;
  };

  // Read with the format's own pixel centers.
  SparseModel Import(const std::string& format, const std::filesystem::path& path);
  // Read, make a model, write it as binary and as text, and read both again; they are the same.
  // The warnings of reading go to warnings_.
  SparseModel Import(const std::string& format, const std::filesystem::path& path,
                     const Arguments& arguments);
  // The text of the IoError that reading throws.
  std::string Error(const std::string& format, const std::filesystem::path& path);
  std::string Error(const std::string& format, const std::filesystem::path& path,
                    const Arguments& arguments);

  TempDir dir_;
  std::filesystem::path images_;
  std::vector<std::string> notes_;     // of the last scene
  std::vector<std::string> warnings_;  // of the last model
};

}  // namespace limn::colmap_ext
