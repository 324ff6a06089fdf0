// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "limn/files/text_scanner.h"
#include "limn/formats/ply_header.h"

namespace limn {

// Reads the values in the data part of a PLY file in order, ascii or binary of either byte order.
// Throws IoError with the place.
class PlyValues {
 public:
  // `bytes` is the whole file; it and the header must outlive the object.
  PlyValues(const std::string& path, std::string_view bytes, const PlyHeader& header);

  double Next(PlyType type);
  // The next list, replacing the content of `values`.
  void NextList(const PlyProperty& property, std::vector<double>* values);

  // Throws unless the rest of the file can hold the element, so that nothing is allocated for
  // impossible counts.
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

// `row` has the element's properties in order (lists are 0), `list` the values of one list.
using TakePlyRow =
    std::function<void(const std::vector<double>& row, const std::vector<double>& list)>;

// Reads one element and calls `take` for each row. `list_property` is the index of the requested
// list, -1 = none; other lists are ignored.
void ReadPlyRows(const PlyElement& element, int list_property, PlyValues* values,
                 const TakePlyRow& take);

// Index of the scalar property of this name; throws IoError if there is none.
int FindPlyScalar(const std::string& path, const PlyElement& element, const char* name);

// The positions of element vertex: x, y, z, all finite. `take`, unless empty, gets its rows, too.
std::vector<Eigen::Vector3d> ReadPlyVertices(const std::string& path, const PlyElement& element,
                                             PlyValues* values, const TakePlyRow& take = {});

}  // namespace limn
