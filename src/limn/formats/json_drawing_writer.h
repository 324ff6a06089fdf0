// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "limn/formats/json_drawing_reader.h"
#include "limn/model/drawing_graph.h"

namespace limn {

// Writes a drawing as JSON, which ReadDrawingJson reads back without loss:
//   {"format": "limn-drawing", "format_version": 1, "limn_version": "...",
//    of refined cameras "refined_cameras": "...", which names them,
//    "views": [name, ...], "options": {...},
//    in an aligned drawing "world_from_model": {"scale", "rotation": [3 rows], "translation",
//               "unit": "m"|"none", "up_from": "gravity"|"positions"|"lines"|"cameras",
//               "axes_from": "lines"|"positions"|"model"|"plan",
//               "scale_from": "lengths"|"positions"|"none", "scale_sigma", the relative standard
//               deviation of the scale, where known}: world = scale * rotation * position +
//               translation, z up; all positions below are the model's,
//    where cameras are known "main_view_direction": [x, y, z], a unit vector in the model along
//               which most of them look,
//    where there are any, "dimensions": [{"from", "to", "shift"}], each
//               [x, y, z] (model/dimension.h),
//    "nodes": [{"id", "position": [x, y, z], "kind": "end"|"junction"|"loop_anchor", "degree",
//               "covariance" of the position (MeasureNodes) where known: [xx, xy, xz, yy, yz, zz],
//               "incident": [[link, end], ...], "continuations": [[[link, end], [link, end]],
//               ...]}],
//    "links": [{"id", "curve" (CurvesOf), "node0", "node1", "closed", "length", "residual_px",
//               "tri_angle_deg" (TriAngleDeg), "depth_sigma" (DepthSigma) and "curve_px"
//               (MeasureCurves) where known,
//               "evidence" against chance, natural logarithm, and "confidence", the probability
//               that its curve exists (TellConfidences), where known,
//               "kind": "edge"|"paint"|"shadow"|"contour"|"rod"|"texture"|"unknown",
//               "kind_confidence" where known, of a rod "rod_radius", half its thickness,
//               of contours of round bodies "body": {"shape": "cylinder"|"cone", "axis": [from,
//               to], "radii": [at from, at to], ...} or {"shape": "sphere", "center", "radius",
//               ...}, each with "radius_sigma", "rms_px", "tentative": true where it is, then
//               "doubt": "few views"|"chance"|"seen through"|"explained by others"| "outline of a
//               rod"|"depth not measured"|"still in the images"|"short and unlikely" where known,
//               after drawing_fuser also "dense":
//               {"class": "surface"|"boundary"|"free"|"unknown", "added_share", "occluded_share",
//               "behind_surface", "fold_deg" where known}, "primitive": {"type": "line", "start",
//               "end"} or
//                            {"type": "arc"|"circle", "center", "x_axis", "y_axis", "radius",
//                             "sweep_rad"} or
//                            {"type": "spline", "degree": 3, "knots": [...],
//                             "control_points": [...]}, each with "rms_px", "max_px",
//               "supporting_views": [name, ...], "members": [[curve, begin, end], ...],
//               "points": [[x, y, z], ...], "sigma": [..., null = unknown, also if above 1e15]}],
//    where there are surfaces "faces": [{"id", "surface": "plane"|"ruled"|"patch", "area",
//               "confidence", of a plane "normal", "offset", "views": [name, ...],
//               "loops": [[edge, ...], ...] with edge = {"link", "from", "to"} or
//               {"bridge": [[x, y, z], ...]}, "side_starts": [edge, ...] where there are,
//               "vertices": [[x, y, z], ...], "triangles": [[vertex, vertex, vertex], ...]}] as in
//               model/faces.h}
// One node, link or face per line. Throws InputError if a view has no name in the metadata or the
// options are not a JSON object.
void WriteDrawingJson(const DrawingGraph& graph, const DrawingMetadata& metadata,
                      std::ostream& out);

}  // namespace limn
