// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_points_reader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "limn/files/whole_file.h"
#include "limn/formats/ply_header.h"
#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

constexpr size_t kBlockBytes = 1 << 22;

class PointReader {
 public:
  explicit PointReader(const std::string& path,
                       std::function<void(const PlyPoint&)> visit_odd = nullptr)
      : path_(path), visit_odd_(std::move(visit_odd)), in_(OpenFile(path)) {
    std::string start(kMaxPlyHeaderBytes + 1, '\0');
    in_.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<size_t>(in_.gcount()));
    header_ = ParsePlyHeader(path, start);
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(header_.data_offset));
    if (header_.elements.empty() || header_.elements[0].name != "vertex") {
      throw IoError(path, "the first element is not vertex");
    }
    for (const PlyProperty& property : Vertex().properties) {
      if (property.is_list) throw IoError(path, "vertices with the list " + property.name);
      offset_.push_back(row_bytes_);
      row_bytes_ += PlyTypeSize(property.type);
    }
    const char* names[9] = {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"};
    for (int k = 0; k < 9; ++k) column_[k] = Vertex().Find(names[k]);
    for (int k = 6; k < 9; ++k) {
      if (column_[k] < 0) column_[k] = Vertex().Find(std::string("diffuse_") + names[k]);
    }
    if (!Has(0)) throw IoError(path, "element vertex has no properties x, y, z");
    quality_ = Vertex().Find("quality");
  }

  PlyPointsInfo Info() const { return {Vertex().count, Has(3), Has(6)}; }

  void Run(const std::function<void(const PlyPoint&)>& visit) {
    if (header_.format == PlyHeader::Format::kAscii) {
      ReadText(visit);
    } else {
      ReadBinary(visit);
    }
  }

 private:
  const PlyElement& Vertex() const { return header_.elements[0]; }

  // The three properties from the k-th on.
  bool Has(int k) const { return column_[k] >= 0 && column_[k + 1] >= 0 && column_[k + 2] >= 0; }

  void ReadBinary(const std::function<void(const PlyPoint&)>& visit) {
    const bool swap = header_.format == PlyHeader::Format::kBigEndian;
    const size_t rows_per_block =
        std::max<size_t>(kBlockBytes / std::max<size_t>(row_bytes_, 1), 1);
    std::vector<char> block(rows_per_block * row_bytes_);
    std::vector<double> values(offset_.size());
    for (uint64_t done = 0; done < Vertex().count;) {
      const size_t rows = std::min<uint64_t>(rows_per_block, Vertex().count - done);
      in_.read(block.data(), static_cast<std::streamsize>(rows * row_bytes_));
      if (static_cast<size_t>(in_.gcount()) < rows * row_bytes_) {
        Fail("vertex", done + in_.gcount() / row_bytes_, "the file ends too early");
      }
      for (size_t row = 0; row < rows; ++row) {
        for (size_t p = 0; p < values.size(); ++p) {
          values[p] = PlyValue(Vertex().properties[p].type,
                               block.data() + row * row_bytes_ + offset_[p], swap);
        }
        Visit(values, "vertex", done + row, visit);
      }
      done += rows;
    }
  }

  void ReadText(const std::function<void(const PlyPoint&)>& visit) {
    std::string line;
    std::vector<double> values(offset_.size());
    uint64_t number = header_.num_lines;
    for (uint64_t done = 0; done < Vertex().count;) {
      ++number;
      if (!std::getline(in_, line)) Fail("line", number, "the file ends too early");
      std::istringstream fields(line);
      std::string field;
      size_t p = 0;
      for (; p < values.size() && fields >> field; ++p) {
        const auto value = ParseNumber<double>(field);
        if (!value) Fail("line", number, "\"" + field.substr(0, 40) + "\" is not a number");
        values[p] = *value;
      }
      if (p == 0) continue;  // a blank line
      if (p < values.size()) Fail("line", number, "too few numbers");
      Visit(values, "line", number, visit);
      ++done;
    }
  }

  void Visit(const std::vector<double>& values, const char* unit, uint64_t place,
             const std::function<void(const PlyPoint&)>& visit) const {
    PlyPoint point;
    if (quality_ >= 0 && std::isfinite(values[quality_])) point.quality = values[quality_];
    bool is_odd = false;
    for (int axis = 0; axis < 3; ++axis) {
      point.position[axis] = values[column_[axis]];
      if (Has(3)) point.normal[axis] = values[column_[3 + axis]];
      if (Has(6)) {
        const double color = values[column_[6 + axis]];
        if (std::isnan(color)) {
          if (!visit_odd_) Fail(unit, place, "color is not a number");
          is_odd = true;
          continue;
        }
        point.color[axis] = static_cast<uint8_t>(std::clamp(color, 0.0, 255.0));
      }
    }
    if (!point.position.allFinite() || !point.normal.allFinite()) {
      if (!visit_odd_) Fail(unit, place, "number not finite");
      is_odd = true;
    }
    (is_odd ? visit_odd_ : visit)(point);
  }

  [[noreturn]] void Fail(const char* unit, uint64_t place, const std::string& reason) const {
    throw IoError(path_, std::string(unit) + " " + std::to_string(place), reason);
  }

  std::string path_;
  std::function<void(const PlyPoint&)> visit_odd_;
  std::ifstream in_;
  PlyHeader header_;
  std::vector<size_t> offset_;
  size_t row_bytes_ = 0;
  int column_[9];
  int quality_ = -1;
};

}  // namespace

PlyPointsInfo ReadPlyPointsInfo(const std::string& path) { return PointReader(path).Info(); }

void ReadPlyPoints(const std::string& path, const std::function<void(const PlyPoint&)>& visit,
                   const std::function<void(const PlyPoint&)>& visit_odd) {
  PointReader(path, visit_odd).Run(visit);
}

}  // namespace limn
