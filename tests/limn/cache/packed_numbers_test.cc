// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/packed_numbers.h"

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

template <typename T>
std::string Packed(const std::vector<T>& numbers) {
  ByteWriter out;
  PutPacked(numbers, &out);
  return out.bytes();
}

template <typename T>
std::vector<T> Unpacked(const std::string& bytes) {
  ByteReader in("file", bytes);
  std::vector<T> numbers = GetPacked<T>(&in);
  in.ExpectEnd();
  return numbers;
}

TEST(PackedNumbers, NoBitIsLost) {
  std::vector<double> numbers = {0,
                                 -0.0,
                                 1.0 / 3,
                                 -1e300,
                                 std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::denorm_min()};
  for (int i = 0; i < 1000; ++i) numbers.push_back(std::sin(i) * std::pow(10, i % 7));
  const std::vector<double> read = Unpacked<double>(Packed(numbers));
  ASSERT_EQ(read.size(), numbers.size());
  for (size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(std::bit_cast<uint64_t>(read[i]), std::bit_cast<uint64_t>(numbers[i]));
  }
  EXPECT_TRUE(Unpacked<float>(Packed(std::vector<float>())).empty());
}

TEST(PackedNumbers, WhatRepeatsTakesLittle) {
  std::vector<double> places;
  for (int i = 0; i < 10000; ++i) places.push_back(700 + std::fmod(0.618 * i, 1));
  EXPECT_LT(Packed(places).size(), 10000 * 6.8);
  EXPECT_LT(Packed(std::vector<float>(10000, 0.05f)).size(), 1000u);
}

TEST(PackedNumbers, DamageIsRefused) {
  const std::string bytes = Packed(std::vector<float>(1000, 0.05f));
  for (size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(Unpacked<float>(bytes.substr(0, size)), IoError) << size;
  }
  std::string too_many = bytes;
  too_many[5] = 1;
  EXPECT_THROW(Unpacked<float>(too_many), IoError);
  // An inflated plane of another size.
  std::string fewer = bytes;
  --fewer[0];
  EXPECT_THROW(Unpacked<float>(fewer), IoError);
}

TEST(PackedNumbers, TextRoundTrip) {
  for (const std::string& text : {std::string(), std::string("x"), std::string(5000, 'y')}) {
    ByteWriter out;
    PutPackedText(text, &out);
    ByteReader in("file", out.bytes());
    EXPECT_EQ(GetPackedText(&in), text);
    in.ExpectEnd();
  }
}

TEST(Steps, RoundTrip) {
  const std::vector<int64_t> numbers = {0, 5, 4, 1000000, -7, INT64_MAX, INT64_MIN, 0};
  StepWriter steps;
  for (const int64_t number : numbers) steps.Put(number);
  steps.PutUnsigned(3);
  ByteWriter out;
  steps.Finish(&out);
  ByteReader in("file", out.bytes());
  StepReader read(&in);
  for (const int64_t number : numbers) EXPECT_EQ(read.Get(), number);
  EXPECT_THROW(read.ExpectEnd(), IoError);
  EXPECT_EQ(read.GetUnsigned(), 3u);
  read.ExpectEnd();
  EXPECT_THROW(read.Get(), IoError);
}

TEST(Steps, CountsBeyondTheEndAreRefused) {
  StepWriter steps;
  steps.PutUnsigned(3);
  steps.PutUnsigned(0);
  ByteWriter out;
  steps.Finish(&out);
  ByteReader in("file", out.bytes());
  StepReader read(&in);
  EXPECT_THROW(read.GetCount(), IoError);
}

}  // namespace
}  // namespace limn
