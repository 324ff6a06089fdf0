// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/text_curves_reader.h"

#include <cmath>

#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/formats/curve_chains.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

std::vector<Eigen::Vector3d> ReadPoints(const std::string& path) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  std::vector<Eigen::Vector3d> points;
  while (!scanner.AtEnd()) {
    if (scanner.Peek() != '#') points.push_back(scanner.Point());
    scanner.RestOfLine();
  }
  if (points.empty()) throw IoError(path, "no points");
  return points;
}

}  // namespace

CurveSet ReadTextPoints(const std::string& path) {
  CurveSet set;
  set.points = ReadPoints(path);
  return set;
}

CurveSet ReadIndexedCurves(const std::string& points_path, const std::string& edges_path) {
  EdgeSoup soup;
  soup.vertices = ReadPoints(points_path);
  soup.merge_copies = true;
  const std::string text = ReadTextFile(edges_path);
  TextScanner scanner(edges_path, text);
  const double count = static_cast<double>(soup.vertices.size());
  const auto next_index = [&] {
    const double value = scanner.Number("point index");
    if (!(value >= 1 && value <= count && value == std::floor(value))) {
      scanner.Fail("index is not one of 1.." + std::to_string(soup.vertices.size()));
    }
    return static_cast<int>(value) - 1;
  };
  while (!scanner.AtEnd()) {
    const int first = next_index();
    soup.edges.emplace_back(first, next_index());
  }
  if (soup.edges.empty()) throw IoError(edges_path, "no edges");
  CurveSet set = ChainEdges(soup);
  set.points.clear();  // points of no edge are not part of the curves
  return set;
}

}  // namespace limn
