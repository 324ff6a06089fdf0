// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_mover.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"
#include "support/random_numbers.h"

namespace limn {
namespace {

using ::testing::HasSubstr;

enum class Bytes { kText, kLittle, kBig };

// Puts values of a PLY file.
class PlyPen {
 public:
  explicit PlyPen(Bytes bytes) : bytes_(bytes) {}

  template <typename T>
  void Put(T value) {
    if (bytes_ == Bytes::kText) {
      char text[40];
      if constexpr (sizeof(T) == 1) {
        at_ += std::to_string(static_cast<int>(value)) + " ";
      } else {
        at_.append(text, std::to_chars(text, text + sizeof(text), value).ptr) += " ";
      }
      return;
    }
    char stored[sizeof(T)];
    std::memcpy(stored, &value, sizeof(T));
    if (bytes_ == Bytes::kBig) std::reverse(stored, stored + sizeof(T));
    at_.append(stored, sizeof(T));
  }
  void EndRow() {
    if (bytes_ == Bytes::kText) at_ += "\n";
  }
  const std::string& text() const { return at_; }

 private:
  Bytes bytes_;
  std::string at_;
};

const char* NameOf(Bytes bytes) {
  if (bytes == Bytes::kText) return "ascii";
  return bytes == Bytes::kLittle ? "binary_little_endian" : "binary_big_endian";
}

struct MeshVertex {
  Eigen::Vector3d position, normal;
};

// With elements before and after the vertices, and with lists.
template <typename Real>
std::string MeshFile(Bytes bytes, const std::vector<MeshVertex>& vertices, size_t num_faces,
                     const std::string& comment = "") {
  const std::string real = sizeof(Real) == 4 ? "float" : "double";
  const std::string header =
      std::string("ply\nformat ") + NameOf(bytes) + " 1.0\n" + comment +
      "comment of a mesher\nelement camera 2\nproperty list uchar float x\nproperty short y\n"
      "element vertex " +
      std::to_string(vertices.size()) + "\nproperty uchar red\nproperty " + real + " z\nproperty " +
      real + " x\nproperty float nx\nproperty float ny\nproperty float nz\nproperty " + real +
      " y\nproperty int label\nelement face " + std::to_string(num_faces) +
      "\nproperty uchar flags\nproperty list uint int vertex_indices\nproperty float weight\n"
      "end_header\n";
  PlyPen pen(bytes);
  for (int camera = 0; camera < 2; ++camera) {
    pen.Put<uint8_t>(camera);
    if (camera == 1) pen.Put(2.5F);
    pen.Put<int16_t>(-7);
    pen.EndRow();
  }
  for (size_t i = 0; i < vertices.size(); ++i) {
    const auto& [position, normal] = vertices[i];
    pen.Put<uint8_t>(i % 256);
    pen.Put(static_cast<Real>(position.z()));
    pen.Put(static_cast<Real>(position.x()));
    for (const double value : normal) pen.Put(static_cast<float>(value));
    pen.Put(static_cast<Real>(position.y()));
    pen.Put<int32_t>(static_cast<int32_t>(i) - 5);
    pen.EndRow();
  }
  for (size_t i = 0; i < num_faces; ++i) {
    pen.Put<uint8_t>(9);
    pen.Put<uint32_t>(3 + i % 3);
    for (uint32_t k = 0; k < 3 + i % 3; ++k) pen.Put<int32_t>(static_cast<int32_t>(i + k));
    pen.Put(0.125F);
    pen.EndRow();
  }
  return header + pen.text();
}

// Of numbers that are exact in all formats.
std::vector<MeshVertex> AnyVertices(size_t count) {
  std::mt19937 random(3);
  testing::NormalDistribution<double> normal;
  std::vector<MeshVertex> vertices(count);
  for (MeshVertex& vertex : vertices) {
    for (double& value : vertex.position) value = std::round(640 * normal(random)) / 64;
    for (double& value : vertex.normal) value = std::round(64 * normal(random)) / 64;
  }
  return vertices;
}

const Similarity3d& AnySimilarity() {
  static const Similarity3d similarity = {
      2.5,
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix(),
      {30, -4, 12}};
  return similarity;
}

std::vector<MeshVertex> MovedVertices(std::vector<MeshVertex> vertices) {
  for (MeshVertex& vertex : vertices) {
    vertex.position = AnySimilarity() * vertex.position;
    vertex.normal = AnySimilarity().rotation * vertex.normal;
  }
  return vertices;
}

std::string MovedFile(const std::string& path, const std::string& comment = "") {
  std::ostringstream out;
  MovePly(path, AnySimilarity(), comment, out);
  return out.str();
}

template <typename Real>
void ExpectMoved(size_t num_vertices, size_t num_faces) {
  const TemporaryFolder folder;
  const std::vector<MeshVertex> vertices = AnyVertices(num_vertices);
  for (const Bytes bytes : {Bytes::kText, Bytes::kLittle, Bytes::kBig}) {
    const std::string path = folder.Write("mesh.ply", MeshFile<Real>(bytes, vertices, num_faces));
    // Not by EXPECT_EQ, which would print megabytes.
    EXPECT_TRUE(MovedFile(path, "offset 1 2 3") ==
                MeshFile<Real>(bytes, MovedVertices(vertices), num_faces, "comment offset 1 2 3\n"))
        << NameOf(bytes) << " " << sizeof(Real);
  }
}

TEST(PlyMover, PositionsAndNormalsMoveAndAllElseStays) {
  ExpectMoved<float>(9, 5);
  ExpectMoved<double>(9, 5);
  ExpectMoved<double>(0, 0);
}

// Several windows on the file, whose ends are within rows.
TEST(PlyMover, LargeFilesAreMovedPartByPart) { ExpectMoved<float>(400'000, 300'000); }

TEST(PlyMover, WhatFollowsTheLastElementStays) {
  const TemporaryFolder folder;
  const std::string path =
      folder.Write("a.ply", MeshFile<float>(Bytes::kLittle, AnyVertices(1), 1) + "more");
  EXPECT_TRUE(MovedFile(path).ends_with("more"));
}

TEST(PlyMover, TextKeepsItsBlanksAndLineEnds) {
  const TemporaryFolder folder;
  const std::string header =
      "ply\r\nformat ascii 1.0\r\nelement vertex 2\r\nproperty float x\r\nproperty float y\r\n"
      "property float z\r\nproperty uchar red\r\nend_header\r\n";
  const std::string path = folder.Write("a.ply", header + "\t1  0 0   255\r\n\r\n0 1 0 0");
  std::ostringstream out;
  MovePly(path, {2, Eigen::Matrix3d::Identity(), {0, 0, 0.1}}, "offset 5 6 7", out);
  std::string expected = header + "\t2  0 0.1   255\r\n\r\n0 2 0.1 0";
  expected.insert(expected.find("element"), "comment offset 5 6 7\r\n");
  EXPECT_EQ(out.str(), expected);
}

TEST(PlyMover, FilesCutAnywhereAreRefused) {
  const TemporaryFolder folder;
  for (const Bytes bytes : {Bytes::kText, Bytes::kLittle, Bytes::kBig}) {
    const std::string whole = MeshFile<float>(bytes, AnyVertices(2), 2);
    // The last number of a text may be cut unnoticed, and its end.
    const size_t least = bytes == Bytes::kText ? std::string("0.125 \n").size() : 0;
    for (size_t length = 0; length + least < whole.size(); ++length) {
      const std::string path = folder.Write("cut.ply", whole.substr(0, length));
      EXPECT_THROW(MovedFile(path), IoError) << NameOf(bytes) << " " << length;
    }
  }
}

TEST(PlyMover, WhatCannotBeMovedIsNamed) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& bytes) {
    const std::string path = folder.Write("a.ply", bytes);
    try {
      MovedFile(path);
    } catch (const IoError& caught) {
      return std::string(caught.what()).substr(path.size());
    }
    return std::string("nothing");
  };
  const auto text = [](const char* type, const std::string& rows) {
    std::string header = "ply\nformat ascii 1.0\nelement vertex 2\n";
    for (const char* axis : {"x", "y", "z"}) {
      header += std::string("property ") + type + " " + axis + "\n";
    }
    return header + "end_header\n" + rows;
  };
  EXPECT_EQ(error(text("float", "0 0 0\n0 nan 0\n")), ": line 9: coordinate not finite");
  EXPECT_EQ(error(text("float", "0 0 0\n0 0 3e38\n")), ": line 9: coordinate too large once moved");
  EXPECT_EQ(error(text("double", "0 0 0\n0 0 3e38\n")), "nothing");
  EXPECT_EQ(error(text("float", "0 0 0\n0 a 0\n")), ": line 9: \"a\" is not a number");
  EXPECT_EQ(error(text("float", "0 0 0\n0 0\n")), ": line 9: too few numbers");
  EXPECT_EQ(error(text("float", "0 0 0\n")), ": line 9: the file ends too early");
  EXPECT_EQ(error(text("float", "0 0 0\n" + std::string(5'000'000, ' '))),
            ": line 9: a line is too long");
  EXPECT_EQ(error(text("int", "0 0 0\n0 0 0\n")), ": x of the vertices is an integer");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n"),
            ": element vertex has no property y");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement face 0\nend_header\n"),
            ": has no element vertex");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                  "property float z\nproperty list int int v\nend_header\n0 0 0 0\n"),
            ": vertices with the list v");
  std::vector<MeshVertex> vertices = AnyVertices(3);
  vertices[2].position.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error(MeshFile<float>(Bytes::kBig, vertices, 1)), ": vertex 2: coordinate not finite");
  vertices = AnyVertices(3);
  std::string cut = MeshFile<float>(Bytes::kLittle, vertices, 4);
  cut.resize(cut.size() - 2);
  EXPECT_EQ(error(cut), ": face 3: the file ends too early");
}

// Some clouds have these.
TEST(PlyMover, NormalsMayBeNoNumbers) {
  const TemporaryFolder folder;
  std::vector<MeshVertex> vertices = AnyVertices(2);
  vertices[1].normal.setConstant(std::numeric_limits<double>::quiet_NaN());
  const std::string path = folder.Write(
      "moved.ply", MovedFile(folder.Write("a.ply", MeshFile<double>(Bytes::kLittle, vertices, 0))));
  EXPECT_THAT(TemporaryFolder::Read(path), HasSubstr("element vertex 2"));
}

}  // namespace
}  // namespace limn
