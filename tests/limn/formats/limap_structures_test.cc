// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/limap_structures.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/read_curves.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr const char* kNames[] = {"structures2d.bin", "lines3D.bin", "groups3D.bin",
                                  "wireframe3D.bin"};

// Two lines that meet at point 9, one of them seen in two images, and a group.
LimapStructures SmallStructures() {
  LimapStructures structures;
  LimapImage image;
  image.id = 3;
  image.num_points = 5;
  image.segments = {{{1.5, 2}, {3, 4.25}, -1, 7}, {{0, 1}, {2, 3}, 0.5, kNoLimapId}};
  image.groups = {{1, {{4, 0.5}}, {{0, 1}, {1, 0.25}}, 2}};
  image.wireframe = {{4, 0, 1}, {4, 1, 0.75}};
  structures.images = {image, LimapImage{4, 1, {{{9, 8}, {7, 6}, -1, 7}}, {}, {}}};
  structures.lines = {{7, {0, 0, 0}, {1, 0, 0.5}, {{3, 0}, {4, 0}}, 0.01},
                      {8, {1, 0, 0.5}, {1, 2, 0.5}, {}, -1}};
  structures.groups = {{2, 1, {{9, 1}}, {{7, 1}, {8, 0.5}}, {{3, 0}}, {0, 0, 1}}};
  structures.wireframe = {{9, 7, 2}, {9, 8, 0}};
  return structures;
}

std::string WriteTo(const TemporaryFolder& folder, const LimapStructures& structures) {
  std::filesystem::create_directories(folder.Path("structures"));
  WriteLimapStructures(structures, folder.Path("structures"));
  return folder.Path("structures");
}

template <typename T>
void Put(T value, std::string* bytes) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes->append(raw, sizeof(T));
}

TEST(LimapStructures, LinesHaveTheLayoutOfLimap) {
  const TemporaryFolder folder;
  WriteTo(folder, SmallStructures());
  std::string expected;
  Put<uint64_t>(2, &expected);
  Put<uint64_t>(7, &expected);
  for (const double value : {0.0, 0.0, 0.0, 1.0, 0.0, 0.5}) Put(value, &expected);
  Put<uint64_t>(2, &expected);
  for (const uint32_t value : {3u, 0u, 4u, 0u}) Put(value, &expected);
  Put(0.01, &expected);
  Put<uint64_t>(8, &expected);
  for (const double value : {1.0, 0.0, 0.5, 1.0, 2.0, 0.5}) Put(value, &expected);
  Put<uint64_t>(0, &expected);
  Put(-1.0, &expected);
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("structures/lines3D.bin")), expected);
}

TEST(LimapStructures, WireframeAndImagesHaveTheLayoutOfLimap) {
  const TemporaryFolder folder;
  LimapStructures structures;
  structures.images = {SmallStructures().images[0]};
  structures.lines = {SmallStructures().lines[1]};
  structures.wireframe = {{9, 8, 2}};
  WriteTo(folder, structures);
  std::string wireframe;
  for (const uint64_t value : {1, 9, 8}) Put(value, &wireframe);
  Put(2.0, &wireframe);
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("structures/wireframe3D.bin")), wireframe);

  std::string images;
  Put<uint64_t>(1, &images);
  for (const uint32_t value : {3, 5}) Put(value, &images);
  Put<uint64_t>(2, &images);
  for (const double value : {1.5, 2.0, 3.0, 4.25, -1.0}) Put(value, &images);
  Put<uint64_t>(7, &images);
  for (const double value : {0.0, 1.0, 2.0, 3.0, 0.5}) Put(value, &images);
  Put(~uint64_t{0}, &images);
  Put<uint64_t>(1, &images);
  Put<int32_t>(1, &images);
  Put<uint64_t>(1, &images);
  Put<uint32_t>(4, &images);
  Put(0.5, &images);
  Put<uint64_t>(2, &images);
  Put<uint32_t>(0, &images);
  Put(1.0, &images);
  Put<uint32_t>(1, &images);
  Put(0.25, &images);
  Put<uint64_t>(2, &images);
  Put<uint64_t>(2, &images);
  for (const uint32_t line : {0, 1}) {
    Put<uint32_t>(4, &images);
    Put(line, &images);
    Put(line == 0 ? 1.0 : 0.75, &images);
  }
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("structures/structures2d.bin")), images);
}

TEST(LimapStructures, GroupsHaveTheLayoutOfLimap) {
  const TemporaryFolder folder;
  WriteTo(folder, SmallStructures());
  std::string expected;
  Put<uint64_t>(1, &expected);
  Put<uint64_t>(2, &expected);
  Put<int32_t>(1, &expected);
  Put<uint64_t>(1, &expected);
  Put<uint64_t>(9, &expected);
  Put(1.0, &expected);
  Put<uint64_t>(2, &expected);
  Put<uint64_t>(7, &expected);
  Put(1.0, &expected);
  Put<uint64_t>(8, &expected);
  Put(0.5, &expected);
  Put<uint64_t>(1, &expected);
  for (const uint32_t value : {3u, 0u}) Put(value, &expected);
  Put<uint64_t>(3, &expected);
  for (const double value : {0.0, 0.0, 1.0}) Put(value, &expected);
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("structures/groups3D.bin")), expected);
}

TEST(LimapStructures, WhatIsReadIsWrittenAgain) {
  const TemporaryFolder folder;
  const std::string first = WriteTo(folder, SmallStructures());
  const LimapStructures read = ReadLimapStructures(first);
  EXPECT_EQ(read.lines[0].track[1].image_id, 4u);
  EXPECT_EQ(read.images[0].segments[0].end, Eigen::Vector2d(3, 4.25));
  EXPECT_EQ(read.groups[0].params, std::vector<double>({0, 0, 1}));
  std::filesystem::create_directories(folder.Path("again"));
  WriteLimapStructures(read, folder.Path("again"));
  for (const std::string name : kNames) {
    EXPECT_EQ(TemporaryFolder::Read(folder.Path("again/" + name)),
              TemporaryFolder::Read(folder.Path("structures/" + name)))
        << name;
  }
}

TEST(LimapStructures, FilesCutAnywhereOrTooLongAreRefused) {
  const TemporaryFolder folder;
  const std::string structures = WriteTo(folder, SmallStructures());
  for (const std::string name : kNames) {
    const std::string bytes = TemporaryFolder::Read(structures + "/" + name);
    for (size_t length = 0; length < bytes.size(); ++length) {
      folder.Write("structures/" + name, bytes.substr(0, length));
      EXPECT_THROW(ReadLimapStructures(structures), IoError) << name << " " << length;
    }
    folder.Write("structures/" + name, bytes + "x");
    EXPECT_THAT([&] { ReadLimapStructures(structures); },
                ThrowsMessage<IoError>(HasSubstr(name + ": byte")));
    folder.Write("structures/" + name, bytes);
  }
  std::filesystem::remove(structures + "/groups3D.bin");
  EXPECT_THAT([&] { ReadLimapStructures(structures); },
              ThrowsMessage<IoError>(HasSubstr("groups3D.bin")));
}

TEST(LimapStructures, WhatDoesNotFitTogetherIsRefused) {
  const TemporaryFolder folder;
  const auto expect_refused = [&](const LimapStructures& structures, const std::string& why) {
    const std::string path = WriteTo(folder, structures);
    EXPECT_THAT([&] { ReadLimapStructures(path); }, ThrowsMessage<IoError>(HasSubstr(why)));
  };
  LimapStructures twice = SmallStructures();
  twice.lines[1].id = 7;
  expect_refused(twice, "lines3D.bin: line 7 is there twice");
  LimapStructures no_line = SmallStructures();
  no_line.wireframe[1].line = 6;
  expect_refused(no_line, "wireframe3D.bin: line 6 does not exist");
  LimapStructures no_segment = SmallStructures();
  no_segment.lines[0].track[0].index = 2;
  expect_refused(no_segment, "lines3D.bin: line 7: segment 2 of image 3 does not exist");
  LimapStructures no_number = SmallStructures();
  no_number.lines[1].end.z() = std::numeric_limits<double>::quiet_NaN();
  expect_refused(no_number, "end of a line is not finite");
}

TEST(LimapStructures, TextOfLinesAndWireframe) {
  const TemporaryFolder folder;
  const std::string lines = "2\n7\n0 0 0 1 0 0.5\n2\n3 0\n4 0\n0.01\n8\n1 0 0.5 1 2 0.5\n0\n-1\n";
  std::filesystem::create_directories(folder.Path("structures"));
  folder.Write("structures/lines3D.txt", lines);
  folder.Write("structures/wireframe3D.txt", "2\n9 7 2\n9 8 0\n");
  const LimapStructures read = ReadLimapStructures(folder.Path("structures"));
  ASSERT_EQ(read.lines.size(), 2u);
  EXPECT_EQ(read.lines[0].uncertainty, 0.01);
  EXPECT_EQ(read.lines[0].track.size(), 2u);
  ASSERT_EQ(read.wireframe.size(), 2u);
  EXPECT_EQ(read.wireframe[1].line, 8u);
  EXPECT_EQ(ReadCurves(folder.Path("structures/lines3D.txt")).polylines.size(), 2u);
  for (const auto& [text, why] :
       {std::pair(lines + "1", "line 12: more than was announced"),
        std::pair(lines.substr(0, lines.size() - 3), "the file ends before uncertainty"),
        std::pair(std::string("2\n7.5\n"), "line 2: line id expected, not \"7.5\""),
        std::pair(std::string("-1\n"), "a count expected, not \"-1\""),
        std::pair(std::string("99999999999999999\n"), "the file ends before line id")}) {
    folder.Write("structures/lines3D.txt", text);
    EXPECT_THAT([&] { ReadLimapStructures(folder.Path("structures")); },
                ThrowsMessage<IoError>(HasSubstr(why)));
  }
}

TEST(LimapStructures, LinesAreCurvesOfTheEvaluator) {
  const TemporaryFolder folder;
  LimapStructures structures = SmallStructures();
  structures.lines.push_back({9, {5, 5, 5}, {5, 5, 5}, {}, -1});
  WriteTo(folder, structures);
  for (const std::string& path : {folder.Path("structures/lines3D.bin"), folder.Path("structures"),
                                  folder.Path("structures/..")}) {
    const CurveSet set = ReadCurves(path);
    ASSERT_EQ(set.polylines.size(), 2u) << path;
    EXPECT_EQ(set.polylines[1][1], Eigen::Vector3d(1, 2, 0.5));
  }
  std::filesystem::remove_all(folder.Path("structures"));
  EXPECT_THAT([&] { ReadCurves(folder.Path(".")); },
              ThrowsMessage<IoError>(HasSubstr("is a folder without lines of LIMAP")));
}

TEST(LimapStructures, TracksOfLimap1) {
  const TemporaryFolder folder;
  const std::string text =
      "2\n0 3 2\n1.0 2.0     3.0\n4 5 6\n10 11 11 \n0 3 4 \n1 1 1\n0 0 0\n0 0 1\n10 \n7 \n";
  const CurveSet set = ReadCurves(folder.Write("alltracks.txt", text));
  ASSERT_EQ(set.polylines.size(), 2u);
  EXPECT_EQ(set.polylines[0][0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(set.polylines[0][1], Eigen::Vector3d(4, 5, 6));
  folder.Write("alltracks.txt", text.substr(0, text.size() - 4));
  EXPECT_THAT([&] { ReadCurves(folder.Path("alltracks.txt")); },
              ThrowsMessage<IoError>(HasSubstr("the file ends before image or segment")));
}

TEST(Line3dpp, SegmentsOfTextAndStl) {
  const TemporaryFolder folder;
  const std::string text =
      "1 0 0 0 1 0 0.5 2 4 17 1.5 2 3 4 5 18 1 2 3 4 \n"
      "2 1 2 3 4 5 6 7 8 9 7 8 10 0 \n";
  const CurveSet set = ReadCurves(folder.Write("Line3D++__W_FULL__N_10__vis_3.txt", text));
  ASSERT_EQ(set.polylines.size(), 3u);
  EXPECT_EQ(set.polylines[0][1], Eigen::Vector3d(1, 0, 0.5));
  EXPECT_EQ(set.polylines[2][1], Eigen::Vector3d(7, 8, 10));
  const std::string facet =
      " facet normal 1.0e+000 0.0e+000 0.0e+000\n  outer loop\n   vertex 0 0 0\n"
      "   vertex 1.000000e+00 0 0.5\n   vertex 0 0 0\n  endloop\n endfacet\n";
  const CurveSet stl =
      ReadCurves(folder.Write("l.stl", "solid lineModel\n" + facet + "endsolid lineModel\n"));
  ASSERT_EQ(stl.polylines.size(), 1u);
  EXPECT_EQ(stl.polylines[0], set.polylines[0]);
}

TEST(Line3dpp, DamagedFilesAreRefusedByLine) {
  const TemporaryFolder folder;
  const auto expect_refused = [&](const std::string& name, const std::string& text,
                                  const std::string& why) {
    const std::string path = folder.Write(name, text);
    EXPECT_THAT([&] { ReadCurves(path); }, ThrowsMessage<IoError>(HasSubstr(why)));
  };
  const std::string name = "Line3D++__a.txt";
  expect_refused(name, "1 0 0 0 1 0 0.5 1 4 17 1.5 2 3", "the file ends before 2D segment");
  expect_refused(name, "1 0 0 0 1 0 0.5 0 4\n", "line 1: more numbers than announced");
  expect_refused(name, "1 0 0 nan 1 0 0.5 0\n", "line 1: coordinate not finite");
  expect_refused(name, "0.5 0 0 0\n", "number of segments is not a count");
  expect_refused("a.stl",
                 "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                 "vertex 0 1 0\n",
                 "line 6: a facet with an area");
  expect_refused("a.stl", "solid\nfacet normal 0 0 1\nouter hoop\n", "loop expected, not \"hoop\"");
  expect_refused("a.stl", "solid\n", "the file ends before facet or endsolid");
}

}  // namespace
}  // namespace limn
