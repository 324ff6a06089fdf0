// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/edge_files.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kEdg =
    "# EDGE_MAP v3.0\n\nWIDTH=80\nHEIGHT=60\nEDGE_COUNT=2\n"
    "[10, 20] 0 5 [10, 20] 0 5 0.1\n[11, 20] 0 5 [11, 20] 0 5 0\n";

// Three photographs of 80 x 60 pixels, bright on the left of x = 40.
class EdgeFilesTest : public ::testing::Test {
 protected:
  EdgeFilesTest() {
    fs::create_directories(dir_ / "images/sub");
    for (const char* name : {"a.jpg", "a.png", "sub/c.png"}) {
      View view;
      view.name = name;
      view.camera.width = 80;
      view.camera.height = 60;
      set_.views.push_back(view);
      set_.files.push_back({.image_name = name,
                            .image_path = (dir_ / "images" / name).string(),
                            .mask_path = "",
                            .stored_size = {80, 60}});
      cv::Mat image(60, 80, CV_8UC1, cv::Scalar(50));
      image.colRange(0, 40).setTo(200);
      EXPECT_TRUE(cv::imwrite(set_.files.back().image_path, image));
    }
  }

  void UseHalfSize() {
    for (View& view : set_.views) {
      view.camera.width = 40;
      view.camera.height = 30;
    }
    set_.max_image_size = 40;
  }

  std::vector<std::string> Find() const { return FindEdgeFiles((dir_ / "edges").string(), set_); }
  std::string FindError() const {
    return ErrorText<IoError>([&] { Find(); });
  }

  // The file as that of the first view.
  GivenEdges Read(const std::string& path) const { return ReadEdgeFile(path, set_, 0, {}); }
  std::string ReadError(const std::string& path) const {
    return ErrorText<IoError>([&] { Read(path); });
  }

  std::string WriteMap(const std::string& name, const cv::Mat& map) const {
    const fs::path path = dir_ / name;
    fs::create_directories(path.parent_path());
    EXPECT_TRUE(cv::imwrite(path.string(), map));
    return path.string();
  }

  TempDir dir_;
  ViewSet set_;
};

TEST_F(EdgeFilesTest, AreFoundByNameWithAndWithoutExtension) {
  const std::string a = dir_.WriteFile("edges/a.jpg.edg", kEdg);
  const std::string b = dir_.WriteFile("edges/a.png.cem.gz", "");
  const std::string c = dir_.WriteFile("edges/sub/c.edg.gz", "");
  EXPECT_THAT(Find(), ElementsAre(a, b, c));
}

TEST_F(EdgeFilesTest, MissingOnesAreNamed) {
  EXPECT_THAT(FindError(), HasSubstr("edges: no such folder (edges_path)"));
  dir_.WriteFile("edges/a.jpg.edg", kEdg);
  dir_.WriteFile("edges/c.edg", kEdg);  // not in the folder of the image
  EXPECT_THAT(FindError(), HasSubstr("edges: has no edges of 2 of 3 images (a.png, sub/c.png)"));
}

TEST_F(EdgeFilesTest, TwoFilesOfAnImageAreRefused) {
  dir_.WriteFile("edges/a.jpg.edg", kEdg);
  dir_.WriteFile("edges/a.jpg.cem", "");
  EXPECT_THAT(FindError(), AllOf(HasSubstr("a.jpg.edg: and "),
                                 HasSubstr("a.jpg.cem are both edges of image \"a.jpg\"")));
}

TEST_F(EdgeFilesTest, AFileOfTwoImagesIsRefused) {
  dir_.WriteFile("edges/a.edg", kEdg);
  dir_.WriteFile("edges/sub/c.edg", kEdg);
  EXPECT_THAT(FindError(),
              HasSubstr("a.edg: may be the edges of \"a.jpg\" or of \"a.png\": name it by"));
}

TEST_F(EdgeFilesTest, PhotographsAreNoEdges) {
  set_.views.resize(1);
  set_.files.resize(1);
  set_.views[0].name = "sub/c.png";
  set_.files[0].image_path = (dir_ / "images/sub/c.png").string();
  EXPECT_THAT(ErrorText<IoError>([&] { FindEdgeFiles((dir_ / "images").string(), set_); }),
              HasSubstr("c.png: is an image itself"));
}

TEST_F(EdgeFilesTest, PhotographsMayLieBesideTheirEdges) {
  std::vector<std::string> files;
  for (const View& view : set_.views)
    files.push_back(dir_.WriteFile("images/" + view.name + ".edg", ""));
  EXPECT_EQ(FindEdgeFiles((dir_ / "images").string(), set_), files);
}

TEST_F(EdgeFilesTest, EdgelsAreToBeLinked) {
  const GivenEdges given = Read(dir_.WriteFile("a.edg", kEdg));
  EXPECT_FALSE(given.are_linked);
  ASSERT_EQ(given.curves.edge_map.edgels.size(), 2u);
  EXPECT_EQ(given.curves.edge_map.edgels[0].position_sigma_px, 0.1f);
  EXPECT_GT(given.curves.edge_map.edgels[1].position_sigma_px, 0.1f);  // unknown
}

TEST_F(EdgeFilesTest, EdgesOfTheStoredImageAreShrunkWithIt) {
  UseHalfSize();
  const EdgeMap map = Read(dir_.WriteFile("a.edg", kEdg)).curves.edge_map;
  EXPECT_EQ(map.width, 40);
  EXPECT_EQ(map.edgels[0].position_px, Eigen::Vector2d(4.75, 9.75));
  // Those of the image as used stay.
  std::string used = kEdg;
  used.replace(used.find("80"), 2, "40").replace(used.find("60"), 2, "30");
  EXPECT_EQ(Read(dir_.WriteFile("b.edg", used)).curves.edge_map.edgels[0].position_px,
            Eigen::Vector2d(10, 20));
  const ImageCurves curves = Read(dir_.WriteFile("a.txt", "9.5 9.5 9.5 49.5\n")).curves;
  EXPECT_NEAR(curves.edge_map.edgels[0].position_px.x(), 4.5, 1e-12);
  EXPECT_EQ(curves.edge_map.edgels.size(), 21u);
}

TEST_F(EdgeFilesTest, AnotherSizeIsRefused) {
  std::string other = kEdg;
  other.replace(other.find("80"), 2, "81");
  EXPECT_THAT(ReadError(dir_.WriteFile("a.edg", other)),
              HasSubstr("a.edg: the edges of an image of 81 x 60 pixels, but theirs has 80 x 60"));
  EXPECT_THAT(ReadError(WriteMap("a.png", cv::Mat::zeros(30, 40, CV_8UC1))),
              HasSubstr("a.png: the edges of an image of 40 x 30 pixels, but theirs has 80 x 60"));
}

// Down the border, with the bright side on the left: Normal() of a line that runs up.
TEST_F(EdgeFilesTest, LinesOfTextTakeTheirSideFromThePhotograph) {
  for (const char* line : {"39.5 10 39.5 50\n", "39.5 50 39.5 10\n"}) {
    const GivenEdges given = Read(dir_.WriteFile("a.txt", line));
    EXPECT_TRUE(given.are_linked);
    ASSERT_EQ(given.curves.fragments.size(), 1u);
    const auto& ids = given.curves.fragments[0].edgel_ids;
    ASSERT_EQ(ids.size(), 41u);
    const Edgel& first = given.curves.edge_map.edgels[ids.front()];
    EXPECT_NEAR(first.position_px.y(), 50, 1e-9);
    EXPECT_NEAR(first.Normal().x(), -1, 1e-9);
  }
}

TEST_F(EdgeFilesTest, MapsOf8And16BitsGiveTheSameEdgels) {
  cv::Mat map = cv::Mat::zeros(60, 80, CV_8UC1);
  cv::line(map, {39, 5}, {39, 55}, 204);
  const EdgeMap edges = Read(WriteMap("a.png", map)).curves.edge_map;
  ASSERT_GT(edges.edgels.size(), 40u);
  for (const Edgel& edgel : edges.edgels) {
    EXPECT_NEAR(edgel.position_px.x(), 39, 0.01);
    EXPECT_NEAR(edgel.Normal().x(), -1, 1e-3);  // towards the bright side
    // Less towards the ends of the line.
    if (std::abs(edgel.position_px.y() - 30) < 20) {
      EXPECT_NEAR(edgel.strength, 0.8f, 0.01f);
    }
  }
  cv::Mat deep;
  map.convertTo(deep, CV_16UC1, 257);
  const EdgeMap of_deep = Read(WriteMap("b.png", deep)).curves.edge_map;
  ASSERT_EQ(of_deep.edgels.size(), edges.edgels.size());
  for (size_t i = 0; i < edges.edgels.size(); ++i) {
    EXPECT_NEAR((of_deep.edgels[i].position_px - edges.edgels[i].position_px).norm(), 0, 1e-4);
  }
}

// The file ends within its pixels, which is not noticed.
TEST_F(EdgeFilesTest, MapsOfAnotherSizeAreNotDecoded) {
  const std::string path = WriteMap("a.pgm", cv::Mat::zeros(61, 80, CV_8UC1));
  fs::resize_file(path, 20);
  EXPECT_THAT(ReadError(path), HasSubstr("a.pgm: the edges of an image of 80 x 61 pixels"));
}

TEST_F(EdgeFilesTest, CurvesGivenManyTimesAreNotKeptMoreThanEightTimes) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "2 20 30 20\n";
  EXPECT_EQ(Read(dir_.WriteFile("a.txt", text)).curves.fragments.size(), 8u);
}

// Linking would not end on them.
TEST_F(EdgeFilesTest, EdgelsAreThinnedAtTheSizeOfTheView) {
  UseHalfSize();
  std::string text = "# EDGE_MAP v3.0\n\nWIDTH=80\nHEIGHT=60\nEDGE_COUNT=40\n";
  for (int i = 0; i < 40; ++i) {
    text += "[0, 0] 0 5 [" + std::to_string(20 + i) + ", 20] 0 5 0.1\n";
  }
  EXPECT_EQ(Read(dir_.WriteFile("a.edg", text)).curves.edge_map.edgels.size(), 20u);
}

TEST_F(EdgeFilesTest, PicturesThatAreNoMapsAreRefused) {
  EXPECT_THAT(ReadError(WriteMap("a.png", cv::Mat(60, 80, CV_8UC1, cv::Scalar(255)))),
              HasSubstr("edges must be bright on dark"));
  EXPECT_THAT(ReadError(WriteMap("b.png", cv::Mat(60, 80, CV_8UC3, cv::Scalar(1, 2, 3)))),
              HasSubstr("it has colors"));
  EXPECT_THAT(ReadError(dir_.WriteFile("c.png", "no picture")), HasSubstr("c.png: "));
}

TEST_F(EdgeFilesTest, MaskedPixelsHoldNone) {
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(255));
  mask.at<uchar>(20, 10) = 0;
  set_.files[0].mask_path = WriteMap("mask.png", mask);
  EXPECT_EQ(Read(dir_.WriteFile("a.edg", kEdg)).curves.edge_map.edgels.size(), 1u);
  // A fragment is cut there.
  const ImageCurves curves = Read(dir_.WriteFile("a.txt", "2 20 30 20\n")).curves;
  ASSERT_EQ(curves.fragments.size(), 2u);
  EXPECT_EQ(curves.edge_map.edgels.size(), 28u);
  // All ids are those of the rest.
  for (const CurveFragment& fragment : curves.fragments) {
    for (const EdgelId id : fragment.edgel_ids) {
      EXPECT_GT(std::abs(curves.edge_map.edgels.at(id).position_px.x() - 10), 0.9);
    }
  }
}

TEST_F(EdgeFilesTest, DamagedPhotographsHaveNone) {
  set_.files[0].is_damaged = true;
  EXPECT_TRUE(Read(dir_.WriteFile("a.edg", kEdg)).curves.edge_map.edgels.empty());
  EXPECT_TRUE(Read(dir_.WriteFile("a.txt", "2 20 30 20\n")).curves.fragments.empty());
}

}  // namespace
}  // namespace limn::colmap_ext
