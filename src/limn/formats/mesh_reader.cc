// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/mesh_reader.h"

#include "limn/files/whole_file.h"
#include "limn/formats/obj_reader.h"
#include "limn/formats/ply_header.h"
#include "limn/formats/ply_values.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

int FindCorners(const std::string& path, const PlyElement& element) {
  for (const char* name : {"vertex_indices", "vertex_index"}) {
    const int index = element.Find(name);
    if (index >= 0 && element.properties[index].is_list) return index;
  }
  throw IoError(path, "element face has no list vertex_indices");
}

std::vector<std::vector<int>> ReadFaces(const std::string& path, const PlyElement& element,
                                        size_t num_vertices, PlyValues* values) {
  std::vector<std::vector<int>> faces;
  const auto take = [&](const auto&, const std::vector<double>& list) {
    if (list.size() < 3) values->Fail("face of " + std::to_string(list.size()) + " corners");
    std::vector<int>& corners = faces.emplace_back();
    for (const double value : list) {
      corners.push_back(values->VertexIndex(value, num_vertices, "face"));
    }
  };
  ReadPlyRows(element, FindCorners(path, element), values, take);
  return faces;
}

FaceSoup ReadPlyFaces(const std::string& path) {
  const std::string bytes = ReadWholeFile(path, kMaxMeshBytes);
  const PlyHeader header = ParsePlyHeader(path, bytes);
  PlyValues values(path, bytes, header);
  FaceSoup result;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      result.vertices = ReadPlyVertices(path, element, &values);
    } else if (element.name == "face") {
      result.faces = ReadFaces(path, element, result.vertices.size(), &values);
    } else if (element.name == "tristrips") {
      throw IoError(path, "triangle strips are not read: store faces");
    } else {
      ReadPlyRows(element, -1, &values, [](const auto&, const auto&) {});
    }
  }
  return result;
}

FaceSoup ReadFacesOf(const std::string& path) {
  const std::string extension = FileExtension(path);
  if (extension == ".ply") return ReadPlyFaces(path);
  if (extension == ".obj") return ReadObjFaces(path);
  throw IoError(path, "unknown extension; meshes are read from .ply and .obj");
}

}  // namespace

TriangleMesh ReadMesh(const std::string& path) {
  const FaceSoup file = ReadFacesOf(path);
  if (file.faces.empty()) throw IoError(path, "has no faces");
  TriangleMesh mesh = MakeTriangleMesh(file.vertices, file.faces);
  if (mesh.polygons.empty()) throw IoError(path, "no face has an area");
  return mesh;
}

}  // namespace limn
