// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/verbs/selection_options.h"
#include "limn/evaluation/hss.h"
#include "limn/model/alignment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/link_selection.h"
#include "limn/model/reduce_to_wireframe.h"

namespace limn::colmap_ext {

// The options of drawing_evaluator that only --protocol hss has.
struct HssInput {
  HssOptions hss;
  WireframeOptions wireframe;
  // Meters per unit of the coordinates; 0: as the drawing is aligned, else 1.
  double scale = 0;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
  bool IsDefault() const;
};

// What is judged, and by what. All is in the same coordinates.
struct HssFiles {
  std::string input_path;
  std::string truth_path, truth_edges_path;
  LinkSelection selection;  // of a drawing, by these details of it
  Detail detail = Detail::kAll;
  // x0, x1, y0, y1, z0, z1; empty: everything.
  std::vector<double> box;
  // Of a drawing in memory, if it has one.
  std::optional<Alignment> alignment;
};

// The scores of a drawing in memory or, if that is null, of the input file. Files of wireframes
// (ReadWireframe) are taken as they are, in the unit that they tell; drawings and other curves are
// reduced to wireframes, in meters. Says how, and warns if nothing tells the scale. Throws IoError
// and InputError.
HssScores JudgeWireframe(const DrawingGraph* drawing, const HssFiles& files, const HssInput& input,
                         Console* console);

}  // namespace limn::colmap_ext
