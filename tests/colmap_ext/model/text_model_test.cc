// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/line_reader.h"
#include "colmap_ext/model/model_files.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

constexpr char kCamera[] = "1 PINHOLE 640 480 500 500 320 240\n";
constexpr char kImage[] = "1 1 0 0 0 0 0 1 1 a.png\n\n";

SparseModel ReadText(const std::string& cameras, const std::string& images,
                     const std::string& points) {
  ModelBuilder builder;
  std::istringstream cameras_in(cameras), images_in(images), points_in(points);
  ReadCamerasText(cameras_in, "cameras.txt", &builder);
  ReadImagesText(images_in, "images.txt", &builder);
  ReadPointsText(points_in, "points3D.txt", &builder);
  return builder.Finish();
}

std::string ErrorOfText(const std::string& cameras, const std::string& images = "",
                        const std::string& points = "") {
  return ErrorText<IoError>([&] { ReadText(cameras, images, points); });
}

TEST(LineReader, LinesMayBeLong) {
  std::vector<std::string> lines = {"", "a"};
  for (const size_t size : {4094, 4095, 4096, 8190, 8191, 100'000}) lines.emplace_back(size, 'x');
  for (const char* end : {"", "\n"}) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    text.resize(text.size() - 1);
    std::istringstream in(text + end);
    LineReader reader(in, "a.txt");
    for (const std::string& line : lines) {
      ASSERT_TRUE(reader.NextLine());
      EXPECT_EQ(reader.line(), line);
    }
    EXPECT_FALSE(reader.NextLine());
    EXPECT_EQ(reader.Here().number, lines.size());
  }
}

TEST(LineReader, FilesWithoutLinesAreRefused) {
  const TempDir dir;
  const std::string path = dir.WriteFile("a.txt", "a line\n");
  std::filesystem::resize_file(path, uintmax_t{100} << 30);  // sparse
  std::ifstream in(path);
  LineReader reader(in, path);
  EXPECT_TRUE(reader.NextLine());
  EXPECT_THAT(ErrorText<IoError>([&] { reader.NextLine(); }),
              ::testing::HasSubstr("a.txt: line 2: is longer than 256 MB"));
}

TEST(TextModel, PanoramasThatColmapShrankAreRead) {
  const double scale = 2000 / 7680.0;
  std::ostringstream line;
  line.precision(17);
  line << "1 EQUIRECTANGULAR 2000 1000 " << 7680 * scale << ' ' << 3840 * scale << '\n';
  EXPECT_THAT(line.str(), HasSubstr("2000.00000000000"));  // not 2000
  EXPECT_EQ(ReadText(line.str(), kImage, "").images.size(), 1u);
  EXPECT_THAT(ErrorOfText("1 EQUIRECTANGULAR 2000 1000 2001 1000\n"),
              HasSubstr("must be its width and height"));
  EXPECT_THAT(ErrorOfText("1 EQUIRECTANGULAR 2000 1000 2000 1001\n"),
              HasSubstr("must be its width and height"));
}

TEST(TextModel, RoundTripsExactly) {
  SparseModel model = MakeModel();
  for (int id = 0; id < 17; ++id) {
    model.cameras.push_back(MakeCamera(static_cast<CameraModelId>(id), 100 - id));
  }
  std::ostringstream cameras, images, points;
  WriteCamerasText(model, cameras);
  WriteImagesText(model, images);
  WritePointsText(model, points);
  ExpectSameModel(ReadText(cameras.str(), images.str(), points.str()), model);
}

TEST(TextModel, RestOfTheLineIsTheName) {
  const SparseModel model = ReadText(kCamera, "1 1 0 0 0 0 0 1 1   sub dir/im  01.png  \n\n", "");
  EXPECT_EQ(model.images.at(0).name, "sub dir/im  01.png");
}

TEST(TextModel, MarksOfUtf8AreSkipped) {
  for (const char* start : {"", "# a\n"}) {
    const std::string mark = std::string("\xEF\xBB\xBF") + start;
    const SparseModel model =
        ReadText(mark + kCamera, mark + kImage, mark + "1 0 0 1 9 9 9 0.5 1 0\n");
    EXPECT_EQ(model.images.at(0).name, "a.png");
    EXPECT_EQ(model.points.size(), 1u);
  }
}

TEST(TextModel, Utf16IsNamed) {
  EXPECT_THAT(ErrorOfText(std::string("\xFF\xFE#\0 \0\n\0", 8)),
              HasSubstr("cameras.txt: is text in UTF-16"));
  EXPECT_THAT(ErrorOfText(kCamera, std::string("\xFE\xFF\0#\0\n", 6)),
              HasSubstr("images.txt: is text in UTF-16"));
}

TEST(TextModel, NamesInCodePagesKeepTheirBytes) {
  const SparseModel model = ReadText(kCamera, "1 1 0 0 0 0 0 1 1 \xBD\xD8.png\n\n", "");
  EXPECT_EQ(model.images.at(0).name, "\\xBD\\xD8.png");
  EXPECT_EQ(model.images.at(0).StoredName(), "\xBD\xD8.png");
  std::ostringstream out;
  WriteImagesText(model, out);
  EXPECT_THAT(out.str(), HasSubstr(" \xBD\xD8.png\n"));
}

TEST(TextModel, WindowsLineEndsAndTabsAreRead) {
  const SparseModel model = ReadText(
      "# c\r\n1\tPINHOLE 640  480 500 500 320 240\r\n",
      "# a\r\n\r\n1 1 0 0 0 0 0 1 1 a.png\r\n1.5 2.5 -1\r\n2 1 0 0 0 0 0 2 1 b.png\r\n\r\n",
      "3 1 2 3 4 5 6 0.5 1 0\r\n");
  ASSERT_EQ(model.images.size(), 2u);
  EXPECT_EQ(model.images[0].name, "a.png");
  ASSERT_EQ(model.images[0].observations.size(), 1u);
  EXPECT_EQ(model.images[0].observations[0].point3D_id, kNoPoint3D);
  EXPECT_TRUE(model.images[1].observations.empty());
  EXPECT_EQ(model.points.at(0).track.size(), 1u);
}

TEST(TextModel, EmptyLineOfPointsBelongsToItsImage) {
  const SparseModel model =
      ReadText(kCamera, "1 1 0 0 0 0 0 1 1 a.png\n\n2 1 0 0 0 0 0 2 1 b.png", "");
  ASSERT_EQ(model.images.size(), 2u);
  EXPECT_EQ(model.images[1].name, "b.png");
}

TEST(TextModel, RemovedLineOfPointsIsNoticed) {
  EXPECT_THAT(ErrorOfText(kCamera, "1 1 0 0 0 0 0 1 1 a.png\n2 1 0 0 0 0 0 2 1 b.png\n"),
              HasSubstr("images.txt: line 2: \"b.png\" is not a number"));
}

TEST(TextModel, DecimalCommaIsNoNumber) {
  EXPECT_THAT(ErrorOfText("1 PINHOLE 640 480 520,22 500 320 240\n"),
              HasSubstr("cameras.txt: line 1: \"520,22\" is not a number"));
}

TEST(TextModel, NanIsNoPose) {
  EXPECT_THAT(ErrorOfText(kCamera, "1 nan 0 0 0 0 0 1 1 a.png\n\n"), HasSubstr("not finite"));
  EXPECT_THAT(ErrorOfText(kCamera, "1 0 0 0 0 0 0 1 1 a.png\n\n"), HasSubstr("zero quaternion"));
}

TEST(TextModel, UnknownModelAndWrongParameterCountAreNamed) {
  EXPECT_THAT(ErrorOfText("\n1 PINHOL 640 480 500 500 320 240\n"),
              HasSubstr("cameras.txt: line 2: camera 1 has the unknown camera model \"PINHOL\""));
  EXPECT_THAT(ErrorOfText("1 PINHOLE 640 480 500 500 320\n"),
              HasSubstr("camera 1: PINHOLE has 4 parameters, found 3"));
}

TEST(TextModel, ShortLinesAreNamed) {
  EXPECT_THAT(ErrorOfText("1 PINHOLE 640\n"), HasSubstr("line 1: the line ends before HEIGHT"));
  EXPECT_THAT(ErrorOfText(kCamera, "1 1 0 0 0 0 0 1\n"), HasSubstr("ends before CAMERA_ID"));
  EXPECT_THAT(ErrorOfText(kCamera, "1 1 0 0 0 0 0 1 1\n\n"), HasSubstr("the image has no name"));
  EXPECT_THAT(ErrorOfText(kCamera, "1 1 0 0 0 0 0 1 1 a.png\n5 6\n"),
              HasSubstr("line 2: the line ends"));
  EXPECT_THAT(ErrorOfText(kCamera, kImage, "1 0 0 0 1 2 3 0.5 1\n"),
              HasSubstr("points3D.txt: line 1"));
  EXPECT_THAT(ErrorOfText(kCamera, kImage, "1 0 0 0 1 2 300 0.5\n"), HasSubstr("\"300\""));
  EXPECT_EQ(ErrorOfText(kCamera, kImage, "1 0 0 0 1 2 3 0.5 1 0\n"), "");
}

}  // namespace
}  // namespace limn::colmap_ext
