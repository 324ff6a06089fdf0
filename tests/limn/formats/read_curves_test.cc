// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/read_curves.h"

#include <algorithm>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "limn/formats/json_junctions_reader.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

template <typename T>
void PutBytes(std::string* bytes, T value, bool big_endian) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian) std::reverse(raw, raw + sizeof(T));
  bytes->append(raw, sizeof(T));
}

// Three vertices, a face to pass over, two edges; properties in an unusual order.
std::string BinaryPly(bool big_endian) {
  std::string bytes = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\ncomment made by a test\n"
                      "element vertex 3\nproperty uchar red\nproperty double z\n"
                      "property float x\nproperty double y\n"
                      "element face 1\nproperty list uchar int vertex_indices\n"
                      "element edge 2\nproperty ushort vertex2\nproperty int vertex1\nend_header\n";
  for (int i = 0; i < 3; ++i) {
    PutBytes<uint8_t>(&bytes, 200, big_endian);
    PutBytes<double>(&bytes, 0.25, big_endian);
    PutBytes<float>(&bytes, static_cast<float>(i), big_endian);
    PutBytes<double>(&bytes, -1.5, big_endian);
  }
  PutBytes<uint8_t>(&bytes, 3, big_endian);
  for (int i = 0; i < 3; ++i) PutBytes<int32_t>(&bytes, i, big_endian);
  for (int i = 0; i < 2; ++i) {
    PutBytes<uint16_t>(&bytes, static_cast<uint16_t>(i + 1), big_endian);
    PutBytes<int32_t>(&bytes, i, big_endian);
  }
  return bytes;
}

void ExpectIoError(const std::string& path, const std::string& part) {
  try {
    ReadCurves(path);
    FAIL() << path << " was accepted";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(path));
    EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
  }
}

TEST(ReadCurves, PlyInBothByteOrders) {
  const TemporaryFolder folder;
  for (const bool big_endian : {false, true}) {
    const CurveSet set = ReadCurves(folder.Write("a.ply", BinaryPly(big_endian)));
    ASSERT_EQ(set.polylines.size(), 1u);
    ASSERT_EQ(set.polylines[0].size(), 3u);
    EXPECT_EQ(set.polylines[0][2], Eigen::Vector3d(2, -1.5, 0.25));
    EXPECT_TRUE(set.points.empty());
  }
}

TEST(ReadCurves, PlyCutAnywhereIsRefused) {
  const TemporaryFolder folder;
  const std::string bytes = BinaryPly(false);
  for (size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(ReadCurves(folder.Write("cut.ply", bytes.substr(0, length))), IoError) << length;
  }
}

TEST(ReadCurves, AsciiPlyOfPoints) {
  const TemporaryFolder folder;
  const CurveSet set = ReadCurves(
      folder.Write("p.PLY",
                   "ply\r\nformat ascii 1.0\r\nelement vertex 2\r\nproperty float x\r\n"
                   "property float y\r\nproperty float z\r\nend_header\r\n1 2 3\r\n4 5 6e1"));
  ASSERT_EQ(set.points.size(), 2u);
  EXPECT_EQ(set.points[1], Eigen::Vector3d(4, 5, 60));
}

TEST(ReadCurves, PlyMayTellTheRadiiOfRods) {
  const TemporaryFolder folder;
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double radius\n"
      "property double y\nproperty double z\n";
  const std::string edges = "element edge 3\nproperty int vertex1\nproperty int vertex2\n";
  // The first ends exactly where the others meet.
  const CurveSet set = ReadCurves(
      folder.Write("rods.ply", vertices + edges +
                                   "end_header\n1 0.5 0 0\n0 0.5 0 0\n0 0.25 0 0\n"
                                   "0 0.25 1 0\n0 nan 0 0\n0 0.25 -1 0\n0 1\n2 3\n4 5\n"));
  ASSERT_EQ(set.polylines.size(), 3u);
  EXPECT_EQ(set.polylines[0][0], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(set.rod_radii, (std::vector<double>{0.5, 0.25, 0}));
  EXPECT_TRUE(ReadCurves(folder.Write("a.ply", BinaryPly(false))).rod_radii.empty());
}

TEST(ReadCurves, BadPlyIsRefusedWithPlaceAndReason) {
  const TemporaryFolder folder;
  const std::string vertices =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nproperty double y\n"
      "property double z\n";
  const std::string edges = "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
  ExpectIoError(folder.Write("1.ply", "plx\n"), "line 1");
  ExpectIoError(folder.Write("2.ply", "ply\nformat ascii 2.0\n"), "version");
  ExpectIoError(folder.Write("3.ply", vertices + "property quad q\n"), "line 7");
  ExpectIoError(folder.Write("4.ply", vertices + "end_header\n1 2 what\n"), "line 8");
  ExpectIoError(folder.Write("5.ply", vertices + "end_header\n1 2 nan\n"), "not finite");
  ExpectIoError(folder.Write("6.ply", vertices + edges + "end_header\n1 2 3\n0 1\n"), "of 1");
  ExpectIoError(folder.Write("twice.ply", vertices + edges + edges + "end_header\n"),
                "element edge is there twice");
  ExpectIoError(folder.Write("7.ply",
                             "ply\nformat binary_little_endian 1.0\n"
                             "element vertex 99999999999999\nproperty double x\n"
                             "property double y\nproperty double z\nend_header\n"),
                "too short");
  ExpectIoError(folder.Write("9.ply", vertices + edges + "property double link\nend_header\n" +
                                          "1 2 3\n0 0 nan\n"),
                "link id");
  ExpectIoError(folder.Write("10.ply",
                             "ply\nformat ascii 1.0\nelement nothing 99999999999999\n"
                             "end_header\n"),
                "no element vertex");
  ExpectIoError(folder.Path("absent.ply"), "No such file");
  std::filesystem::create_directory(folder.Path("d.ply"));
  ExpectIoError(folder.Path("d.ply"), "folder");
  ExpectIoError(folder.Write("8.off", "solid"), "unknown extension");
}

TEST(ReadCurves, ObjLinesAndPoints) {
  const TemporaryFolder folder;
  const CurveSet set = ReadCurves(folder.Write(
      "a.obj",
      "# made by a test\nv 0 0 0\nv 1 0 0 0.5 0.5 0.5\nv 2 0 0\nv 3 0 0\no first\nl 1 2 3\n"
      "o second\nl 3/1 -1\np 4\nf 1 2 3\n"));
  ASSERT_EQ(set.polylines.size(), 2u);
  EXPECT_EQ(set.polylines[0].size(), 3u);
  EXPECT_EQ(set.polylines[1].back().x(), 3);
  ASSERT_EQ(set.points.size(), 1u);
  ExpectIoError(folder.Write("b.obj", "v 0 0 0\nl 1 2\n"), "line 2");
}

TEST(ReadCurves, TextPointsPlainAndPacked) {
  const TemporaryFolder folder;
  const std::string text = "# x y z\n1 2 3 255\n+4.0E+00,5,6\n\n";
  const CurveSet plain = ReadCurves(folder.Write("a.xyz", text));
  ASSERT_EQ(plain.points.size(), 2u);
  EXPECT_EQ(plain.points[1], Eigen::Vector3d(4, 5, 6));
  const std::string packed = folder.Path("a.txt.gz");
  gzFile file = gzopen(packed.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  EXPECT_EQ(ReadCurves(packed).points, plain.points);
  const std::string bytes = TemporaryFolder::Read(packed);
  EXPECT_THROW(ReadCurves(folder.Write("cut.txt.gz", bytes.substr(0, bytes.size() - 9))), IoError);
}

TEST(ReadCurves, PackedObj) {
  const TemporaryFolder folder;
  const std::string packed = folder.Path("a.obj.gz");
  gzFile file = gzopen(packed.c_str(), "wb");
  gzputs(file, "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\nl 2 3\n");
  gzclose(file);
  const CurveSet set = ReadCurves(packed);
  ASSERT_EQ(set.polylines.size(), 1u);
  EXPECT_EQ(set.polylines[0].back().x(), 2);
}

TEST(ReadJunctions, PositionsAndDegrees) {
  const TemporaryFolder folder;
  const std::vector<CurveNode> nodes = ReadJunctions(folder.Write(
      "j.json", R"({"set": "day", "junctions": [{"position": [1, 2.5, -3], "degree": 4}]})"));
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].position_in_world, Eigen::Vector3d(1, 2.5, -3));
  EXPECT_EQ(nodes[0].degree, 4);
  EXPECT_EQ(nodes[0].kind, JunctionKind::kUnknown);
  for (const char* bad : {"{}", R"({"junctions": [{"degree": 3}]})", "[",
                          R"({"junctions": [{"position": [1, 2], "degree": 3}]})",
                          R"({"junctions": [{"position": [1, 2, 3], "degree": 0}]})",
                          R"({"junctions": [{"position": [1, 2, 3], "degree": 3, "kind": 1}]})"}) {
    EXPECT_THROW(ReadJunctions(folder.Write("bad.json", bad)), IoError) << bad;
  }
}

TEST(ReadJunctions, Kinds) {
  const TemporaryFolder folder;
  for (const auto& [name, kind] :
       {std::pair("corner", JunctionKind::kCorner), std::pair("t", JunctionKind::kTee),
        std::pair("crossing", JunctionKind::kCrossing),
        std::pair("knot", JunctionKind::kUnknown)}) {
    const std::string text = R"({"junctions": [{"position": [1, 2, 3], "degree": 3, "kind": ")";
    const auto nodes = ReadJunctions(folder.Write("j.json", text + name + "\"}]}"));
    ASSERT_EQ(nodes.size(), 1u);
    EXPECT_EQ(nodes[0].kind, kind) << name;
  }
}

TEST(ReadCurves, PointsWithAFileOfEdges) {
  const TemporaryFolder folder;
  const std::string points = folder.Write("p.txt", "0 0 0\n1 0 0\n2 0 0\n9 9 9\n");
  const CurveSet set = ReadCurves(points, folder.Write("e.txt", " 1.0E+00\n2.0E+00\n2\n3\n2 1\n"));
  ASSERT_EQ(set.polylines.size(), 1u);
  EXPECT_EQ(set.polylines[0].size(), 3u);
  EXPECT_TRUE(set.points.empty());
  EXPECT_THROW(ReadCurves(points, folder.Write("bad.txt", "1 5")), IoError);
  EXPECT_THROW(ReadCurves(points, folder.Write("odd.txt", "1 2 3")), IoError);
}

}  // namespace
}  // namespace limn
