// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/ply_curves_writer.h"

#include <sstream>

#include <gtest/gtest.h>

#include "limn/formats/read_curves.h"
#include "limn/formats/temporary_folder.h"

namespace limn {
namespace {

CurveSet WriteAndRead(const CurveSet& set) {
  const TemporaryFolder folder;
  std::ostringstream out;
  WriteCurvesPly(set, out);
  return ReadCurves(folder.Write("curves.ply", out.str()));
}

TEST(WriteCurvesPly, CurvesAndPointsComeBackToTheLastBit) {
  CurveSet set;
  // The second continues where the first ends, the third is closed.
  set.polylines = {{{0.1, 0, 0}, {1.0 / 3, 2, 0}},
                   {{1.0 / 3, 2, 0}, {4, 4, 4}, {5, 5, 1e-9}},
                   {{7, 0, 0}, {8, 0, 0}, {8, 1, 0}, {7, 0, 0}}};
  set.points = {{9, 9, 9}, {-1, 2, 1e300}};
  const CurveSet again = WriteAndRead(set);
  EXPECT_EQ(again.polylines, set.polylines);
  EXPECT_EQ(again.points, set.points);
}

TEST(WriteCurvesPly, PointsAlone) {
  CurveSet set;
  set.points = {{1, 2, 3}};
  EXPECT_EQ(WriteAndRead(set).points, set.points);
}

}  // namespace
}  // namespace limn
