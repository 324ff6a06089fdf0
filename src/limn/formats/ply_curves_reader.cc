#include "limn/formats/ply_curves_reader.h"

#include <cmath>

#include "limn/files/whole_file.h"
#include "limn/formats/curve_chains.h"
#include "limn/formats/ply_header.h"
#include "limn/formats/ply_values.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kMaxLabel = 2147483647;

void ReadEdges(const std::string& path, const PlyElement& element, PlyValues* values,
               EdgeSoup* soup) {
  const int vertex1 = FindPlyScalar(path, element, "vertex1");
  const int vertex2 = FindPlyScalar(path, element, "vertex2");
  const int label = element.Find("link");
  const size_t num_vertices = soup->vertices.size();
  ReadPlyRows(element, -1, values, [&](const std::vector<double>& row, const auto&) {
    soup->edges.emplace_back(values->VertexIndex(row[vertex1], num_vertices, "edge"),
                             values->VertexIndex(row[vertex2], num_vertices, "edge"));
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
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      soup.vertices = ReadPlyVertices(path, element, &values);
      has_vertices = true;
    } else if (element.name == "edge") {
      if (!has_vertices) throw IoError(path, "element edge comes before element vertex");
      ReadEdges(path, element, &values, &soup);
    } else {
      ReadPlyRows(element, -1, &values, [](const auto&, const auto&) {});
    }
  }
  if (!has_vertices) throw IoError(path, "no element vertex");
  return ChainEdges(soup);
}

}  // namespace limn
