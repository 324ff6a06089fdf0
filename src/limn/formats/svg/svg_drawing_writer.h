// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "limn/formats/dimension_lines.h"
#include "limn/formats/svg/flat_drawing.h"
#include "limn/formats/svg/hidden.h"
#include "limn/formats/svg/sheet.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/plans/section.h"

namespace limn {

// Drawings as SVG pictures:
//   <title>, <desc> (what it shows; on sheets scale and origin), <style>
//   <image>             only with a photograph
//   <g id="links">      per visible link a <path id="link_<id>">, or, if hidden parts are
//                       dashed and it has some, a <g id="link_<id>"> with a path for the visible
//                       parts and one with class "hidden" for the others. Classes: line, arc,
//                       circle, spline or polyline (no shape known); surface, boundary, free or
//                       unknown (only after drawing_fuser); kind-edge, kind-paint, kind-shadow,
//                       kind-contour, kind-rod or kind-texture where known; tentative. Rods have
//                       their radius as data-radius, in units of the drawing
//   <g id="junctions">  <circle id="node_<id>"> per junction at which a link is visible
//   <g id="section">    only with a section: a thick <path> per line in which faces are cut, with
//                       class "closed" or "open", and a <circle> where a link is cut
//   <g id="dimensions"> only if the drawing has some: see dimensions.h
//   <g id="legend">     only on sheets: scale bar and directions of the axes
// The same drawing gives the same bytes.

enum class SvgHiddenParts { kRemoved, kDashed };

enum class SvgColors {
  kBlack,
  kLink,       // ColorOfCurve of its curve
  kPrimitive,  // by the type of the shape, in the style sheet
  kClass,      // by the class on dense results, in the style sheet
  kKind,       // by the kind of edge, in the style sheet
};

// Pixels are those of the photograph, or 1/96 inch on paper.
struct SvgOptions {
  std::string title = "Drawing";
  SvgColors colors = SvgColors::kBlack;
  SvgHiddenParts hidden_parts = SvgHiddenParts::kRemoved;
  bool use_primitives = true;
  bool junctions = true;
  double line_width_px = 1;
  double junction_radius_px = 2;
  // See LinkPathOptions.
  double tolerance_px = 0.1;
  double min_run_px = 6;
  // Photograph beneath the drawing in views, as a file or URL relative to the picture; empty: none.
  std::string photo;
  // Of the photograph, in [0, 1]; lower makes the lines stand out.
  double photo_opacity = 0.6;
  // What is cut, over the links.
  std::optional<Section> section;
  // Of dimensions.
  DimensionText dimension_text;

  // Throws OptionError.
  void Check() const;
};

// Numbers of links by outcome; the sum is the number of links.
struct SvgSummary {
  int num_drawn = 0;
  int num_hidden = 0;   // hidden entirely, and left out
  int num_outside = 0;  // outside of the picture
};

// Writes the drawing as seen in a photograph, through its lens; width and height are those of the
// stored image. Throws OptionError.
SvgSummary WriteDrawingSvg(const DrawingGraph& graph, const View& view, const IsHidden& is_hidden,
                           const SvgOptions& options, std::ostream& out);

// Writes the drawing in parallel projection to scale; width and height are in mm, units those of
// the model. The sheet was made for the same drawing. Throws OptionError.
SvgSummary WriteDrawingSvg(const DrawingGraph& graph, const SvgSheet& sheet,
                           const IsHidden& is_hidden, const SvgOptions& options, std::ostream& out);

}  // namespace limn
