// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/mesh_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

const char kVertices[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\n";
const char kFaces[] = "element face 2\nproperty uchar flags\nproperty list uchar int ";
const char kPositions[] = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

void ExpectMeshError(const std::string& path, const std::string& part) {
  try {
    ReadMesh(path);
    FAIL() << path << " was accepted";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(path));
    EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
  }
}

TEST(ReadMesh, PlyWithPolygonsAndOtherProperties) {
  const TemporaryFolder folder;
  for (const char* name : {"vertex_indices", "vertex_index"}) {
    const TriangleMesh mesh = ReadMesh(folder.Write(
        "a.ply", std::string(kVertices) + kFaces + name +
                     "\nproperty list uchar float texcoord\nelement edge 1\nproperty int vertex1\n"
                     "property int vertex2\nend_header\n" +
                     kPositions + "7 3 0 1 2 2 0.5 0.5\n8 4 0 1 2 3 0\n0 1\n"));
    EXPECT_EQ(mesh.vertices.size(), 4u);
    EXPECT_EQ(mesh.polygons, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 1, 2, 3}}));
    EXPECT_EQ(mesh.triangles.size(), 3u);
  }
}

TEST(ReadMesh, BinaryPlyCutAnywhereIsRefused) {
  const TemporaryFolder folder;
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\n"
      "property char z\nelement face 1\nproperty list uchar ushort vertex_indices\nend_header\n";
  bytes += std::string({0, 0, 0, 1, 0, 0, 0, 1, 0});
  bytes += std::string({3, 0, 0, 0, 1, 0, 2});
  EXPECT_EQ(ReadMesh(folder.Write("whole.ply", bytes)).polygons,
            (std::vector<std::vector<int>>{{0, 1, 2}}));
  for (size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(ReadMesh(folder.Write("cut.ply", bytes.substr(0, length))), IoError) << length;
  }
}

TEST(ReadMesh, ObjWithEveryFormOfCorner) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = ReadMesh(
      folder.Write("a.obj",
                   "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvn 0 0 1\nvt 0 0\no part\nusemtl red\n"
                   "f 1/1/1 2//1 3/1\nv 0 0 0\nv 0 1 0\nl 1 2\nf -2 -3 -1\n"));
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.polygons, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadMesh, BadFilesAreRefusedWithPlaceAndReason) {
  const TemporaryFolder folder;
  const std::string head = std::string(kVertices) + kFaces + "vertex_indices\nend_header\n";
  ExpectMeshError(folder.Write("1.ply", std::string(kVertices) + "end_header\n" + kPositions),
                  "no faces");
  ExpectMeshError(folder.Write("2.ply", head + "0 0 0\n1 nan 0\n1 1 0\n0 1 0\n"), "not finite");
  ExpectMeshError(folder.Write("3.ply", head + kPositions + "0 3 0 1 4\n0 3 0 1 2\n"),
                  "line 15: face to vertex 4.000000 of 4");
  ExpectMeshError(folder.Write("4.ply", head + kPositions + "0 3 0 1 -1\n0 3 0 1 2\n"), "face to");
  ExpectMeshError(folder.Write("5.ply", head + kPositions + "0 2 0 1\n0 3 0 1 2\n"),
                  "face of 2 corners");
  ExpectMeshError(folder.Write("6.ply", head + kPositions + "0 3 0 1 1\n0 3 0 0 2\n"),
                  "no face has an area");
  ExpectMeshError(
      folder.Write("7.ply", std::string(kVertices) + kFaces + "corners\nend_header\n" + kPositions),
      "no list vertex_indices");
  ExpectMeshError(folder.Write("8.ply", std::string(kVertices) +
                                            "element tristrips 1\nproperty list int int "
                                            "vertex_indices\nend_header\n" +
                                            kPositions + "3 0 1 2\n"),
                  "strips");
  ExpectMeshError(folder.Write("9.obj", "v 0 0 0\nl 1 1\n"), "no faces");
  ExpectMeshError(folder.Write("10.obj", "v 0 0 0\nv 1 0 inf\nf 1 2 1\n"), "line 2");
  ExpectMeshError(folder.Write("11.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4\n"), "line 4");
  ExpectMeshError(folder.Write("12.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n"), "face of 2 corners");
  ExpectMeshError(folder.Write("13.stl", "solid"), "unknown extension");
  ExpectMeshError(folder.Path("absent.obj"), "No such file");
}

}  // namespace
}  // namespace limn
