// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "limn/formats/svg/hidden.h"
#include "limn/formats/svg/path.h"
#include "limn/formats/svg/sheet.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

struct LinkPathOptions {
  // Draw the primitives of links where known, else their points.
  bool use_primitives = true;
  // Largest deviation of approximated curves.
  double tolerance_px = 0.1;
  // See FindRuns.
  double min_run_px = 6;
  // Of the numbers in the paths.
  int decimals = 2;
};

// The visible and hidden parts of one link.
struct LinkPath {
  SvgPath visible;
  SvgPath hidden;
  // Whether the link's two ends are visible.
  bool end_is_open[2] = {true, true};
};

// The visible and hidden parts of a link on a sheet: of its shape, or, where that is not known or
// not asked for, of its points by arc length.
struct LinkRuns {
  std::vector<ShownRun> runs;
  bool of_shape = false;
};
LinkRuns RunsOnSheet(const SvgSheet& sheet, const DrawingLink& link, const IsHidden& is_hidden,
                     const LinkPathOptions& options);

// In a photograph, in stored pixels; the corner of the picture is (0, 0), the center of its
// top-left pixel (0.5, 0.5). Lines and cubic curves within the tolerance.
LinkPath DrawLink(const View& view, const DrawingLink& link, const IsHidden& is_hidden,
                  const LinkPathOptions& options);

// On a sheet, in its units. Lines, arcs (as parts of ellipses) and splines are exact; a circle seen
// edge-on, and a link without a shape, within the tolerance.
LinkPath DrawLink(const SvgSheet& sheet, const DrawingLink& link, const IsHidden& is_hidden,
                  const LinkPathOptions& options);

}  // namespace limn
