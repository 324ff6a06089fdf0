// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/edg_file.h"

#include <cmath>
#include <optional>
#include <ostream>

#include "limn/files/text_file.h"
#include "limn/files/text_scanner.h"
#include "limn/formats/check_edgel.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

constexpr double kTwoPi = 2 * 3.14159265358979323846;
constexpr int kMaxImageSize = 1 << 20;

// The file's brackets are decoration: blanks instead make a line plain numbers.
std::string WithoutBrackets(std::string text) {
  for (char& c : text) {
    if (c == '[' || c == ']') c = ' ';
  }
  return text;
}

std::optional<double> ValueOf(const TextScanner& scanner, std::string_view line,
                              std::string_view key) {
  if (!line.starts_with(key)) return std::nullopt;
  line.remove_prefix(key.size());
  const auto value = ParseNumber<double>(line.substr(0, line.find_first_of(" \t\r")));
  if (!value) scanner.Fail("no number after " + std::string(key));
  return value;
}

struct EdgHeader {
  int width = -1;
  int height = -1;
  size_t count = 0;
  bool has_uncertainty = false;
};

void SetSize(const TextScanner& scanner, double value, int* size) {
  if (!(value > 0 && value <= kMaxImageSize)) scanner.Fail("impossible image size");
  *size = static_cast<int>(value);
}

// Comments and keys, up to and with EDGE_COUNT.
EdgHeader ReadHeader(TextScanner* scanner) {
  EdgHeader header;
  bool is_first = true;
  while (!scanner->AtEnd()) {
    const std::string_view line = scanner->RestOfLine();
    if (is_first && !line.starts_with("# EDGE_MAP")) scanner->Fail("not an edge map");
    if (is_first) header.has_uncertainty = line.find("v3") != std::string_view::npos;
    is_first = false;
    if (const auto width = ValueOf(*scanner, line, "WIDTH=")) {
      SetSize(*scanner, *width, &header.width);
    }
    if (const auto height = ValueOf(*scanner, line, "HEIGHT=")) {
      SetSize(*scanner, *height, &header.height);
    }
    if (const auto count = ValueOf(*scanner, line, "EDGE_COUNT=")) {
      if (header.width < 0 || header.height < 0) scanner->Fail("no WIDTH and HEIGHT");
      if (!(*count >= 0 && *count <= 1e9)) scanner->Fail("impossible EDGE_COUNT");
      header.count = static_cast<size_t>(*count);
      return header;
    }
  }
  scanner->Fail("no EDGE_COUNT");
}

Edgel ReadEdgel(TextScanner* scanner, const EdgHeader& header) {
  if (scanner->AtEnd()) scanner->Fail("the file ends before its last edgel");
  if (scanner->Peek() == 'E') {  // "EDGE :" in old versions
    scanner->Word("EDGE");
    scanner->Word(":");
  }
  for (int i = 0; i < 4; ++i) scanner->Number("pixel of an edgel");
  Edgel edgel;
  edgel.position_px.x() = scanner->Number("x");
  edgel.position_px.y() = scanner->Number("y");
  edgel.tangent_rad = std::remainder(scanner->Number("direction"), kTwoPi);
  edgel.strength = static_cast<float>(scanner->Number("strength"));
  if (header.has_uncertainty) {
    edgel.position_sigma_px = static_cast<float>(scanner->Number("uncertainty"));
  }
  CheckEdgel(*scanner, edgel, header.width, header.height);
  edgel.stored_px = edgel.position_px.cast<float>();
  if (!scanner->AtEndOfLine()) scanner->Fail("more numbers than an edgel has");
  return edgel;
}

}  // namespace

EdgeMap ReadEdg(const std::string& path) {
  const std::string text = WithoutBrackets(ReadTextFile(path));
  TextScanner scanner(path, text);
  const EdgHeader header = ReadHeader(&scanner);
  EdgeMap map;
  map.width = header.width;
  map.height = header.height;
  for (size_t i = 0; i < header.count; ++i) {
    map.edgels.push_back(ReadEdgel(&scanner, header));
  }
  if (!scanner.AtEnd()) scanner.Fail("more edgels than EDGE_COUNT says");
  return map;
}

void WriteEdg(const EdgeMap& edge_map, std::ostream& out) {
  out << "# EDGE_MAP v3.0\n\n"
         "# Format :  [Pixel_Pos]  Pixel_Dir Pixel_Conf  [Sub_Pixel_Pos] Sub_Pixel_Dir Strength "
         "Uncer, by limn\n\n"
      << "WIDTH=" << edge_map.width << "\nHEIGHT=" << edge_map.height
      << "\nEDGE_COUNT=" << edge_map.edgels.size() << "\n\n\n";
  for (const Edgel& edgel : edge_map.edgels) {
    const Eigen::Vector2d& position = edgel.position_px;
    const std::string direction_and_strength =
        NumberText(edgel.tangent_rad) + ' ' + NumberText(edgel.strength);
    out << '[' << std::lround(position.x()) << ", " << std::lround(position.y()) << "]    "
        << direction_and_strength << "   [" << NumberText(position.x()) << ", "
        << NumberText(position.y()) << "]   " << direction_and_strength << ' '
        << NumberText(edgel.position_sigma_px) << '\n';
  }
}

}  // namespace limn
