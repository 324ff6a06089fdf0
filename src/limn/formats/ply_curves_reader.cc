// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_curves_reader.h"

#include <algorithm>
#include <cmath>

#include "limn/files/whole_file.h"
#include "limn/formats/curve_chains.h"
#include "limn/formats/ply_header.h"
#include "limn/formats/ply_values.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kMaxLabel = 2147483647;

// The vertices; returns their radii, 0 where one is not known, or nothing if the file has none.
std::vector<double> ReadVertices(const std::string& path, const PlyElement& element,
                                 PlyValues* values, EdgeSoup* soup) {
  std::vector<double> radii;
  const int radius = element.Find("radius");
  const auto take = [&](const std::vector<double>& row, const auto&) {
    if (radius < 0) return;
    const bool is_known = row[radius] > 0 && std::isfinite(row[radius]);
    radii.push_back(is_known ? row[radius] : 0);
  };
  soup->vertices = ReadPlyVertices(path, element, values, take);
  return radii;
}

// An edge is as thick as its vertices, of which both are known, or is of unknown thickness.
double RadiusOfEdge(double radius1, double radius2) {
  return std::min(radius1, radius2) > 0 ? 0.5 * (radius1 + radius2) : 0;
}

void ReadEdges(const std::string& path, const PlyElement& element, const std::vector<double>& radii,
               PlyValues* values, EdgeSoup* soup) {
  const int vertex1 = FindPlyScalar(path, element, "vertex1");
  const int vertex2 = FindPlyScalar(path, element, "vertex2");
  const int label = element.Find("link");
  const size_t num_vertices = soup->vertices.size();
  ReadPlyRows(element, -1, values, [&](const std::vector<double>& row, const auto&) {
    soup->edges.emplace_back(values->VertexIndex(row[vertex1], num_vertices, "edge"),
                             values->VertexIndex(row[vertex2], num_vertices, "edge"));
    if (!radii.empty()) {
      const auto& [a, b] = soup->edges.back();
      soup->radii.push_back(RadiusOfEdge(radii[a], radii[b]));
    }
    if (label < 0) return;
    if (!(std::abs(row[label]) <= kMaxLabel)) values->Fail("link id out of range");
    soup->labels.push_back(static_cast<int>(row[label]));
  });
}

}  // namespace

CurveSet ReadPlyCurves(const std::string& path) {
  const std::string bytes = ReadWholeFile(path);
  const PlyHeader header = ParsePlyHeader(path, bytes);
  PlyValues values(path, bytes, header);
  EdgeSoup soup;
  std::vector<double> radii;
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      radii = ReadVertices(path, element, &values, &soup);
      has_vertices = true;
    } else if (element.name == "edge") {
      if (!has_vertices) throw IoError(path, "element edge comes before element vertex");
      ReadEdges(path, element, radii, &values, &soup);
    } else {
      ReadPlyRows(element, -1, &values, [](const auto&, const auto&) {});
    }
  }
  if (!has_vertices) throw IoError(path, "no element vertex");
  return ChainEdges(soup);
}

}  // namespace limn
