#include "limn/io/ply_reader.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "limn/io/curve_chains.h"
#include "limn/io/ply_header.h"
#include "limn/io/text_scanner.h"
#include "limn/io/whole_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr double kMaxLabel = 2147483647;

// The values of the data part, one after the other.
class PlyValues {
 public:
  PlyValues(const std::string& path, std::string_view bytes, const PlyHeader& header)
      : path_(path), data_(bytes.substr(header.data_offset)), header_(header) {
    if (header.format == PlyHeader::Format::kAscii) {
      text_ = std::make_unique<TextScanner>(path, data_, header.num_lines + 1);
    }
    swap_ = header.format == PlyHeader::Format::kBigEndian;
  }

  double Next(PlyType type) {
    if (text_) return text_->Number("number");
    const size_t size = PlyTypeSize(type);
    if (data_.size() - at_ < size) Fail("the file ends too early");
    at_ += size;
    return PlyValue(type, data_.data() + at_ - size, swap_);
  }

  void SkipList(const PlyProperty& property) {
    const double count = Next(property.count_type);
    if (!(count >= 0)) Fail("list of negative length");
    for (double i = 0; i < count; ++i) Next(property.type);
  }

  // Throws unless the rest of the file can hold the element, so that nothing is allocated for
  // counts that cannot be true.
  void CheckRoomFor(const PlyElement& element) const {
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

  [[noreturn]] void Fail(const std::string& reason) const {
    if (text_) text_->Fail(reason);
    throw IoError(path_, "byte " + std::to_string(header_.data_offset + at_), reason);
  }

 private:
  std::string path_;
  std::string_view data_;
  const PlyHeader& header_;
  size_t at_ = 0;
  bool swap_ = false;
  std::unique_ptr<TextScanner> text_;
};

// Reads one element; calls `take` with the scalar properties of each of its rows (lists are 0).
template <typename Take>
void ReadRows(const PlyElement& element, PlyValues* values, const Take& take) {
  if (element.properties.empty()) return;  // its rows are nothing, however many there are
  values->CheckRoomFor(element);
  std::vector<double> row(element.properties.size());
  for (size_t i = 0; i < element.count; ++i) {
    for (size_t p = 0; p < row.size(); ++p) {
      if (element.properties[p].is_list) {
        values->SkipList(element.properties[p]);
      } else {
        row[p] = values->Next(element.properties[p].type);
      }
    }
    take(row);
  }
}

int FindScalar(const PlyElement& element, const char* name, const std::string& path) {
  const int index = element.Find(name);
  if (index < 0 || element.properties[index].is_list) {
    throw IoError(path, "element " + element.name + " has no property " + name);
  }
  return index;
}

void ReadVertices(const std::string& path, const PlyElement& element, PlyValues* values,
                  EdgeSoup* soup) {
  const int x = FindScalar(element, "x", path);
  const int y = FindScalar(element, "y", path);
  const int z = FindScalar(element, "z", path);
  ReadRows(element, values, [&](const std::vector<double>& row) {
    soup->vertices.emplace_back(row[x], row[y], row[z]);
    if (!soup->vertices.back().allFinite()) values->Fail("vertex coordinate not finite");
  });
}

void ReadEdges(const std::string& path, const PlyElement& element, PlyValues* values,
               EdgeSoup* soup) {
  const int vertex1 = FindScalar(element, "vertex1", path);
  const int vertex2 = FindScalar(element, "vertex2", path);
  const int label = element.Find("link");
  const double num_vertices = static_cast<double>(soup->vertices.size());
  const auto index = [&](double value) {
    if (!(value >= 0 && value < num_vertices && value == std::floor(value))) {
      values->Fail("edge to vertex " + std::to_string(value) + " of " +
                   std::to_string(soup->vertices.size()));
    }
    return static_cast<int>(value);
  };
  ReadRows(element, values, [&](const std::vector<double>& row) {
    soup->edges.emplace_back(index(row[vertex1]), index(row[vertex2]));
    if (label < 0) return;
    if (!(std::abs(row[label]) <= kMaxLabel)) values->Fail("link id out of range");
    soup->labels.push_back(static_cast<int>(row[label]));
  });
}

}  // namespace

CurveSet ReadPlyCurves(const std::string& path) {
  const std::string bytes = ReadWholeFile(path);
  const PlyHeader header = ParsePlyHeader(path, bytes);
  PlyValues values(path, bytes, header);
  EdgeSoup soup;
  bool has_vertices = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      ReadVertices(path, element, &values, &soup);
      has_vertices = true;
    } else if (element.name == "edge") {
      if (!has_vertices) throw IoError(path, "element edge comes before element vertex");
      ReadEdges(path, element, &values, &soup);
    } else {
      ReadRows(element, &values, [](const std::vector<double>&) {});
    }
  }
  if (!has_vertices) throw IoError(path, "no element vertex");
  return ChainEdges(soup);
}

}  // namespace limn
