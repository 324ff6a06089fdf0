#include "limn/refinement/crowding.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limn {
namespace {

constexpr double kRowPx = 4;
const double kMinCosine = std::cos(20 * M_PI / 180);

int Row(double y) { return static_cast<int>(std::floor(y / kRowPx)); }

}  // namespace

Crowding::Crowding(std::vector<ImagePlace> places) : places_(std::move(places)) {
  const auto key = [](const ImagePlace& p) {
    return std::tuple(Row(p.pixel.y()), p.pixel.x(), p.pixel.y(), p.link);
  };
  std::sort(places_.begin(), places_.end(),
            [&](const ImagePlace& a, const ImagePlace& b) { return key(a) < key(b); });
  if (places_.empty()) return;
  first_row_ = Row(places_.front().pixel.y());
  const int num_rows = Row(places_.back().pixel.y()) - first_row_ + 1;
  row_begin_.assign(num_rows + 1, 0);
  for (const ImagePlace& place : places_) ++row_begin_[Row(place.pixel.y()) - first_row_ + 1];
  for (int row = 0; row < num_rows; ++row) row_begin_[row + 1] += row_begin_[row];
}

bool Crowding::At(const ImagePlace& place, double distance_px) const {
  const int num_rows = static_cast<int>(row_begin_.size()) - 1;
  const int first = std::max(Row(place.pixel.y() - distance_px) - first_row_, 0);
  const int last = std::min(Row(place.pixel.y() + distance_px) - first_row_, num_rows - 1);
  for (int row = first; row <= last; ++row) {
    const auto end = places_.begin() + row_begin_[row + 1];
    auto it =
        std::lower_bound(places_.begin() + row_begin_[row], end, place.pixel.x() - distance_px,
                         [](const ImagePlace& p, double x) { return p.pixel.x() < x; });
    for (; it != end && it->pixel.x() <= place.pixel.x() + distance_px; ++it) {
      if (it->link == place.link) continue;
      if ((it->pixel - place.pixel).norm() > distance_px) continue;
      if (std::abs(std::cos(it->direction_rad - place.direction_rad)) > kMinCosine) return true;
    }
  }
  return false;
}

}  // namespace limn
