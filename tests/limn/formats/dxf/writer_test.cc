// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/writer.h"

#include <cstdlib>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

namespace limn {
namespace {

std::string Written(const auto& put) {
  std::ostringstream out;
  DxfWriter writer(out);
  put(&writer);
  return out.str();
}

TEST(DxfWriter, CodeThenValue) {
  EXPECT_EQ(Written([](DxfWriter* w) { w->Put(0, "LINE"); }), "0\nLINE\n");
  EXPECT_EQ(Written([](DxfWriter* w) { w->Put(70, -8); }), "70\n-8\n");
  EXPECT_EQ(Written([](DxfWriter* w) { w->PutHandle(5, 0x1aF); }), "5\n1AF\n");
  EXPECT_EQ(Written([](DxfWriter* w) {
              w->PutPoint(11, {1, -2.5, 0});
            }),
            "11\n1.0\n21\n-2.5\n31\n0.0\n");
}

TEST(DxfWriter, NumbersKeepEveryBitAndHaveAPoint) {
  for (const double value : {0.0, 1.0, -3.0, 1.0 / 3, 1e-17, -2.5e300, 123456789.0, 1e22,
                             std::numeric_limits<double>::denorm_min()}) {
    const std::string text = Written([&](DxfWriter* w) { w->Put(40, value); }).substr(3);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
    EXPECT_NE(text.find('.'), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace limn
