// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/files/json_value.h"

namespace limn {

// [x, y, z] of a JSON file. Throws InputError.
inline Eigen::Vector3d PlaceOf(const JsonValue& value) {
  Eigen::Vector3d place;
  value.Numbers(3, place.data());
  return place;
}

inline std::vector<Eigen::Vector3d> PlacesOf(const JsonValue& value) {
  std::vector<Eigen::Vector3d> places;
  for (const JsonValue& item : value.Items()) places.push_back(PlaceOf(item));
  return places;
}

// The member of an object that is one of several names, by a function that knows them. Throws
// InputError "<place>: unknown <what> ...".
template <typename Named>
auto NamedBy(const JsonValue& value, const Named& named, const char* what) {
  const auto found = named(value.Text());
  if (!found) value.FailUnknown(what);
  return *found;
}

}  // namespace limn
