// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/dense_cloud.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/dense_files/patch_file.h"
#include "colmap_ext/dense_files/pmvs_with_curves.h"
#include "colmap_ext/temp_dir.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Three views of a model of four images, in another order than the model's.
std::vector<View> ThreeViews() {
  std::vector<View> views = limn::testing::DomeViews(3, 5);
  const int model_index[] = {2, 0, 3};
  const char* names[] = {"a.jpg", "b c.jpg", "d.jpg"};
  for (int v = 0; v < 3; ++v) {
    views[v].model_index = model_index[v];
    views[v].name = names[v];
  }
  return views;
}

template <typename T>
void Append(T value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof(T));
}

std::string Visibility(const std::vector<std::vector<uint32_t>>& lists) {
  std::string bytes;
  Append<uint64_t>(lists.size(), &bytes);
  for (const auto& list : lists) {
    Append<uint32_t>(static_cast<uint32_t>(list.size()), &bytes);
    for (const uint32_t image : list) Append(image, &bytes);
  }
  return bytes;
}

constexpr char kCloud[] =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
    "1 2 3 0 0 2 10 20 30\n4 5 6 1 0 0 40 50 60\n";

std::vector<DensePoint> ReadAll(const DenseCloud& cloud) {
  std::vector<DensePoint> points;
  cloud.points([&](const DensePoint& point) { points.push_back(point); });
  return points;
}

TEST(DenseCloud, PointsAndTheViewsThatSeeThem) {
  const TempDir dir;
  const std::string path = dir.WriteFile("fused.ply", kCloud);
  dir.WriteFile("fused.ply.vis", Visibility({{3, 0}, {1}}));
  const DenseCloud cloud = OpenPlyCloud(path, ThreeViews(), 4);
  EXPECT_EQ(cloud.num_points, 2u);
  EXPECT_TRUE(cloud.has_normals);
  EXPECT_TRUE(cloud.has_visibility);
  for (int time = 0; time < 2; ++time) {  // it can be read again
    const std::vector<DensePoint> points = ReadAll(cloud);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].position, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(points[0].normal, Eigen::Vector3d(0, 0, 1));
    EXPECT_THAT(points[1].color, ElementsAre(40, 50, 60));
    EXPECT_THAT(points[0].views, ElementsAre(1, 2));
    EXPECT_THAT(points[1].views, IsEmpty());  // image 1 is not among the views
  }
}

TEST(DenseCloud, DamagedVisibilityIsTold) {
  const TempDir dir;
  const std::string path = dir.WriteFile("fused.ply", kCloud);
  const auto error_with = [&](const std::string& visibility) {
    dir.WriteFile("fused.ply.vis", visibility);
    return ErrorText<IoError>([&] { ReadAll(OpenPlyCloud(path, ThreeViews(), 4)); });
  };
  EXPECT_THAT(error_with(Visibility({{0}})), HasSubstr("1 points, but the cloud has 2"));
  EXPECT_THAT(error_with(Visibility({{4}, {0}})), HasSubstr("image 4, but the model has 4"));
  EXPECT_THAT(error_with(Visibility({{0}, {0, 3}}).substr(0, 20)), HasSubstr("fused.ply.vis"));
  EXPECT_THAT(error_with(""), HasSubstr("fused.ply.vis"));
  EXPECT_THAT(error_with(Visibility({{0}, {0}}) + "more"),
              HasSubstr("byte 24: 4 bytes after the last record"));
}

TEST(DenseCloud, VisibilityIsNoFolder) {
  const TempDir dir;
  const std::string path = dir.WriteFile("fused.ply", kCloud);
  std::filesystem::create_directory(dir / "fused.ply.vis");
  EXPECT_THAT(ErrorText<IoError>([&] { ReadAll(OpenPlyCloud(path, ThreeViews(), 4)); }),
              HasSubstr("fused.ply.vis: is a folder, not a file"));
}

TEST(DenseCloud, DamagedCloudIsTold) {
  const TempDir dir;
  const auto error_of = [&](const std::string& content) {
    const std::string path = dir.WriteFile("x.ply", content);
    return ErrorText<IoError>([&] { ReadAll(OpenPlyCloud(path, ThreeViews(), 4)); });
  };
  const std::string whole = kCloud;
  EXPECT_THAT(error_of(whole.substr(0, whole.size() - 22)), HasSubstr("line 15: the file ends"));
  EXPECT_THAT(error_of(whole.substr(0, whole.size() - 4)), HasSubstr("line 15: too few numbers"));
  std::string bad = whole;
  bad.replace(bad.find("1 2 3"), 5, "1 x 3");
  EXPECT_THAT(error_of(bad), HasSubstr("line 14: \"x\" is not a number"));
  EXPECT_THAT(error_of("ply\nformat ascii 1.0\nelement face 1\nend_header\n"),
              HasSubstr("the first element is not vertex"));
}

TEST(DenseCloud, OddPointsAreLeftOutAndCounted) {
  const TempDir dir;
  std::string bytes = kCloud;
  bytes.replace(bytes.find("vertex 2"), 8, "vertex 6");
  bytes += "nan 2 3 0 0 1 1 1 1\n1 2 3 0 nan 1 1 1 1\n1e33 2 3 0 0 1 1 1 1\n7 8 9 0 0 1 1 1 1\n";
  const std::string path = dir.WriteFile("fused.ply", bytes);
  dir.WriteFile("fused.ply.vis", Visibility({{3, 0}, {1}, {}, {2}, {0, 2}, {0}}));
  const DenseCloud cloud = OpenClouds({path}, ThreeViews(), 4);
  for (int time = 0; time < 2; ++time) {
    const std::vector<DensePoint> points = ReadAll(cloud);
    ASSERT_EQ(points.size(), 3u);
    EXPECT_EQ(points[2].position, Eigen::Vector3d(7, 8, 9));
    EXPECT_THAT(points[2].views, ElementsAre(1));  // those of its own line
    EXPECT_THAT(cloud.NoteOnOdd(), HasSubstr("3 of 6 points of the cloud are left out"));
  }
  EXPECT_THAT(ErrorText<IoError>([&] { ReadPlyPoints(path, [](const PlyPoint&) {}); }),
              HasSubstr("line 16: number not finite"));
}

TEST(PlyPoints, ColorsOfAnyType) {
  const TempDir dir;
  const auto color_of = [&](const std::string& line) {
    const std::string path = dir.WriteFile(
        "x.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nproperty float red\nproperty float green\nproperty float blue\n"
        "end_header\n" +
            line);
    PlyPoint read;
    ReadPlyPoints(path, [&](const PlyPoint& point) { read = point; });
    return read.color;
  };
  EXPECT_THAT(color_of("1 2 3 -1 inf 7.9\n"), ElementsAre(0, 255, 7));
  EXPECT_THAT(ErrorText<IoError>([&] { color_of("1 2 3 1 nan 3\n"); }),
              HasSubstr("line 11: color is not a number"));
}

TEST(PlyPoints, BinaryOfBothByteOrders) {
  const TempDir dir;
  for (const bool big : {false, true}) {
    std::string bytes = "ply\nformat binary_";
    bytes += big ? "big" : "little";
    bytes +=
        "_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\nproperty short z\n"
        "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n"
        "end_header\n";
    const auto put = [&](auto value) {
      std::string raw(reinterpret_cast<const char*>(&value), sizeof(value));
      if (big) std::reverse(raw.begin(), raw.end());
      bytes += raw;
    };
    for (int k = 0; k < 3; ++k) {
      put(0.1 * k);
      put(0.5f * k);
      put(static_cast<int16_t>(-300 * k));
      for (int c = 0; c < 3; ++c) put(static_cast<uint8_t>(100 + c));
    }
    const std::string path = dir.WriteFile("cloud.ply", bytes);
    EXPECT_FALSE(ReadPlyPointsInfo(path).has_normals);
    int k = 0;
    ReadPlyPoints(path, [&](const PlyPoint& point) {
      EXPECT_EQ(point.position, Eigen::Vector3d(0.1 * k, 0.5 * k, -300 * k));
      EXPECT_THAT(point.color, ElementsAre(100, 101, 102));
      ++k;
    });
    EXPECT_EQ(k, 3);
    const std::string cut = dir.WriteFile("cut.ply", bytes.substr(0, bytes.size() - 1));
    EXPECT_THAT(ErrorText<IoError>([&] { ReadPlyPoints(cut, [](const PlyPoint&) {}); }),
                HasSubstr("vertex 2: the file ends too early"));
  }
}

std::string PatchText(const std::vector<Patch>& patches) {
  std::ostringstream out;
  WritePatchHeader(patches.size(), out);
  for (const Patch& patch : patches) WritePatch(patch, out);
  return out.str();
}

Patch MakePatch() {
  Patch patch;
  patch.position = {0.1, -2, 1e-7};
  patch.normal = {0, 0.6, 0.8};
  patch.photometric_score = 0.75;
  patch.images = {2, 0};
  patch.more_images = {3};
  return patch;
}

TEST(PatchFile, ComesBackAsWritten) {
  const TempDir dir;
  Patch second = MakePatch();
  second.more_images.clear();
  const std::string path = dir.WriteFile("x.patch", PatchText({MakePatch(), second}));
  std::vector<Patch> patches;
  ReadPatchFile(path, [&](const Patch& patch) { patches.push_back(patch); });
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_EQ(patches[0].position, MakePatch().position);
  EXPECT_EQ(patches[0].normal, MakePatch().normal);
  EXPECT_EQ(patches[0].photometric_score, 0.75);
  EXPECT_THAT(patches[0].images, ElementsAre(2, 0));
  EXPECT_THAT(patches[0].more_images, ElementsAre(3));
  EXPECT_THAT(patches[1].more_images, IsEmpty());
}

TEST(PatchFile, ImagesAreFoundByTheListOfNames) {
  const TempDir dir;
  dir.WriteFile("bundle.rd.out.list.txt", "b c.jpg\nx.jpg\na.jpg\ny.jpg\n");
  const std::string path = dir.WriteFile("models/option.patch", PatchText({MakePatch()}));
  // Numbers 2 and 0 are "a.jpg" and "b c.jpg": views 0 and 1.
  EXPECT_THAT(ReadAll(OpenClouds({path}, ThreeViews(), 4))[0].views, ElementsAre(0, 1));
  std::filesystem::remove(dir / "bundle.rd.out.list.txt");
  // The model's order: image 2 is view 0, image 0 is view 1.
  EXPECT_THAT(ReadAll(OpenClouds({path}, ThreeViews(), 4))[0].views, ElementsAre(0, 1));
}

TEST(PatchFile, ClustersAreOneCloudWithTheColorsBesideThem) {
  const TempDir dir;
  const std::string first =
      dir.WriteFile("models/option-0000.patch", PatchText({MakePatch(), MakePatch()}));
  const std::string second = dir.WriteFile("models/option-0001.patch", PatchText({MakePatch()}));
  dir.WriteFile("models/option-0000.ply", kCloud);
  const DenseCloud cloud = OpenClouds({first, second}, ThreeViews(), 4);
  EXPECT_EQ(cloud.num_points, 3u);
  const std::vector<DensePoint> points = ReadAll(cloud);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_THAT(points[0].color, ElementsAre(10, 20, 30));
  EXPECT_THAT(points[1].color, ElementsAre(40, 50, 60));
  EXPECT_THAT(points[2].color, ElementsAre(128, 128, 128));
  const std::string merged = (dir / "pmvs-with-curves").string();
  WritePmvsWithCurves(merged, {first, second}, cloud, {}, ThreeViews());
  uint64_t count = 0;
  ReadPatchFile(merged + ".patch", [&](const Patch&) { ++count; });
  EXPECT_EQ(count, 3u);
  EXPECT_EQ(ReadPlyPointsInfo(merged + ".ply").count, 3u);
}

// As PMVS writes them; a point that is no place is left out.
constexpr const char* kPmvsPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
    "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n"
    "property float quality\nend_header\n"
    "1 2 3 0 0 1 10 20 30 0.75\nnan 2 3 0 0 1 10 20 30 0.5\n4 5 6 0 1 0 40 50 60 0.25\n";

TEST(PmvsWithCurves, KeepsPmvsAttributesAndColorsThatOthersRead) {
  const TempDir dir;
  const std::string path = dir.WriteFile("models/option-all.ply", kPmvsPly);
  const DenseCloud cloud = OpenClouds({path}, ThreeViews(), 4);
  CurvePoint of_curve;
  of_curve.position = {7, 8, 9};
  of_curve.color = {70, 80, 90};
  of_curve.views = {0};
  const std::string merged = (dir / "pmvs-with-curves").string();
  WritePmvsWithCurves(merged, {path}, cloud, {of_curve}, ThreeViews());
  std::vector<PlyPoint> points;
  ReadPlyPoints(merged + ".ply", [&](const PlyPoint& point) { points.push_back(point); });
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[1].position, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(points[1].normal, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(points[1].quality, 0.25);
  EXPECT_THAT(points[1].color, ElementsAre(40, 50, 60));
  EXPECT_EQ(points[2].quality, 1);
  std::ifstream in(merged + ".ply");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  for (const char* name : {"uchar red\n", "uchar diffuse_red\n", "float quality\n"}) {
    EXPECT_THAT(text, HasSubstr(name));
  }
}

TEST(PatchFile, ImagesBeyondTheListAreTold) {
  const TempDir dir;
  const std::string path =
      dir.WriteFile("models/option.patch", PatchText({MakePatch()}));  // images 2, 0 and 3
  const auto error = [&](size_t num_model_images) {
    return ErrorText<IoError>([&] { OpenClouds({path}, ThreeViews(), num_model_images); });
  };
  EXPECT_THAT(error(4), IsEmpty());
  EXPECT_THAT(error(3), HasSubstr("option.patch: patch 0: image 3, but there are only 3"));
  dir.WriteFile("bundle.rd.out.list.txt", "b c.jpg\nx.jpg\n");
  EXPECT_THAT(error(4), HasSubstr("patch 0: image 2, but there are only 2"));
}

TEST(DenseCloud, CloudsWithoutPointsAreRefused) {
  const TempDir dir;
  const std::string path = dir.WriteFile("models/option.patch", PatchText({}));
  EXPECT_THAT(ErrorText<IoError>([&] { OpenClouds({path}, ThreeViews(), 4); }),
              HasSubstr("option.patch: no points"));
}

TEST(PatchFile, DamageIsTold) {
  const TempDir dir;
  const auto error_of = [&](const std::string& content) {
    const std::string path = dir.WriteFile("x.patch", content);
    return ErrorText<IoError>([&] { ReadPatchFile(path, [](const Patch&) {}); });
  };
  const std::string whole = PatchText({MakePatch()});
  EXPECT_THAT(error_of("POINTS\n"), HasSubstr("line 1: not a .patch file"));
  EXPECT_THAT(error_of("PATCHES\n2\n" + whole.substr(whole.find("PATCHS"))),
              HasSubstr("the file ends before a patch"));
  std::string bad = whole;
  bad.replace(bad.find("0.75"), 4, "nan ");
  EXPECT_THAT(error_of(bad), HasSubstr("score is not finite"));
  bad = whole;
  bad.replace(bad.find("\n2\n2 0"), 3, "\n-2\n");
  EXPECT_THAT(error_of(bad), HasSubstr("number of images"));
  bad = whole;
  bad.replace(bad.find("\n2 0"), 4, "\n2 -1");
  EXPECT_THAT(error_of(bad), HasSubstr("line 8: negative image number"));
}

}  // namespace
}  // namespace limn::colmap_ext
