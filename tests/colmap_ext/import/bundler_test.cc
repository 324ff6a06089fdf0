// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/bundler.h"

#include "colmap_ext/import/import_test_base.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/workspace/model_folder.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr char kBundlerFormat[] = "bundler";

// The model as a Bundler file: origin at the image center, y up, camera along -z.
std::string Cameras(const SparseModel& model) {
  std::string text;
  for (const ModelImage& image : model.images) {
    const std::vector<double>& params = model.CameraOf(image).params;
    const Eigen::DiagonalMatrix<double, 3> turn(1, -1, -1);
    text += Text(params[0]) + (params.size() == 5 ? Text(params[3]) + Text(params[4]) : "0 0");
    text += "\n" + Text(turn * image.cam_from_world.rotation.toRotationMatrix()) + "\n" +
            Text(turn * image.cam_from_world.translation) + "\n";
  }
  return text;
}

std::string Points(const SparseModel& model) {
  std::string text;
  for (const ModelPoint& point : model.points) {
    text += Text(point.position) + "\n";
    for (const uint8_t channel : point.color) text += std::to_string(channel) + " ";
    text += "\n" + std::to_string(point.track.size());
    for (const TrackElement& element : point.track) {
      const ModelImage& image = model.images[element.image_id - 1];
      const Eigen::Vector2d pixel = image.observations[element.observation].position;
      text += " " + std::to_string(element.image_id - 1) + " 77 " + Text(pixel.x() - 320) +
              Text(240 - pixel.y());
    }
    text += "\n";
  }
  return text;
}

class Bundler : public ImportTest {
 protected:
  Bundler() { dir_.WriteFile("list.txt", "./img_1.png\nimg_2.png 0 600.25\nimg_10.png\n"); }

  std::string Write(const std::string& counts, const std::string& rest) {
    return dir_.WriteFile("bundle/bundle.out", "# Bundle file v0.3\n" + counts + "\n" + rest);
  }
  std::string ErrorWith(const std::string& counts, const std::string& rest) {
    return Error(kBundlerFormat, Write(counts, rest));
  }
};

TEST_F(Bundler, GivesTheSameProjectionsAndPoints) {
  const SparseModel known = CenteredModel();
  Write("3 3", Cameras(known) + Points(known));
  const SparseModel model = Import(kBundlerFormat, dir_ / "bundle");
  ExpectSameProjections(model, known);
  EXPECT_THAT(warnings_, IsEmpty());
  ExpectSamePoints(model, known);
  ASSERT_EQ(model.cameras.size(), 1u);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kSimplePinhole);
}

TEST_F(Bundler, KeepsItsDistortion) {
  const SparseModel known = CenteredModel(-0.11, 0.02);
  const std::string path = Write("3 3", Cameras(known) + Points(known));
  const SparseModel model = Import(kBundlerFormat, path);
  ExpectSameProjections(model, known);
  ExpectSamePoints(model, known);
  EXPECT_EQ(model.cameras[0].model, CameraModelId::kRadial);
}

TEST_F(Bundler, LeavesOutImagesThatWereNotReconstructed) {
  SparseModel known = CenteredModel();
  std::string cameras = Cameras(known);
  dir_.WriteFile("list.txt", "img_1.png\nimg_2.png\nimg_10.png\nnever_found.png\n");
  const std::string path =
      Write("4 3", cameras + "0 0 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n" + Points(known));
  const SparseModel model = Import(kBundlerFormat, path);
  ExpectSameProjections(model, known);
  EXPECT_THAT(notes_, Contains("1 of 4 images were not reconstructed and are left out"));
}

TEST_F(Bundler, LeavesOutMissingImagesIfAsked) {
  const SparseModel known = CenteredModel();
  const std::string path = Write("3 3", Cameras(known) + Points(known));
  fs::remove(images_ / "img_1.png");
  EXPECT_THAT(Error(kBundlerFormat, path),
              HasSubstr("bundle.out: line 3: image \"./img_1.png\" is not in the image folder"));
  Arguments arguments;
  arguments.skip_missing = true;
  const SparseModel model = Import(kBundlerFormat, path, arguments);
  ASSERT_EQ(model.images.size(), 2u);
  EXPECT_EQ(model.images[0].name, "img_2.png");
  ASSERT_EQ(model.points.size(), 3u);
  EXPECT_EQ(model.points[0].track.size(), 2u);
  EXPECT_EQ(model.points[2].track.size(), 1u);
}

TEST_F(Bundler, BadFilesAreRefused) {
  const SparseModel known = CenteredModel();
  const std::string cameras = Cameras(known);
  EXPECT_THAT(
      Error(kBundlerFormat, dir_.WriteFile("bundle/bundle.out", "# Bundle file v0.4\n3 0\n")),
      HasSubstr("bundle.out: line 1: \"# Bundle file v0.3\" expected"));
  EXPECT_THAT(ErrorWith("2 0", cameras), HasSubstr("line 2: 2 cameras, but "));
  EXPECT_THAT(ErrorWith("3 4", cameras + Points(known)), HasSubstr("the file ends before"));
  EXPECT_THAT(ErrorWith("3 2", cameras + Points(known)),
              HasSubstr("more than the 2 points that were announced"));
  EXPECT_THAT(ErrorWith("3 0", cameras.substr(0, cameras.size() / 2)),
              HasSubstr("the file ends before"));
  EXPECT_THAT(ErrorWith("3 1", cameras + "nan 0 0\n0 0 0\n0\n"), HasSubstr("line 12: coordinate"));
  EXPECT_THAT(ErrorWith("3 1", cameras + "0 0 0\n0 0 0\n1 3 0 1 1\n"),
              HasSubstr("line 14: camera index 3, but there are only 3 cameras"));
  EXPECT_THAT(ErrorWith("3 1", cameras + "0 0 0\n0 0 256\n0\n"), HasSubstr("line 13: color"));
  EXPECT_THAT(ErrorWith("3 1", cameras + "0 0 0\n0 0 0\n1 0 0 inf 1\n"),
              HasSubstr("line 14: x of a measurement is not finite"));
  EXPECT_THAT(ErrorWith("3 0", "600 0 0\n1 0 0\n0 1 0\n0 0 0\n0 0 0\n" + cameras),
              HasSubstr("line 3: the rotation matrix is none"));
  EXPECT_THAT(ErrorWith("3 0", "-600 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 0\n" +
                                   cameras.substr(0, cameras.size() / 3 * 2)),
              HasSubstr("bundle.out: line 3: "));
  fs::remove(dir_ / "list.txt");
  EXPECT_THAT(ErrorWith("3 3", cameras), HasSubstr("the list of its images is not beside it"));
}

TEST_F(Bundler, ReadsWhatColmapWrites) {
  if (!HaveColmap()) GTEST_SKIP() << "the colmap program is not installed";
  const fs::path day = fs::path(LIMN_SAMPLE_DIR) / "day";
  ASSERT_TRUE(RunColmap("model_converter --output_type Bundler --input_path '" +
                            (day / "sparse").string() + "' --output_path '" +
                            (dir_ / "day").string() + "'",
                        dir_ / "log"));
  images_ = day / "images";
  const SparseModel model = Import(kBundlerFormat, dir_ / "day.bundle.out");
  // It is (316, 244), the center (320, 240).
  ExpectSameAfterExport(model, ReadModel(day / "sparse"), {4, -4}, Repeats::kAll);
}

}  // namespace
}  // namespace limn::colmap_ext
