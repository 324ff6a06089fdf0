// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/image_polylines_reader.h"

#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/model/edge_map.h"

namespace limn {
namespace {

// Shorter ones may have no length in another unit.
constexpr double kMinCurvePx = 1e-6;

double PolylineLength(const ImagePolyline& polyline) {
  double length = 0;
  for (size_t i = 1; i < polyline.size(); ++i) length += (polyline[i] - polyline[i - 1]).norm();
  return length;
}

ImagePolyline ReadImagePolyline(TextScanner* scanner, int width, int height) {
  ImagePolyline polyline;
  while (!scanner->AtEndOfLine()) {
    const double x = scanner->FiniteNumber("x");
    if (scanner->AtEndOfLine()) scanner->Fail("x without y");
    const double y = scanner->FiniteNumber("y");
    if (!IsNearImage(width, height, {x, y})) {
      scanner->Fail("point outside the image of " + std::to_string(width) + " x " +
                    std::to_string(height) + " pixels");
    }
    polyline.emplace_back(x, y);
  }
  return polyline;
}

}  // namespace

std::vector<ImagePolyline> ReadImagePolylines(const std::string& path, int width, int height) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  std::vector<ImagePolyline> polylines;
  double total = 0;
  while (!scanner.AtEnd()) {
    if (scanner.Peek() == '#') {
      scanner.RestOfLine();
      continue;
    }
    polylines.push_back(ReadImagePolyline(&scanner, width, height));
    const double length = PolylineLength(polylines.back());
    if (length < kMinCurvePx) scanner.Fail("a curve without length");
    total += length;
    if (total > static_cast<double>(width) * height) {
      scanner.Fail("curves longer than the image has pixels");
    }
  }
  return polylines;
}

}  // namespace limn
