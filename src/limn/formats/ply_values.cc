// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_values.h"

#include <algorithm>
#include <cmath>

#include "limn/util/errors.h"

namespace limn {
PlyValues::PlyValues(const std::string& path, std::string_view bytes, const PlyHeader& header)
    : path_(path), data_(bytes.substr(header.data_offset)), header_(header) {
  if (header.format == PlyHeader::Format::kAscii) {
    text_ = std::make_unique<TextScanner>(path, data_, header.num_lines + 1);
  }
  swap_ = header.format == PlyHeader::Format::kBigEndian;
}

double PlyValues::Next(PlyType type) {
  if (text_) return text_->Number("number");
  const size_t size = PlyTypeSize(type);
  if (data_.size() - at_ < size) Fail("the file ends too early");
  at_ += size;
  return PlyValue(type, data_.data() + at_ - size, swap_);
}

void PlyValues::NextList(const PlyProperty& property, std::vector<double>* values) {
  values->clear();
  const double count = Next(property.count_type);
  if (!(count >= 0)) Fail("list of negative length");
  for (double i = 0; i < count; ++i) values->push_back(Next(property.type));
}

void PlyValues::CheckRoomFor(const PlyElement& element) const {
  size_t least = 0;
  for (const PlyProperty& property : element.properties) {
    least += text_ ? 2 : PlyTypeSize(property.is_list ? property.count_type : property.type);
  }
  // The last number of a text needs no separator.
  if (least > 0 && element.count > (data_.size() - at_ + 1) / least) {
    Fail("the file is too short for " + std::to_string(element.count) + " of element " +
         element.name);
  }
}

void PlyValues::Fail(const std::string& reason) const {
  if (text_) text_->Fail(reason);
  throw IoError(path_, "byte " + std::to_string(header_.data_offset + at_), reason);
}

int PlyValues::VertexIndex(double value, size_t count, const char* what) const {
  if (!(value >= 0 && value < static_cast<double>(count) && value == std::floor(value))) {
    Fail(std::string(what) + " to vertex " + std::to_string(value) + " of " +
         std::to_string(count));
  }
  return static_cast<int>(value);
}

void ReadPlyRows(const PlyElement& element, int list_property, PlyValues* values,
                 const TakePlyRow& take) {
  if (element.properties.empty()) return;  // its rows are nothing, however many there are
  values->CheckRoomFor(element);
  std::vector<double> row(element.properties.size());
  std::vector<double> list, passed_over;
  for (size_t i = 0; i < element.count; ++i) {
    for (size_t p = 0; p < row.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.is_list) {
        values->NextList(property, static_cast<int>(p) == list_property ? &list : &passed_over);
      } else {
        row[p] = values->Next(property.type);
      }
    }
    take(row, list);
  }
}

int FindPlyScalar(const std::string& path, const PlyElement& element, const char* name) {
  const int index = element.Find(name);
  if (index < 0 || element.properties[index].is_list) {
    throw IoError(path, "element " + element.name + " has no property " + name);
  }
  return index;
}

std::vector<Eigen::Vector3d> ReadPlyVertices(const std::string& path, const PlyElement& element,
                                             PlyValues* values, const TakePlyRow& take) {
  const int x = FindPlyScalar(path, element, "x");
  const int y = FindPlyScalar(path, element, "y");
  const int z = FindPlyScalar(path, element, "z");
  std::vector<Eigen::Vector3d> vertices;
  ReadPlyRows(element, -1, values, [&](const std::vector<double>& row, const auto& list) {
    vertices.emplace_back(row[x], row[y], row[z]);
    if (!vertices.back().allFinite()) values->Fail("vertex coordinate not finite");
    if (take) take(row, list);
  });
  return vertices;
}

}  // namespace limn
