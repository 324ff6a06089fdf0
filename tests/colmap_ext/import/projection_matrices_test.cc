// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/projection_matrices.h"

#include "colmap_ext/import/import_test_base.h"
#include "colmap_ext/workspace/model_folder.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr char kProjectionMatricesFormat[] = "projection_matrices";

// In the pixels of the format: the principal point moves by `shift`.
Eigen::Matrix<double, 3, 4> ProjectionOf(const SparseModel& model, const ModelImage& image,
                                         double shift) {
  const Intrinsics camera = IntrinsicsOf(model.CameraOf(image));
  Eigen::Matrix3d k;
  k << camera.fx, 0, camera.cx + shift, 0, camera.fy, camera.cy + shift, 0, 0, 1;
  Eigen::Matrix<double, 3, 4> pose;
  pose << image.cam_from_world.rotation.toRotationMatrix(), image.cam_from_world.translation;
  return k * pose;
}

class ProjectionMatrices : public ImportTest {
 protected:
  // One file per image: its name with `extension` instead of its own.
  void WriteMatrices(const std::string& extension, const std::string& header = "", double scale = 1,
                     double shift = -0.5) {
    for (const ModelImage& image : known_.images) {
      const std::string name = fs::path(image.name).stem().string() + extension;
      dir_.WriteFile("cameras/" + name, header + Text(scale * ProjectionOf(known_, image, shift)));
    }
  }

  const SparseModel known_ = KnownModel();
  const fs::path cameras_ = dir_ / "cameras";
};

TEST_F(ProjectionMatrices, GiveTheSameProjections) {
  WriteMatrices(".projmatrix");
  const SparseModel model = Import(kProjectionMatricesFormat, cameras_);
  ExpectSameProjections(model, known_);
  EXPECT_EQ(model.cameras.size(), 1u);  // shared
  EXPECT_TRUE(model.points.empty());
  EXPECT_THAT(notes_, ElementsAre("3 of 3 camera files matched to images by name"));
}

TEST_F(ProjectionMatrices, MayHaveTheirPixelCentersAtHalf) {
  WriteMatrices(".projmatrix", "", 1, 0);
  Arguments arguments;
  arguments.pixel_centers = PixelCenters::kHalf;
  ExpectSameProjections(Import(kProjectionMatricesFormat, cameras_, arguments), known_);
}

TEST_F(ProjectionMatrices, OfAnyScaleAreTheSameCamera) {
  for (const double scale : {-1.0, 1e-4, -3e5}) {
    WriteMatrices(".projmatrix", "", scale);
    ExpectSameProjections(Import(kProjectionMatricesFormat, cameras_), known_);
  }
}

TEST_F(ProjectionMatrices, MayHaveTheHeaderOfPmvs) {
  WriteMatrices(".txt", "CONTOUR\n");
  ExpectSameProjections(Import(kProjectionMatricesFormat, cameras_), known_);
  EXPECT_TRUE(HoldsProjectionMatrices(cameras_));
}

TEST_F(ProjectionMatrices, AreMatchedByTheLastNumber) {
  for (const ModelImage& image : known_.images) {
    const std::string number = fs::path(image.name).stem().string().substr(4);
    dir_.WriteFile("cameras/00" + number + ".projmatrix", Text(ProjectionOf(known_, image, -0.5)));
  }
  ExpectSameProjections(Import(kProjectionMatricesFormat, cameras_), known_);
  EXPECT_THAT(notes_, ElementsAre("3 of 3 camera files matched to images by number"));
}

// Natural order: a, b, c goes with 1, 2, 10.
TEST_F(ProjectionMatrices, AreMatchedByOrder) {
  const char* names[] = {"a", "b", "c"};
  for (int i = 0; i < 3; ++i) {
    dir_.WriteFile("cameras/" + std::string(names[i]) + ".projmatrix",
                   Text(ProjectionOf(known_, known_.images[i], -0.5)));
  }
  ExpectSameProjections(Import(kProjectionMatricesFormat, cameras_), known_);
  EXPECT_THAT(notes_, ElementsAre("3 camera files matched to images by order: a.projmatrix is of "
                                  "img_1.png, c.projmatrix is of img_10.png"));
}

TEST_F(ProjectionMatrices, AreMatchedByAList) {
  const int order[] = {2, 0, 1};
  std::string list;
  for (int i = 0; i < 3; ++i) {
    dir_.WriteFile("cameras/0000000" + std::to_string(i) + ".txt",
                   "CONTOUR\n" + Text(ProjectionOf(known_, known_.images[order[i]], -0.5)));
    list += known_.images[order[i]].name + "\n";
  }
  Arguments arguments;
  arguments.pixel_centers = PixelCenters::kInteger;
  arguments.list_path = dir_.WriteFile("list.txt", list);
  ExpectSameProjections(Import(kProjectionMatricesFormat, cameras_, arguments), known_);

  arguments.list_path = dir_.WriteFile("short.txt", "img_1.png\n");
  EXPECT_THAT(Error(kProjectionMatricesFormat, cameras_, arguments),
              HasSubstr("short.txt: 1 images listed, but there are 3 camera files"));
}

TEST_F(ProjectionMatrices, NeedTheirImages) {
  WriteMatrices(".projmatrix");
  fs::remove(images_ / "img_2.png");
  EXPECT_THAT(Error(kProjectionMatricesFormat, cameras_),
              AllOf(HasSubstr("img_2.projmatrix"), HasSubstr("no image in")));
  Arguments arguments;
  arguments.pixel_centers = PixelCenters::kInteger;
  arguments.skip_missing = true;
  SparseModel expected = known_;
  expected.images.erase(expected.images.begin() + 1);
  ExpectSameProjections(Import(kProjectionMatricesFormat, cameras_, arguments), expected);
}

TEST_F(ProjectionMatrices, ThatFitNoImageAreRefused) {
  dir_.WriteFile("cameras/x.projmatrix", Text(ProjectionOf(known_, known_.images[0], 0)));
  EXPECT_THAT(Error(kProjectionMatricesFormat, cameras_),
              HasSubstr("there are 3 images but 1 camera files"));
}

TEST_F(ProjectionMatrices, ImagesThatCannotBeToldApartAreRefused) {
  WriteMatrices("_P.txt");
  for (const char* name : {"img_1.png", "img_2.png", "img_10.png"}) {
    fs::copy(images_ / name, images_ / ("other_" + std::string(name)));
  }
  EXPECT_THAT(Error(kProjectionMatricesFormat, cameras_),
              HasSubstr("img_1_P.txt: two images fit by number: img_1.png and other_img_1.png"));
}

TEST_F(ProjectionMatrices, BadOnesAreRefused) {
  WriteMatrices(".projmatrix");
  const auto error_with = [&](const std::string& text) {
    dir_.WriteFile("cameras/img_2.projmatrix", text);
    return Error(kProjectionMatricesFormat, cameras_);
  };
  EXPECT_THAT(error_with("1 2 3\n4 5 6\n7 8"),
              HasSubstr("img_2.projmatrix: line 3: the file ends before element of a 3x4 matrix"));
  EXPECT_THAT(error_with("1 0 0 0\n0 1 0 0\n0 0 1 0\n5\n"),
              HasSubstr("img_2.projmatrix: line 4: more than the twelve numbers"));
  EXPECT_THAT(error_with("1 0 0 0\n0 nan 0 0\n0 0 1 0\n"),
              HasSubstr("img_2.projmatrix: line 2: element of a 3x4 matrix is not finite"));
  EXPECT_THAT(error_with("CONTOUR2\n1 0 0 0\n"), HasSubstr("\"CONTOUR2\" found"));
  EXPECT_THAT(error_with("1 2 3 4\n2 4 6 1\n0 0 1 0\n"), HasSubstr("singular"));
  EXPECT_THAT(error_with("600 0 320 0\n0 600 240 0\n0 0 0 1\n"), HasSubstr("singular"));
  EXPECT_THAT(error_with("600 2 320 0\n0 600 240 0\n0 0 1 5\n"),
              HasSubstr("img_2.projmatrix: line 1: the pixels are skewed: 0.8 px"));
}

// The truth of an earlier conversion: data that may be missing.
TEST_F(ProjectionMatrices, OfColmapsUndistorterGiveItsModel) {
  const fs::path vase = fs::path(LIMN_DATA_DIR) / "vase";
  if (!fs::exists(vase / "pmvs" / "txt")) GTEST_SKIP() << vase << " is not there";
  images_ = vase / "images";
  Arguments arguments;
  arguments.list_path = (vase / "pmvs" / "bundle.rd.out.list.txt").string();
  const SparseModel model = Import(kProjectionMatricesFormat, vase / "pmvs" / "txt", arguments);
  const SparseModel expected = ReadModel(vase / "sparse" / "0");
  ASSERT_EQ(model.images.size(), expected.images.size());
  // The matrices have six digits: elements up to 3000 are right to 0.005.
  for (const ModelImage& image : model.images) {
    for (const ModelImage& other : expected.images) {
      if (other.name != image.name) continue;
      for (size_t i = 0; i < expected.points.size(); i += 50) {
        const Eigen::Vector3d& point = expected.points[i].position;
        EXPECT_LT((Project(model, image, point) - Project(expected, other, point)).norm(), 0.05);
      }
    }
  }
}

}  // namespace
}  // namespace limn::colmap_ext
