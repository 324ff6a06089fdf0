// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/obj_reader.h"

#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/formats/curve_chains.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

class ObjParser {
 public:
  // Statements that are not asked for are passed over.
  ObjParser(TextScanner* scanner, bool curves, bool faces)
      : scanner_(scanner), wants_curves_(curves), wants_faces_(faces) {}

  CurveSet Curves() {
    ParseAll();
    CurveSet set = ChainEdges(soup_);
    if (has_elements_) set.points = std::move(points_);
    return set;
  }

  std::optional<Wireframe> Edges(bool may_lack_edges) {
    ParseAll();
    if (has_others_ || (soup_.edges.empty() && !may_lack_edges)) return std::nullopt;
    return Wireframe{std::move(soup_.vertices), std::move(soup_.edges)};
  }

  FaceSoup Faces() {
    ParseAll();
    return {std::move(soup_.vertices), std::move(faces_)};
  }

 private:
  void ParseAll() {
    while (!scanner_->AtEnd()) ParseStatement(scanner_->Word("statement"));
  }

  void ParseStatement(std::string_view keyword) {
    if (keyword == "v") {
      soup_.vertices.push_back(scanner_->Point());
    } else if (wants_curves_ && keyword == "l") {
      ParseLine();
    } else if (wants_curves_ && keyword == "p") {
      has_elements_ = has_others_ = true;
      while (!scanner_->AtEndOfLine()) points_.push_back(soup_.vertices[VertexIndex()]);
    } else if (wants_faces_ && keyword == "f") {
      ParseFace();
    } else if (keyword == "f") {
      has_others_ = true;
    } else if (keyword == "o" || keyword == "g") {
      ++label_;
    }
    scanner_->RestOfLine();
  }

  void ParseLine() {
    has_elements_ = true;
    int previous = -1;
    for (int count = 1; !scanner_->AtEndOfLine(); ++count) {
      const int index = VertexIndex();
      has_others_ = has_others_ || count > 2;
      if (previous >= 0) {
        soup_.edges.emplace_back(previous, index);
        soup_.labels.push_back(label_);
      }
      previous = index;
    }
  }

  void ParseFace() {
    std::vector<int> corners;
    while (!scanner_->AtEndOfLine()) corners.push_back(VertexIndex());
    if (corners.size() < 3) {
      scanner_->Fail("face of " + std::to_string(corners.size()) + " corners");
    }
    faces_.push_back(std::move(corners));
  }

  // "7", "7/3" or relative to the end "-1"; counts from 1.
  int VertexIndex() {
    const std::string_view word = scanner_->Word("vertex index");
    long value = ParseNumber<long>(word.substr(0, word.find('/'))).value_or(0);
    const long count = static_cast<long>(soup_.vertices.size());
    if (value < 0) value += count + 1;
    if (value < 1 || value > count) {
      std::string reason = "vertex index \"";
      reason.append(word.substr(0, 40)).append("\" is none of the ");
      scanner_->Fail(reason + std::to_string(count) + " vertices so far");
    }
    return static_cast<int>(value - 1);
  }

  TextScanner* scanner_;
  bool wants_curves_;
  bool wants_faces_;
  EdgeSoup soup_;
  std::vector<std::vector<int>> faces_;
  std::vector<Eigen::Vector3d> points_;
  int label_ = 0;
  bool has_elements_ = false;
  bool has_others_ = false;  // than vertices and lines of two: no wireframe
};

}  // namespace

CurveSet ReadObjCurves(const std::string& path) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  return ObjParser(&scanner, /*curves=*/true, /*faces=*/false).Curves();
}

std::optional<Wireframe> ReadObjWireframe(const std::string& path, bool may_lack_edges) {
  const std::string text = ReadTextFile(path);
  TextScanner scanner(path, text);
  return ObjParser(&scanner, /*curves=*/true, /*faces=*/false).Edges(may_lack_edges);
}

FaceSoup ReadObjFaces(const std::string& path) {
  const std::string text = ReadTextFile(path, kMaxMeshBytes);
  TextScanner scanner(path, text);
  return ObjParser(&scanner, /*curves=*/false, /*faces=*/true).Faces();
}

}  // namespace limn
