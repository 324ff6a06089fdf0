// SPDX-License-Identifier: BSD-3-Clause
#include "limn/geometry/box_index2d.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <boost/geometry.hpp>  // rtree.hpp of Boost 1.83 needs more than it includes
#include <boost/geometry/index/rtree.hpp>

namespace limn {
namespace {

namespace bg = boost::geometry;
using FlatPoint = bg::model::point<double, 2, bg::cs::cartesian>;
using FlatBox = bg::model::box<FlatPoint>;
using NumberedBox = std::pair<FlatBox, int>;

FlatBox ToFlatBox(const Eigen::AlignedBox2d& box) {
  return {{box.min().x(), box.min().y()}, {box.max().x(), box.max().y()}};
}

}  // namespace

struct BoxIndex2d::Tree {
  bg::index::rtree<NumberedBox, bg::index::quadratic<16>> boxes;
};

BoxIndex2d::BoxIndex2d(const std::vector<Eigen::AlignedBox2d>& boxes)
    : tree_(std::make_unique<Tree>()) {
  std::vector<NumberedBox> numbered;
  for (size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) numbered.emplace_back(ToFlatBox(boxes[i]), static_cast<int>(i));
  }
  tree_->boxes = decltype(tree_->boxes)(numbered);
}

BoxIndex2d::~BoxIndex2d() = default;
BoxIndex2d::BoxIndex2d(BoxIndex2d&&) noexcept = default;
BoxIndex2d& BoxIndex2d::operator=(BoxIndex2d&&) noexcept = default;

std::vector<int> BoxIndex2d::Meeting(const Eigen::AlignedBox2d& box) const {
  std::vector<int> found;
  const auto query = bg::index::intersects(ToFlatBox(box));
  for (auto it = tree_->boxes.qbegin(query); it != tree_->boxes.qend(); ++it) {
    found.push_back(it->second);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace limn
