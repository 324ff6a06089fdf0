// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

enum class PlyType { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

size_t PlyTypeSize(PlyType type);

// The number stored in bytes of a little-endian file, or with `swap` of a big-endian one.
double PlyValue(PlyType type, const char* bytes, bool swap);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat32;
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  // of a list
};

struct PlyElement {
  std::string name;
  size_t count = 0;
  std::vector<PlyProperty> properties;

  // Index of the property of that name, or -1.
  int Find(std::string_view property_name) const;
};

struct PlyHeader {
  enum class Format { kAscii, kLittleEndian, kBigEndian };
  Format format = Format::kAscii;
  std::vector<PlyElement> elements;
  size_t data_offset = 0;  // of the first byte after the header
  int num_lines = 0;
};

constexpr size_t kMaxPlyHeaderBytes = 1 << 20;

// Throws IoError with path, line and reason; also if the header has more than 1 MB, 256 elements or
// 4,096 properties of an element. Only so many bytes are looked at.
PlyHeader ParsePlyHeader(const std::string& path, std::string_view bytes);

}  // namespace limn
