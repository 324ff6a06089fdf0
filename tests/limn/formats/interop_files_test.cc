// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include <gtest/gtest.h>

#include "limn/formats/cem_file.h"
#include "limn/formats/edg_file.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

ImageCurves TwoFragments() {
  ImageCurves curves;
  curves.edge_map.width = 64;
  curves.edge_map.height = 48;
  for (int i = 0; i < 5; ++i) {
    Edgel edgel;
    edgel.position_px = {i + 1.0 / 3, 7.125 * i};
    edgel.tangent_rad = 1.25 * i - 2.5;
    edgel.strength = 1.1f * static_cast<float>(i);
    edgel.position_sigma_px = 0.07f;
    curves.edge_map.edgels.push_back(edgel);
  }
  curves.fragments = {{{0, 1, 4}, false}, {{2, 3, 1}, true}};
  return curves;
}

void ExpectSameEdgels(const EdgeMap& read, const EdgeMap& written) {
  EXPECT_EQ(read.width, written.width);
  EXPECT_EQ(read.height, written.height);
  ASSERT_EQ(read.edgels.size(), written.edgels.size());
  for (size_t i = 0; i < read.edgels.size(); ++i) {
    EXPECT_EQ(read.edgels[i].position_px, written.edgels[i].position_px);
    EXPECT_EQ(read.edgels[i].tangent_rad, written.edgels[i].tangent_rad);
    EXPECT_EQ(read.edgels[i].strength, written.edgels[i].strength);
    EXPECT_EQ(read.edgels[i].position_sigma_px, written.edgels[i].position_sigma_px);
  }
}

template <typename Value, typename Write>
std::string WriteTextTo(const std::string& path, const Value& value, const Write& write) {
  std::ofstream out(path);
  write(value, out);
  return path;
}

TEST(EdgFile, RoundTrip) {
  const TemporaryFolder folder;
  const EdgeMap written = TwoFragments().edge_map;
  const EdgeMap read = ReadEdg(WriteTextTo(folder.Path("a.edg"), written, WriteEdg));
  ExpectSameEdgels(read, written);
  EXPECT_EQ(read.edgels[2].stored_px, read.edgels[2].position_px.cast<float>());
}

TEST(EdgFile, NineLinesOfHeaderComeBeforeTheEdgels) {
  const TemporaryFolder folder;
  std::ifstream file(WriteTextTo(folder.Path("a.edg"), TwoFragments().edge_map, WriteEdg));
  std::string line;
  for (int i = 0; i < 10; ++i) std::getline(file, line);
  EXPECT_EQ(line.substr(0, 6), "[0, 0]");
}

TEST(EdgFile, OldVersionWithoutUncertainty) {
  const TemporaryFolder folder;
  const EdgeMap map = ReadEdg(folder.Write("old.edg",
                                           "# EDGE_MAP v2.0\n\n# Format\n\n WIDTH=640\n"
                                           "HEIGHT=480\nEDGE_COUNT=1\n\n\n"
                                           "EDGE : [3, 4]  0 2.5  [3.25, 4.5]  6.0 2.5\n"));
  ASSERT_EQ(map.edgels.size(), 1u);
  EXPECT_EQ(map.edgels[0].position_px, Eigen::Vector2d(3.25, 4.5));
  EXPECT_NEAR(map.edgels[0].tangent_rad, 6.0 - 2 * M_PI, 1e-12);
  EXPECT_EQ(map.edgels[0].strength, 2.5f);
}

TEST(EdgFile, DamagedFilesAreRefused) {
  const TemporaryFolder folder;
  const std::string header = "# EDGE_MAP v3.0\n\nWIDTH=6\nHEIGHT=4\n";
  const std::string edgel = "[1, 1] 0 1 [1, 1] 0 1 0\n";
  const auto read = [&](const std::string& text) { return ReadEdg(folder.Write("a.edg", text)); };
  EXPECT_EQ(read(header + "EDGE_COUNT=1\n" + edgel).edgels.size(), 1u);
  EXPECT_THROW(read("hello\n"), IoError);
  EXPECT_THROW(read(header), IoError);
  EXPECT_THROW(read("# EDGE_MAP v3.0\nEDGE_COUNT=0\n"), IoError);
  EXPECT_THROW(read(header + "EDGE_COUNT=2\n" + edgel), IoError);
  EXPECT_THROW(read(header + "EDGE_COUNT=0\n" + edgel), IoError);
  EXPECT_THROW(read(header + "EDGE_COUNT=1\n[1, 1] 0 1 [1, nan] 0 1 0\n"), IoError);
  EXPECT_THROW(read(header + "EDGE_COUNT=-3\n"), IoError);
  for (const char* count : {"", "x", "1px"}) {
    EXPECT_THROW(read(header + "EDGE_COUNT=" + count + "\n" + edgel), IoError) << count;
  }
}

TEST(EdgFile, ImpossibleEdgelsAreRefusedByLine) {
  const TemporaryFolder folder;
  const auto error_of = [&](const std::string& numbers) {
    const std::string path =
        folder.Write("a.edg", "# EDGE_MAP v3.0\n\nWIDTH=6\nHEIGHT=4\nEDGE_COUNT=1\n[1, 1] 0 1 " +
                                  numbers + "\n");
    try {
      ReadEdg(path);
    } catch (const IoError& error) {
      return std::string(error.what()).substr(path.size());
    }
    return std::string();
  };
  EXPECT_EQ(error_of("[6, 4] 0 1 0"), "");
  EXPECT_EQ(error_of("[6.1, 1] 0 1 0"), ": line 6: edgel outside the image");
  EXPECT_EQ(error_of("[1, -1.1] 0 1 0"), ": line 6: edgel outside the image");
  EXPECT_EQ(error_of("[1e300, 1] 0 1 0"), ": line 6: edgel outside the image");
  EXPECT_EQ(error_of("[1, 1] 0 1 inf"), ": line 6: edgel not finite");
  EXPECT_EQ(error_of("[1, 1] nan 1 0"), ": line 6: edgel not finite");
  EXPECT_EQ(error_of("[1, 1] 0 1 -1"), ": line 6: uncertainty below 0");
  EXPECT_EQ(error_of("[1, 1] 0 1 10"), "");
  EXPECT_EQ(error_of("[1, 1] 0 1 1e30"), ": line 6: uncertainty above 10 px");
  EXPECT_EQ(error_of("[1, 1] 0 -1 0"), ": line 6: strength below 0");
}

TEST(CemFile, RoundTrip) {
  const TemporaryFolder folder;
  const ImageCurves written = TwoFragments();
  const ImageCurves read = ReadCem(WriteTextTo(folder.Path("a.cem"), written, WriteCem));
  ExpectSameEdgels(read.edge_map, written.edge_map);
  ASSERT_EQ(read.fragments.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.fragments[i].edgel_ids, written.fragments[i].edgel_ids);
    EXPECT_EQ(read.fragments[i].closed, written.fragments[i].closed);
  }
}

// As the MSEL tools write it.
TEST(CemFile, UncertaintyMayBeMissing) {
  const TemporaryFolder folder;
  const ImageCurves read = ReadCem(
      folder.Write("a.cem",
                   ".CEM v2.0\nsize=[64 48]\n[Edgemap]\ncount=2\n(1, 2)\t0.5\t9\t0\n"
                   "(2, 2)\t0.5\t9\t0\n[Contours]\ncount=1\n[0 1 ]\n[Contour Properties]\n"));
  ASSERT_EQ(read.edge_map.edgels.size(), 2u);
  EXPECT_EQ(read.edge_map.edgels[1].position_sigma_px, 0);
  EXPECT_EQ(read.fragments.size(), 1u);
}

// The image has 4 x 3 pixels.
TEST(CemFile, LengthIsBounded) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& contours) {
    return ReadCem(folder.Write(
        "a.cem",
        ".CEM v2.0\n# by hand\nsize=[4 3]\n[Edgemap]\ncount=3\n(0, 0)\t0\t9\t0\n(4, 3)\t0\t9\t0\n"
        "(0, 0.1)\t0\t9\t0\n[Contours]\ncount=2\n" +
            contours + "[Contour Properties]\n"));
  };
  EXPECT_EQ(read("[0 2 0 2 0 2]\n[0 2 0 2 0 2]\n").fragments.size(), 2u);
  EXPECT_THROW(read("[0 2 0 2 0 2]\n[0 2 0 2 0 2 0]\n"), IoError);
  EXPECT_EQ(read("[0 1]\n[1 0]\n").fragments.size(), 2u);
  EXPECT_THROW(read("[0 1 0]\n[0 1]\n"), IoError);
}

TEST(CemFile, DamagedFilesAreRefused) {
  const TemporaryFolder folder;
  const std::string good =
      TemporaryFolder::Read(WriteTextTo(folder.Path("a.cem"), TwoFragments(), WriteCem));
  const size_t end_of_contours = good.find("[Contour Properties]");
  for (size_t length = 0; length + 6 < end_of_contours; length += 3) {
    EXPECT_THROW(ReadCem(folder.Write("cut.cem", good.substr(0, length))), IoError) << length;
  }
  std::string bad_id = good;
  bad_id.replace(bad_id.find("[0 1 4 ]"), 8, "[0 1 5 ]");
  EXPECT_THROW(ReadCem(folder.Write("id.cem", bad_id)), IoError);
}

}  // namespace
}  // namespace limn
