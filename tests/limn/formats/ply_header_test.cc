// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

PlyHeader ParseLines(const std::string& lines) {
  return ParsePlyHeader("a.ply", "ply\nformat ascii 1.0\n" + lines + "end_header\n");
}

std::string Repeated(int count, const std::string& before, const std::string& after) {
  std::string text;
  for (int i = 0; i < count; ++i) text += before + std::to_string(i) + after;
  return text;
}

TEST(ParsePlyHeader, SplatsHaveManyProperties) {
  const PlyHeader header =
      ParseLines("element vertex 3\n" + Repeated(100, "property float f_rest_", "\n"));
  EXPECT_EQ(header.elements[0].Find("f_rest_99"), 99);
}

TEST(ParsePlyHeader, RefusesMoreThanAnyProgramWrites) {
  EXPECT_THAT([] { ParseLines(Repeated(300, "element e", " 0\n")); },
              ThrowsMessage<IoError>(HasSubstr("a.ply: line 259: more than 256 elements")));
  EXPECT_THAT([] { ParseLines("element v 1\n" + Repeated(5000, "property uchar p", "\n")); },
              ThrowsMessage<IoError>(HasSubstr("an element has more than 4096 properties")));
  EXPECT_THAT([] { ParseLines("comment " + std::string(2'000'000, 'x') + "\n"); },
              ThrowsMessage<IoError>(HasSubstr("line 3: the header has more than 1048576 bytes")));
}

}  // namespace
}  // namespace limn
