// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>

#include <Eigen/Core>

namespace limn {

// Writes the lines of an ASCII DXF file: a group code, then its value.
class DxfWriter {
 public:
  explicit DxfWriter(std::ostream& out) : out_(out) {}

  void BeginSection(const char* name);
  void EndSection();

  // UTF-8; what is not ASCII is written as "\U+00E4".
  void Put(int code, const std::string& text);
  void Put(int code, int value);
  // The shortest text that reads back as the same number, always with a decimal point.
  void Put(int code, double value);
  // At the codes x, x + 10 and x + 20.
  void PutPoint(int x_code, const Eigen::Vector3d& point);
  // A handle: hexadecimal.
  void PutHandle(int code, int handle);

 private:
  std::ostream& out_;
};

}  // namespace limn
