// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/cem_file.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/formats/check_edgel.h"
#include "limn/util/number_text.h"

namespace limn {
namespace {

// Brackets and '=' are decoration: blanks instead make every line plain words.
std::string WithoutDecoration(std::string text) {
  for (char& c : text) {
    if (c == '[' || c == ']' || c == '(' || c == ')' || c == '=') c = ' ';
  }
  return text;
}

void SkipComments(TextScanner* scanner) {
  while (!scanner->AtEnd() && scanner->Peek() == '#') scanner->RestOfLine();
}

void Expect(TextScanner* scanner, const char* word) {
  if (scanner->Word(word) != word) scanner->Fail(std::string("expected ") + word);
}

Edgel ReadEdgel(TextScanner* scanner, const EdgeMap& map) {
  Edgel edgel;
  edgel.position_px.x() = scanner->Number("x");
  edgel.position_px.y() = scanner->Number("y");
  edgel.tangent_rad = std::remainder(scanner->Number("direction"), 2 * M_PI);
  edgel.strength = static_cast<float>(scanner->Number("strength"));
  scanner->Number("second derivative");
  if (!scanner->AtEndOfLine()) {
    edgel.position_sigma_px = static_cast<float>(scanner->Number("uncertainty"));
  }
  CheckEdgel(*scanner, edgel, map.width, map.height);
  edgel.stored_px = edgel.position_px.cast<float>();
  return edgel;
}

// Takes the length from that which all fragments may have together; an edgel has a pixel at least.
CurveFragment ReadFragment(TextScanner* scanner, const std::vector<Edgel>& edgels,
                           double* max_length_px) {
  CurveFragment fragment;
  if (scanner->AtEnd()) scanner->Fail("the file ends before its last contour");
  while (!scanner->AtEndOfLine()) {
    const int id = scanner->Count("edgel id");
    if (static_cast<size_t>(id) >= edgels.size()) scanner->Fail("edgel id out of range");
    const EdgelId last = fragment.edgel_ids.empty() ? id : fragment.edgel_ids.back();
    *max_length_px -= std::max(1.0, (edgels[id].position_px - edgels[last].position_px).norm());
    if (*max_length_px < 0) scanner->Fail("contours longer than the image has pixels");
    fragment.edgel_ids.push_back(id);
  }
  if (fragment.edgel_ids.size() > 2 && fragment.edgel_ids.front() == fragment.edgel_ids.back()) {
    fragment.closed = true;
    fragment.edgel_ids.pop_back();
  }
  return fragment;
}

double MeanStrength(const ImageCurves& curves, const CurveFragment& fragment) {
  double sum = 0;
  for (const EdgelId id : fragment.edgel_ids) sum += curves.edge_map.edgels[id].strength;
  return fragment.edgel_ids.empty() ? 0 : sum / static_cast<double>(fragment.edgel_ids.size());
}

}  // namespace

ImageCurves ReadCem(const std::string& path) {
  const std::string text = WithoutDecoration(ReadTextFile(path));
  TextScanner scanner(path, text);
  Expect(&scanner, ".CEM");
  Expect(&scanner, "v2.0");
  ImageCurves curves;
  SkipComments(&scanner);
  Expect(&scanner, "size");
  curves.edge_map.width = scanner.Count("width");
  curves.edge_map.height = scanner.Count("height");
  Expect(&scanner, "Edgemap");
  Expect(&scanner, "count");
  const int num_edgels = scanner.Count("number of edgels");
  for (int i = 0; i < num_edgels; ++i) {
    curves.edge_map.edgels.push_back(ReadEdgel(&scanner, curves.edge_map));
  }
  Expect(&scanner, "Contours");
  Expect(&scanner, "count");
  const int num_fragments = scanner.Count("number of contours");
  double max_length_px = static_cast<double>(curves.edge_map.width) * curves.edge_map.height;
  for (int i = 0; i < num_fragments; ++i) {
    curves.fragments.push_back(ReadFragment(&scanner, curves.edge_map.edgels, &max_length_px));
  }
  // Without this a file cut within its last contour would look whole.
  Expect(&scanner, "Contour");
  Expect(&scanner, "Properties");
  return curves;
}

void WriteCem(const ImageCurves& curves, std::ostream& out) {
  out << ".CEM v2.0\n# Curve fragments by limn\nsize=[" << curves.edge_map.width << ' '
      << curves.edge_map.height << "]\n[Edgemap]\ncount=" << curves.edge_map.edgels.size() << '\n';
  for (const Edgel& edgel : curves.edge_map.edgels) {
    out << '(' << NumberText(edgel.position_px.x()) << ", " << NumberText(edgel.position_px.y())
        << ")\t" << NumberText(edgel.tangent_rad) << '\t' << NumberText(edgel.strength) << "\t0\t"
        << NumberText(edgel.position_sigma_px) << '\n';
  }
  out << "[Contours]\ncount=" << curves.fragments.size() << '\n';
  for (const CurveFragment& fragment : curves.fragments) {
    out << '[';
    for (const EdgelId id : fragment.edgel_ids) out << id << ' ';
    if (fragment.closed && !fragment.edgel_ids.empty()) out << fragment.edgel_ids.front() << ' ';
    out << "]\n";
  }
  out << "[Contour Properties]\n"
         "# <len> <avg. str> <mean con> <Lstd> <Rstd> <avg. d2f> <avg. k> <max k>\n";
  for (const CurveFragment& fragment : curves.fragments) {
    out << fragment.edgel_ids.size() << ' ' << NumberText(MeanStrength(curves, fragment))
        << " 0 0 0 0 0 0\n";
  }
}

}  // namespace limn
