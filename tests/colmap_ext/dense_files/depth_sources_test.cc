// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/depth_sources.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/dense_files/depth_map.h"
#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"
#include "support/synthetic_scene.h"

namespace limn::colmap_ext {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// 640 x 480 px.
std::vector<View> OneView() {
  std::vector<View> views = limn::testing::DomeViews(1, 5);
  views[0].name = "sub/a.jpg";
  return views;
}

FloatMap ConstantMap(int width, int height, std::vector<float> values) {
  FloatMap map = {width, height, static_cast<int>(values.size()), {}};
  for (const float value : values) map.data.insert(map.data.end(), width * height, value);
  return map;
}

class DepthSources : public ::testing::Test {
 protected:
  void Write(const std::string& name, const FloatMap& map) const {
    std::filesystem::create_directories((dir_ / name).parent_path());
    WriteFloatMap(map, dir_ / name);
  }
  std::optional<DepthImage> Read() const {
    static const std::vector<View> views = OneView();
    return DepthMapSource(dir_.path(), views)(0);
  }

  TempDir dir_;
};

TEST_F(DepthSources, GeometricMapsComeFirstAndNormalsAreInTheWorld) {
  EXPECT_FALSE(Read());
  Write("depth_maps/sub/a.jpg.photometric.bin", ConstantMap(160, 120, {4}));
  ASSERT_TRUE(Read());
  EXPECT_EQ(Read()->At(3, 3), 4);
  FloatMap map = ConstantMap(160, 120, {5});
  map.data[1] = -1;
  map.data[2] = std::numeric_limits<float>::quiet_NaN();
  Write("depth_maps/sub/a.jpg.geometric.bin", map);
  Write("normal_maps/sub/a.jpg.geometric.bin", ConstantMap(160, 120, {0, 0, -1}));
  const auto image = Read();
  EXPECT_EQ(image->At(0, 0), 5);
  EXPECT_EQ(image->At(1, 0), 0);
  EXPECT_EQ(image->At(2, 0), 0);
  // COLMAP's pixel (1, 1) of a map of a quarter of the size is at (4, 4) of the image, half a pixel
  // less in our convention.
  EXPECT_EQ(image->PixelOf(1, 1), Eigen::Vector2d(3.5, 3.5));
  const auto normal = NormalAt(OneView()[0], *image, 10, 10);
  ASSERT_TRUE(normal);
  const Eigen::Vector3d backwards =
      OneView()[0].cam_from_world.rotation.conjugate() * Eigen::Vector3d(0, 0, -1);
  EXPECT_LT((*normal - backwards).norm(), 1e-6);
}

TEST_F(DepthSources, MapsOfAnotherShapeAreRefused) {
  Write("depth_maps/sub/a.jpg.geometric.bin", ConstantMap(160, 100, {5}));
  EXPECT_THAT(ErrorText<IoError>([&] { Read(); }),
              HasSubstr("160 x 100 pixels, which is not the shape of its image, 640 x 480"));
  Write("depth_maps/sub/a.jpg.geometric.bin", ConstantMap(160, 120, {1, 2, 3}));
  EXPECT_THAT(ErrorText<IoError>([&] { Read(); }), HasSubstr("not a depth map"));
  Write("depth_maps/sub/a.jpg.geometric.bin", ConstantMap(160, 120, {5}));
  Write("normal_maps/sub/a.jpg.geometric.bin", ConstantMap(80, 60, {0, 0, -1}));
  EXPECT_THAT(ErrorText<IoError>([&] { Read(); }), HasSubstr("not the size of its depth map"));
}

TEST(DenseProducts, TheFirstOfWhatIsThere) {
  const TempDir dir;
  const auto find = [&](const std::string& type = "auto", const std::string& path = "") {
    DenseOptionsPaths options;
    options.dense_type = type;
    options.dense_path = path;
    return FindDenseProducts(options, dir.path(), dir / "dense");
  };
  EXPECT_THAT(ErrorText<IoError>([&] { find(); }), HasSubstr("no dense results found"));
  dir.WriteFile("dense/meshed-poisson.ply", "");
  EXPECT_EQ(find().kind, DenseKind::kMesh);
  dir.WriteFile("pmvs/models/option-all.ply", "");
  EXPECT_EQ(find().path, dir / "pmvs" / "models" / "option-all.ply");
  dir.WriteFile("pmvs/models/option-0001.ply", "");
  dir.WriteFile("pmvs/models/option-0000.ply", "");
  EXPECT_THAT(find().clouds, ElementsAre(dir / "pmvs" / "models" / "option-0000.ply",
                                         dir / "pmvs" / "models" / "option-0001.ply"));
  dir.WriteFile("pmvs/models/option-all.patch", "");
  EXPECT_EQ(find().path, dir / "pmvs" / "models" / "option-all.patch");
  dir.WriteFile("dense/fused.ply", "");
  EXPECT_EQ(find().kind, DenseKind::kFusedCloud);
  dir.WriteFile("dense/stereo/depth_maps/a.jpg.geometric.bin", "");
  const DenseProducts all = find();
  EXPECT_EQ(all.kind, DenseKind::kDepthMaps);
  EXPECT_EQ(all.path, dir / "dense" / "stereo");
  EXPECT_THAT(all.clouds, ElementsAre(dir / "dense" / "fused.ply"));
  EXPECT_EQ(find("pmvs").kind, DenseKind::kPmvs);
  const std::string cloud = dir.WriteFile("elsewhere/scan.ply", "");
  EXPECT_EQ(find("fused", cloud).path, cloud);
  EXPECT_EQ(find("mesh", cloud).kind, DenseKind::kMesh);
  EXPECT_THAT(ErrorText<OptionError>([&] { find("laser"); }), HasSubstr("dense_type = laser"));
  EXPECT_THAT(ErrorText<IoError>([&] { find("depth_maps", (dir / "elsewhere").string()); }),
              HasSubstr("looked for depth_maps"));
}

}  // namespace
}  // namespace limn::colmap_ext
