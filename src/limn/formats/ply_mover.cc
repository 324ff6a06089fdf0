// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_mover.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <ostream>
#include <string_view>
#include <vector>

#include "limn/files/whole_file.h"
#include "limn/formats/ply_header.h"
#include "limn/formats/ply_values.h"
#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn {
namespace {

// Also the longest line of a text.
constexpr size_t kWindowBytes = size_t{1} << 22;
static_assert(kWindowBytes > kMaxPlyHeaderBytes);

// The part of a file at hand, which moves on.
class FileWindow {
 public:
  explicit FileWindow(const std::string& path)
      : in_(OpenFile(path)), bytes_(std::make_unique_for_overwrite<char[]>(kWindowBytes)) {}

  // The next bytes, to be changed in place; fewer than `size` only at the end of the file.
  // Precondition: size <= kWindowBytes.
  std::string_view Peek(size_t size) {
    if (end_ - begin_ < size) Fill();
    return {bytes_.get() + begin_, std::min(size, end_ - begin_)};
  }
  char* data() { return bytes_.get() + begin_; }

  // The next line with its end. Empty at the end of the file, or if it is too long.
  std::string_view PeekLine() {
    std::string_view line = LineAtHand();
    if (!line.empty()) return line;
    Fill();
    line = LineAtHand();
    if (!line.empty() || end_ - begin_ == kWindowBytes) return line;
    return {bytes_.get() + begin_, end_ - begin_};
  }

  void Skip(size_t size) { begin_ += size; }

 private:
  std::string_view LineAtHand() const {
    const std::string_view at_hand(bytes_.get() + begin_, end_ - begin_);
    return at_hand.substr(0, at_hand.find('\n') + 1);  // npos + 1 is 0
  }

  void Fill() {
    std::copy(bytes_.get() + begin_, bytes_.get() + end_, bytes_.get());
    end_ -= begin_;
    begin_ = 0;
    in_.read(bytes_.get() + end_, static_cast<std::streamsize>(kWindowBytes - end_));
    end_ += static_cast<size_t>(in_.gcount());
  }

  std::ifstream in_;
  std::unique_ptr<char[]> bytes_;
  size_t begin_ = 0, end_ = 0;
};

bool IsReal(PlyType type) { return type == PlyType::kFloat32 || type == PlyType::kFloat64; }

double Rounded(PlyType type, double value) {
  return type == PlyType::kFloat32 ? static_cast<double>(static_cast<float>(value)) : value;
}

template <typename Real>
void Store(Real value, bool swap, char* bytes) {
  std::memcpy(bytes, &value, sizeof(Real));
  if (swap) std::reverse(bytes, bytes + sizeof(Real));
}

void StoreReal(PlyType type, double value, bool swap, char* bytes) {
  if (type == PlyType::kFloat32) return Store(static_cast<float>(value), swap, bytes);
  Store(value, swap, bytes);
}

// The shortest that reads back as the same number of this type.
std::string RealText(PlyType type, double value) {
  char text[40];
  const auto [end, error] =
      type == PlyType::kFloat32
          ? std::to_chars(text, text + sizeof(text), static_cast<float>(value))
          : std::to_chars(text, text + sizeof(text), value);
  return {text, end};
}

constexpr std::string_view kBlanks = " \t\r\n\v\f";

std::vector<std::string_view> FieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlanks, end);
  }
  return fields;
}

// A property of the vertices that is moved.
struct Column {
  int index = 0;
  PlyType type = PlyType::kFloat32;
  size_t offset = 0;  // in a binary row
};

class PlyMover {
 public:
  PlyMover(const std::string& path, const Similarity3d& similarity, std::ostream& out)
      : path_(path), similarity_(similarity), out_(out), in_(path) {
    header_ = ParsePlyHeader(path, in_.Peek(kMaxPlyHeaderBytes + 1));
    line_ = header_.num_lines;
    FindColumns();
  }

  void Run(const std::string& comment) {
    PutHeader(comment);
    for (const PlyElement& element : header_.elements) {
      if (header_.format == PlyHeader::Format::kAscii) {
        MoveText(element);
      } else if (element.name == "vertex") {
        MoveBinary(element);
      } else {
        CopyBinary(element);
      }
    }
    while (const size_t size = in_.Peek(kWindowBytes).size()) Put(size);
  }

 private:
  void FindColumns() {
    const auto vertex = std::ranges::find(header_.elements, "vertex", &PlyElement::name);
    if (vertex == header_.elements.end()) throw IoError(path_, "has no element vertex");
    for (const char* name : {"x", "y", "z"}) {
      columns_.push_back({FindPlyScalar(path_, *vertex, name)});
    }
    const bool has_normals =
        vertex->Find("nx") >= 0 && vertex->Find("ny") >= 0 && vertex->Find("nz") >= 0;
    for (const char* name : {"nx", "ny", "nz"}) {
      if (has_normals) columns_.push_back({FindPlyScalar(path_, *vertex, name)});
    }
    std::vector<size_t> offsets;
    for (const PlyProperty& property : vertex->properties) {
      if (property.is_list) throw IoError(path_, "vertices with the list " + property.name);
      offsets.push_back(row_bytes_);
      row_bytes_ += PlyTypeSize(property.type);
    }
    for (Column& column : columns_) {
      const PlyProperty& property = vertex->properties[column.index];
      if (!IsReal(property.type)) {
        throw IoError(path_, property.name + " of the vertices is an integer");
      }
      column.type = property.type;
      column.offset = offsets[column.index];
    }
  }

  // The comment comes after the line of the format, with the same end.
  void PutHeader(const std::string& comment) {
    for (size_t rest = header_.data_offset; rest > 0;) {
      const std::string line(in_.PeekLine());
      Put(line.size());
      rest -= line.size();
      if (!line.starts_with("format") || comment.empty()) continue;
      out_ << "comment " << comment << (line.ends_with("\r\n") ? "\r\n" : "\n");
    }
  }

  // Moves the values of the columns. Returns what is wrong with them; empty: nothing.
  std::string Move(std::array<double, 6>* values) const {
    Eigen::Map<Eigen::Vector3d> position(values->data()), normal(values->data() + 3);
    if (!position.allFinite()) return "coordinate not finite";
    position = similarity_ * Eigen::Vector3d(position);
    normal = similarity_.rotation * Eigen::Vector3d(normal);
    for (int axis = 0; axis < 3; ++axis) {
      position[axis] = Rounded(columns_[axis].type, position[axis]);
    }
    return position.allFinite() ? "" : "coordinate too large once moved";
  }

  void MoveBinary(const PlyElement& element) {
    const bool swap = header_.format == PlyHeader::Format::kBigEndian;
    const size_t rows_at_once = kWindowBytes / row_bytes_;
    for (uint64_t done = 0; done < element.count;) {
      const size_t rows = std::min<uint64_t>(rows_at_once, element.count - done);
      const size_t whole_rows = in_.Peek(rows * row_bytes_).size() / row_bytes_;
      if (whole_rows < rows) FailAt(element, done + whole_rows, "the file ends too early");
      for (size_t row = 0; row < rows; ++row) {
        MoveBinaryRow(element, done + row, swap, in_.data() + row * row_bytes_);
      }
      Put(rows * row_bytes_);
      done += rows;
    }
  }

  void MoveBinaryRow(const PlyElement& element, uint64_t index, bool swap, char* row) const {
    std::array<double, 6> values = {};
    for (size_t k = 0; k < columns_.size(); ++k) {
      values[k] = PlyValue(columns_[k].type, row + columns_[k].offset, swap);
    }
    const std::string wrong = Move(&values);
    if (!wrong.empty()) FailAt(element, index, wrong);
    for (size_t k = 0; k < columns_.size(); ++k) {
      StoreReal(columns_[k].type, values[k], swap, row + columns_[k].offset);
    }
  }

  void CopyBinary(const PlyElement& element) {
    if (element.properties.empty()) return;  // its rows are nothing, however many there are
    for (uint64_t row = 0; row < element.count; ++row) {
      for (const PlyProperty& property : element.properties) {
        uint64_t size = PlyTypeSize(property.type);
        if (property.is_list) size *= TakeListCount(element, row, property);
        CopyBytes(element, row, size);
      }
    }
  }

  uint64_t TakeListCount(const PlyElement& element, uint64_t row, const PlyProperty& property) {
    const size_t size = PlyTypeSize(property.count_type);
    const std::string bytes(in_.Peek(size));
    CopyBytes(element, row, size);
    const bool swap = header_.format == PlyHeader::Format::kBigEndian;
    const double count = PlyValue(property.count_type, bytes.data(), swap);
    if (!(count >= 0 && count <= 1e15)) FailAt(element, row, "list of an impossible length");
    return static_cast<uint64_t>(count);
  }

  void CopyBytes(const PlyElement& element, uint64_t row, uint64_t size) {
    while (size > 0) {
      const size_t part = in_.Peek(std::min<uint64_t>(size, kWindowBytes)).size();
      if (part == 0) FailAt(element, row, "the file ends too early");
      Put(part);
      size -= part;
    }
  }

  // A row per line; blank lines between them stay.
  void MoveText(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (uint64_t done = 0; done < element.count;) {
      const std::string_view line = in_.PeekLine();
      ++line_;
      if (line.empty()) {
        FailAtLine(in_.Peek(1).empty() ? "the file ends too early" : "a line is too long");
      }
      const std::vector<std::string_view> fields = FieldsOf(line);
      if (!fields.empty()) {
        CheckFields(element, fields);
        ++done;
      }
      if (element.name == "vertex" && !fields.empty()) {
        PutMovedLine(line, fields);
        in_.Skip(line.size());
      } else {
        Put(line.size());
      }
    }
  }

  void CheckFields(const PlyElement& element, const std::vector<std::string_view>& fields) const {
    size_t used = 0;
    for (const PlyProperty& property : element.properties) {
      const size_t at = used++;
      if (at >= fields.size()) FailAtLine("too few numbers");
      if (!property.is_list) continue;
      const double count = NumberIn(fields[at]);
      const auto left = static_cast<double>(fields.size() - used);
      if (!(count >= 0 && count <= left)) FailAtLine("too few numbers");
      used += static_cast<size_t>(count);
    }
  }

  void PutMovedLine(std::string_view line, const std::vector<std::string_view>& fields) {
    std::array<double, 6> values = {};
    for (size_t k = 0; k < columns_.size(); ++k) values[k] = NumberIn(fields[columns_[k].index]);
    const std::string wrong = Move(&values);
    if (!wrong.empty()) FailAtLine(wrong);
    std::vector<size_t> order(columns_.size());
    for (size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::ranges::sort(order, {}, [&](size_t k) { return columns_[k].index; });
    const char* at = line.data();
    for (const size_t k : order) {
      const std::string_view field = fields[columns_[k].index];
      out_.write(at, field.data() - at);
      out_ << RealText(columns_[k].type, values[k]);
      at = field.data() + field.size();
    }
    out_.write(at, line.data() + line.size() - at);
  }

  double NumberIn(std::string_view field) const {
    const auto value = ParseNumber<double>(field);
    if (!value) FailAtLine("\"" + std::string(field.substr(0, 40)) + "\" is not a number");
    return *value;
  }

  void Put(size_t size) {
    out_.write(in_.data(), static_cast<std::streamsize>(size));
    in_.Skip(size);
  }

  [[noreturn]] void FailAt(const PlyElement& element, uint64_t row,
                           const std::string& reason) const {
    throw IoError(path_, element.name + " " + std::to_string(row), reason);
  }
  [[noreturn]] void FailAtLine(const std::string& reason) const {
    throw IoError(path_, "line " + std::to_string(line_), reason);
  }

  const std::string& path_;
  const Similarity3d& similarity_;
  std::ostream& out_;
  FileWindow in_;
  PlyHeader header_;
  std::vector<Column> columns_;  // x, y, z, and where there are normals nx, ny, nz
  size_t row_bytes_ = 0;         // of a binary vertex
  uint64_t line_ = 0;            // the last one that was read
};

}  // namespace

void MovePly(const std::string& path, const Similarity3d& similarity, const std::string& comment,
             std::ostream& out) {
  PlyMover(path, similarity, out).Run(comment);
}

}  // namespace limn
