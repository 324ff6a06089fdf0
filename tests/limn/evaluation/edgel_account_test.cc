// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/edgel_account.h"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "limn/drawing/drawing.h"
#include "limn/sketch/sketch.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

struct WireCube {
  std::vector<View> views = testing::DomeViews(10, 5);
  std::vector<ImageCurves> curves = testing::ProjectCurves(views, testing::CubeEdges(0.8), 0.1);
  SceneHints hints;
  SketchResult sketch = BuildSweptSketch({{views, curves, hints}}, {}, {});
  DrawingResult drawing = BuildDrawing({{views, curves}, sketch.sketch}, {}, {});

  EdgelFates Account(const DrawingGraph& graph, const SampleFates& fates) const {
    return AccountEdgels({{views, curves}, sketch.fates, sketch.sketch, fates, graph}, {});
  }
};

const WireCube& Cube() {
  static const WireCube cube;
  return cube;
}

double ShareOf(const EdgelFates& fates, std::initializer_list<EdgelFate> wanted) {
  double all = 0, found = 0;
  for (const auto& of_view : fates) {
    for (const EdgelFate fate : of_view) {
      ++all;
      found += std::find(wanted.begin(), wanted.end(), fate) != wanted.end();
    }
  }
  return found / all;
}

TEST(EdgelAccountTest, DrawingExplainsACubeOfWires) {
  const WireCube& run = Cube();
  const EdgelFates fates = run.Account(run.drawing.graph, run.drawing.fates);
  EXPECT_GE(ShareOf(fates, {EdgelFate::kDrawn, EdgelFate::kExplained}), 0.98);
}

TEST(EdgelAccountTest, WithoutADrawingSamplesKeepTheirFates) {
  const WireCube& run = Cube();
  SampleFates fates = run.drawing.fates;
  for (auto& of_curve : fates) {
    std::fill(of_curve.begin(), of_curve.end(), EdgelFate::kDoubtfulLink);
  }
  const EdgelFates account = run.Account({}, fates);
  double sketched = 0, doubtful = 0;
  for (size_t v = 0; v < account.size(); ++v) {
    for (size_t id = 0; id < account[v].size(); ++id) {
      sketched += run.sketch.fates[v][id] == EdgelFate::kSketched;
      doubtful += account[v][id] == EdgelFate::kDoubtfulLink;
      if (run.sketch.fates[v][id] != EdgelFate::kSketched) {
        EXPECT_EQ(account[v][id], run.sketch.fates[v][id]);
      }
    }
  }
  EXPECT_GT(sketched, 0);
  EXPECT_EQ(sketched, doubtful);
}

TEST(EdgelAccountTest, CsvQuotesNames) {
  View view;
  view.name = "a\",\n1.png";
  std::stringstream csv;
  WriteAccountCsv({view}, {{}}, csv);
  EXPECT_NE(csv.str().find("\n\"a\"\",\n1.png\",0,"), std::string::npos) << csv.str();
}

TEST(EdgelAccountTest, CsvCountsEveryEdgel) {
  const WireCube& run = Cube();
  const EdgelFates fates = run.Account(run.drawing.graph, run.drawing.fates);
  std::stringstream csv;
  WriteAccountCsv(run.views, fates, csv);
  std::string line;
  int num_lines = 0;
  int64_t total = 0;
  while (std::getline(csv, line)) {
    ++num_lines;
    if (!line.starts_with("all,")) continue;
    std::stringstream cells(line.substr(4));
    for (std::string cell; std::getline(cells, cell, ',');) total += std::stoll(cell);
  }
  EXPECT_EQ(num_lines, 12);
  int64_t num_edgels = 0;
  for (const ImageCurves& of_view : run.curves) {
    num_edgels += static_cast<int64_t>(of_view.edge_map.edgels.size());
  }
  EXPECT_EQ(total, num_edgels);
}

}  // namespace
}  // namespace limn
