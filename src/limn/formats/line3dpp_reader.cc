// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/line3dpp_reader.h"

#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"

namespace limn {
namespace {

constexpr int kNumbersOfSegment2d = 6;

void AddSegment(const Eigen::Vector3d& start, const Eigen::Vector3d& end, CurveSet* set) {
  if (start != end) set->polylines.push_back({start, end});
}

void ExpectWord(const std::string& word, TextScanner* scanner) {
  const std::string found(scanner->Word(word.c_str()));
  if (found != word) scanner->Fail(word + " expected, not \"" + found.substr(0, 40) + "\"");
}

Eigen::Vector3d StlVertex(TextScanner* scanner) {
  ExpectWord("vertex", scanner);
  return scanner->Point();
}

void ReadFacet(TextScanner* scanner, CurveSet* set) {
  ExpectWord("normal", scanner);
  scanner->Point();
  ExpectWord("outer", scanner);
  ExpectWord("loop", scanner);
  const Eigen::Vector3d first = StlVertex(scanner);
  const Eigen::Vector3d second = StlVertex(scanner);
  if (StlVertex(scanner) != first) {
    scanner->Fail("a facet with an area: only segments, as Line3D++ writes them, are curves");
  }
  ExpectWord("endloop", scanner);
  ExpectWord("endfacet", scanner);
  AddSegment(first, second, set);
}

}  // namespace

CurveSet ReadLine3dppText(const std::string& path) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  CurveSet set;
  while (!scanner.AtEnd()) {
    const int num_segments = scanner.Count("number of segments");
    for (int i = 0; i < num_segments; ++i) {
      const Eigen::Vector3d start = scanner.Point();
      AddSegment(start, scanner.Point(), &set);
    }
    const int num_images = scanner.Count("number of 2D segments");
    for (int i = 0; i < num_images; ++i) {
      for (int k = 0; k < kNumbersOfSegment2d; ++k) scanner.FiniteNumber("2D segment");
    }
    if (!scanner.AtEndOfLine()) scanner.Fail("more numbers than announced");
  }
  return set;
}

CurveSet ReadLine3dppStl(const std::string& path) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  ExpectWord("solid", &scanner);
  scanner.RestOfLine();
  CurveSet set;
  std::string_view word = scanner.Word("facet or endsolid");
  for (; word == "facet"; word = scanner.Word("facet or endsolid")) ReadFacet(&scanner, &set);
  if (word != "endsolid") {
    scanner.Fail("facet expected, not \"" + std::string(word.substr(0, 40)) + "\"");
  }
  return set;
}

}  // namespace limn
