// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "limn/model/curve3d.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/edgel_fate.h"
#include "limn/model/image.h"
#include "limn/model/link_selection.h"
#include "limn/model/view.h"
#include "limn/pictures/picture.h"

namespace limn {

struct PictureOptions {
  // Enlargement, 1..8; 0 doubles pictures whose longer side is below 1000 px.
  int scale = 0;
  // Factor on the photograph's gray levels, in [0, 1]; lower makes the lines stand out.
  double brightness = 0.55;
  // Width of the lines and radius of a junction's disc, pixels of the picture. Marks of nodes whose
  // links are all shorter than six radii are smaller; with a radius of 0 there are none.
  int line_width_px = 2;
  double node_radius_px = 5.0;
  // Of a drawing. Links that it leaves out are not drawn, and nodes are those of the others.
  Detail detail = Detail::kNormal;

  void Check() const;
};

// A drawing over a photograph, in stored pixels, through the lens: one color per curve (CurvesOf).
// Links that this view does not support, tentative links, texture, outlines of smooth bodies and
// center lines of rods (what LinkSelection::AsSeen leaves out) are thin and faded; junctions are
// discs, ends small squares, loop anchors diamonds, at nodes of other links. Occlusion is ignored.
// Throws InputError if the photograph does not have the size of the view's camera.
Picture DrawOverlay(const Image& photo, const View& view, ViewId view_id, const DrawingGraph& graph,
                    const PictureOptions& options = {});

// A curve sketch over a photograph: one color per curve.
Picture DrawOverlay(const Image& photo, const View& view, const CurveSketch& sketch,
                    const PictureOptions& options = {});

// The fragments of one image over it: one color per fragment.
Picture DrawFragments(const Image& photo, const ImageCurves& curves,
                      const PictureOptions& options = {});

// The edgels of one image over it, colored by what became of them: green = drawn or explained by
// the drawing; red = too few views or none support it; orange = depth inconsistent, piece too
// short, support lost or on no traced curve; yellow = too little support for the link; cyan = link
// too short or covered; blue = fragment too short; gray = not linked.
Picture DrawAccount(const Image& photo, const ImageCurves& curves,
                    const std::vector<EdgelFate>& fates, const PictureOptions& options = {});

}  // namespace limn
