#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "limn/formats/ply_header.h"
#include "limn/formats/text_scanner.h"

namespace limn {

// The values of a PLY file's data part, one after the other, ascii or binary of either byte order.
// Throws IoError with the place.
class PlyValues {
 public:
  // `bytes` is the whole file; it and the header must outlive the object.
  PlyValues(const std::string& path, std::string_view bytes, const PlyHeader& header);

  double Next(PlyType type);
  // The next list, in place of what `values` held.
  void NextList(const PlyProperty& property, std::vector<double>* values);

  // Throws unless the rest of the file can hold the element, so that nothing is allocated for
  // counts that cannot be true.
  void CheckRoomFor(const PlyElement& element) const;

  [[noreturn]] void Fail(const std::string& reason) const;
  // A value as the index of one of `count` vertices; `what` begins the error.
  int VertexIndex(double value, size_t count, const char* what) const;

 private:
  std::string path_;
  std::string_view data_;
  const PlyHeader& header_;
  size_t at_ = 0;
  bool swap_ = false;
  std::unique_ptr<TextScanner> text_;
};

// `row` holds the element's properties in order (lists are 0), `list` the values of one of them.
using TakePlyRow =
    std::function<void(const std::vector<double>& row, const std::vector<double>& list)>;

// Reads one element and calls `take` with each of its rows. `list_property` is the index of the
// list that is wanted, -1 = none; other lists are passed over.
void ReadPlyRows(const PlyElement& element, int list_property, PlyValues* values,
                 const TakePlyRow& take);

// Index of a property that is no list; throws IoError if there is none of that name.
int FindPlyScalar(const std::string& path, const PlyElement& element, const char* name);

// The positions of element vertex: x, y, z, all finite.
std::vector<Eigen::Vector3d> ReadPlyVertices(const std::string& path, const PlyElement& element,
                                             PlyValues* values);

}  // namespace limn
