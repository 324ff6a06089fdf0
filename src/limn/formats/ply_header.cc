// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_header.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <sstream>
#include <utility>

#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

static_assert(std::endian::native == std::endian::little, "byte swapping is not written yet");

template <typename T>
double As(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return static_cast<double>(value);
}

// By PlyType, as sizes below.
constexpr double (*kDecoders[])(const char* bytes) = {
    As<int8_t>,  As<uint8_t>,  As<int16_t>, As<uint16_t>,
    As<int32_t>, As<uint32_t>, As<float>,   As<double>,
};
constexpr size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", PlyType::kInt8},
                                                  {"int8", PlyType::kInt8},
                                                  {"uchar", PlyType::kUint8},
                                                  {"uint8", PlyType::kUint8},
                                                  {"short", PlyType::kInt16},
                                                  {"int16", PlyType::kInt16},
                                                  {"ushort", PlyType::kUint16},
                                                  {"uint16", PlyType::kUint16},
                                                  {"int", PlyType::kInt32},
                                                  {"int32", PlyType::kInt32},
                                                  {"uint", PlyType::kUint32},
                                                  {"uint32", PlyType::kUint32},
                                                  {"float", PlyType::kFloat32},
                                                  {"float32", PlyType::kFloat32},
                                                  {"double", PlyType::kFloat64},
                                                  {"float64", PlyType::kFloat64}}};

// Far more than any program writes: splats have some sixty properties.
constexpr size_t kMaxElements = 256;
constexpr size_t kMaxProperties = 4096;  // of an element

class HeaderParser {
 public:
  HeaderParser(std::string path, std::string_view bytes)
      : path_(std::move(path)),
        bytes_(bytes.substr(0, kMaxPlyHeaderBytes)),
        is_cut_(bytes.size() > kMaxPlyHeaderBytes) {}

  PlyHeader Run() {
    if (NextLine() != "ply") Fail("not a PLY file");
    bool has_format = false;
    while (true) {
      std::istringstream line{std::string(NextLine())};
      std::string keyword;
      line >> keyword;
      if (keyword == "end_header") break;
      if (keyword == "format") {
        ParseFormat(&line);
        has_format = true;
      } else if (keyword == "element") {
        ParseElement(&line);
      } else if (keyword == "property") {
        ParseProperty(&line);
      } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
        Fail("unknown keyword \"" + keyword.substr(0, 40) + "\"");
      }
    }
    if (!has_format) Fail("no format line");
    header_.data_offset = at_;
    return std::move(header_);
  }

 private:
  [[noreturn]] void Fail(const std::string& reason) const {
    throw IoError(path_, "line " + std::to_string(header_.num_lines), reason);
  }

  std::string_view NextLine() {
    const size_t end = bytes_.find('\n', at_);
    ++header_.num_lines;
    if (end == std::string_view::npos) {
      Fail(is_cut_ ? "the header has more than " + std::to_string(kMaxPlyHeaderBytes) + " bytes"
                   : "the file ends within the header");
    }
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }

  void ParseFormat(std::istringstream* line) {
    std::string name, version;
    *line >> name >> version;
    if (name == "ascii") {
      header_.format = PlyHeader::Format::kAscii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyHeader::Format::kLittleEndian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyHeader::Format::kBigEndian;
    } else {
      Fail("unknown format \"" + name.substr(0, 40) + "\"");
    }
    if (version != "1.0") Fail("unknown version \"" + version.substr(0, 40) + "\"");
  }

  void ParseElement(std::istringstream* line) {
    PlyElement element;
    std::string count;
    *line >> element.name >> count;
    const auto number = ParseNumber<decltype(element.count)>(count);
    if (!number) Fail("element needs a name and a count");
    element.count = *number;
    // Readers keep what belongs together from element to element.
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) {
        Fail("element " + element.name.substr(0, 40) + " is there twice");
      }
    }
    if (header_.elements.size() == kMaxElements) {
      Fail("more than " + std::to_string(kMaxElements) + " elements");
    }
    header_.elements.push_back(std::move(element));
  }

  PlyType ParseType(const std::string& name) const {
    for (const TypeName& candidate : kTypeNames) {
      if (candidate.name == name) return candidate.type;
    }
    Fail("unknown type \"" + name.substr(0, 40) + "\"");
  }

  void ParseProperty(std::istringstream* line) {
    if (header_.elements.empty()) Fail("property before the first element");
    PlyProperty property;
    std::string type;
    *line >> type;
    if (type == "list") {
      std::string count_type;
      property.is_list = true;
      *line >> count_type >> type;
      property.count_type = ParseType(count_type);
    }
    property.type = ParseType(type);
    if (!(*line >> property.name)) Fail("property without a name");
    auto& properties = header_.elements.back().properties;
    if (properties.size() == kMaxProperties) {
      Fail("an element has more than " + std::to_string(kMaxProperties) + " properties");
    }
    properties.push_back(std::move(property));
  }

  std::string path_;
  std::string_view bytes_;
  bool is_cut_;
  size_t at_ = 0;
  PlyHeader header_;
};

}  // namespace

size_t PlyTypeSize(PlyType type) { return kSizes[static_cast<int>(type)]; }

double PlyValue(PlyType type, const char* bytes, bool swap) {
  const auto decode = kDecoders[static_cast<int>(type)];
  if (!swap) return decode(bytes);
  char swapped[8];
  std::reverse_copy(bytes, bytes + PlyTypeSize(type), swapped);
  return decode(swapped);
}

int PlyElement::Find(std::string_view property_name) const {
  for (size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property_name) return static_cast<int>(i);
  }
  return -1;
}

PlyHeader ParsePlyHeader(const std::string& path, std::string_view bytes) {
  return HeaderParser(path, bytes).Run();
}

}  // namespace limn
