// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <pybind11/numpy.h>

namespace limn::colmap_ext {

// Read-only numpy arrays over memory that `owner` keeps alive; nothing is copied. `stride` is the
// number of bytes from one row to the next.
template <typename Number>
pybind11::array_t<Number> ArrayOver(const Number* data, size_t rows, size_t cols, size_t stride,
                                    std::shared_ptr<const void> owner) {
  const pybind11::capsule keeper(new std::shared_ptr<const void>(std::move(owner)), [](void* kept) {
    delete static_cast<std::shared_ptr<const void>*>(kept);
  });
  std::vector<size_t> shape = {rows};
  std::vector<size_t> strides = {stride};
  if (cols > 0) {
    shape.push_back(cols);
    strides.push_back(sizeof(Number));
  }
  pybind11::array_t<Number> array(shape, strides, data, keeper);
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

// N x 3.
inline pybind11::array_t<double> PointsOver(const std::vector<Eigen::Vector3d>& points,
                                            std::shared_ptr<const void> owner) {
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  return ArrayOver<double>(points.empty() ? nullptr : points[0].data(), points.size(), 3,
                           sizeof(Eigen::Vector3d), std::move(owner));
}

// N.
template <typename Number>
pybind11::array_t<Number> NumbersOver(const std::vector<Number>& numbers,
                                      std::shared_ptr<const void> owner) {
  return ArrayOver<Number>(numbers.data(), numbers.size(), 0, sizeof(Number), std::move(owner));
}

// One number or a few in a row of every element of a vector; `first` is in the first element.
template <typename Number, typename Element>
pybind11::array_t<Number> ColumnsOver(const std::vector<Element>& elements, const Number* first,
                                      size_t cols, std::shared_ptr<const void> owner) {
  return ArrayOver<Number>(first, elements.size(), cols, sizeof(Element), std::move(owner));
}

// A copy, 3 or 3 x 3.
inline pybind11::array_t<double> CopyOf(const Eigen::Vector3d& vector) {
  return pybind11::array_t<double>(3, vector.data());
}
inline pybind11::array_t<double> CopyOf(const Eigen::Matrix3d& matrix) {
  pybind11::array_t<double> array({3, 3});
  auto values = array.mutable_unchecked<2>();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) values(r, c) = matrix(r, c);
  }
  return array;
}

}  // namespace limn::colmap_ext
