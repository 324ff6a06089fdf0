#pragma once

#include <Eigen/Core>

#include "limn/formats/svg_hidden.h"
#include "limn/formats/svg_path.h"
#include "limn/formats/svg_sheet.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"

namespace limn {

struct LinkPathOptions {
  // The shapes of links where they are known, else their points.
  bool use_primitives = true;
  // Curves that are drawn for others stay this near to them.
  double tolerance_px = 0.1;
  // See FindRuns.
  double min_run_px = 6;
  // Of the numbers in the paths.
  int decimals = 2;
};

// What is seen of one link.
struct LinkPath {
  SvgPath visible;
  SvgPath hidden;
  // Nothing stands before the link's two ends.
  bool end_is_open[2] = {true, true};
};

// In a photograph, in stored pixels; the corner of the picture is (0, 0), the center of its
// top-left pixel (0.5, 0.5). Lines and cubic curves within the tolerance.
LinkPath DrawLink(const View& view, const DrawingLink& link, const IsHidden& is_hidden,
                  const LinkPathOptions& options);

// On a sheet, in its units. Lines, arcs (as parts of ellipses) and splines are exact; a circle seen
// from its side, and what has no shape, within the tolerance.
LinkPath DrawLink(const SvgSheet& sheet, const DrawingLink& link, const IsHidden& is_hidden,
                  const LinkPathOptions& options);

}  // namespace limn
