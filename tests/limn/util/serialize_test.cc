// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/serialize.h"

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace limn {

// With linkage: libc++ converts AnyField to the content of an optional.
namespace serialize_test {

enum class Kind : uint8_t { kNone, kSome, kAll };

struct Pair {
  int32_t first = -1;
  int32_t second = -1;

  auto operator<=>(const Pair&) const = default;
};

// One field of every sort, and as many fields as a struct may have.
struct Everything {
  double number = 0;
  Kind kind = Kind::kNone;
  bool flag = false;
  std::string text;
  Eigen::Matrix<double, 2, 3> matrix = Eigen::Matrix<double, 2, 3>::Zero();
  std::optional<Pair> pair;
  std::vector<std::vector<Pair>> lists;
  std::vector<Eigen::Vector3d> points;

  bool operator==(const Everything&) const = default;
};

}  // namespace serialize_test

namespace {

using serialize_test::Everything;
using serialize_test::Kind;
using serialize_test::Pair;

template <class T>
std::string BytesOf(const T& value) {
  ByteWriter out;
  Serialize(value, &out);
  return out.bytes();
}

template <class T>
T ThroughBytes(const T& value) {
  const std::string bytes = BytesOf(value);
  ByteReader in("test", bytes);
  T result;
  Deserialize(&in, &result);
  in.ExpectEnd();
  return result;
}

Everything Example() {
  Everything example;
  example.number = std::numeric_limits<double>::denorm_min();
  example.kind = Kind::kAll;
  example.flag = true;
  example.text = std::string("a\0b", 3);
  example.matrix << 1, 2, 3, 4, 5, 6;
  example.pair = Pair{7, 8};
  example.lists = {{{1, 2}, {3, 4}}, {}, {{5, 6}}};
  example.points = {{1, 2, 3}, {-1, -2, -3}};
  return example;
}

TEST(Serialize, EverySortOfFieldComesBack) {
  EXPECT_EQ(ThroughBytes(Example()), Example());
  EXPECT_EQ(ThroughBytes(Everything()), Everything());
}

TEST(Serialize, WhatWasThereBeforeIsReplaced) {
  Everything value = Example();
  const std::string bytes = BytesOf(Everything());
  ByteReader in("test", bytes);
  Deserialize(&in, &value);
  EXPECT_EQ(value, Everything());
}

// Nothing but the values and the counts of lists.
TEST(Serialize, TakesNoMoreThanItHasTo) {
  EXPECT_EQ(BytesOf(Pair{1, 2}).size(), 8u);
  EXPECT_EQ(BytesOf(Kind::kSome).size(), 1u);
  EXPECT_EQ(BytesOf(Eigen::Matrix3d(Eigen::Matrix3d::Identity())).size(), 9 * sizeof(double));
  EXPECT_EQ(BytesOf(std::vector<Pair>(5)).size(), sizeof(uint64_t) + 5 * 8);
  EXPECT_EQ(BytesOf(std::optional<double>()).size(), 1u);
}

TEST(Serialize, BytesThatEndTooEarlyAreAnError) {
  const std::string bytes = BytesOf(Example());
  for (size_t size = 0; size < bytes.size(); ++size) {
    ByteReader in("test", std::string_view(bytes).substr(0, size));
    Everything value;
    EXPECT_THROW(Deserialize(&in, &value), IoError) << size;
  }
}

}  // namespace
}  // namespace limn
