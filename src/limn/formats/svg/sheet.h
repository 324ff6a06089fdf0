// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/model/drawing_graph.h"
#include "limn/util/length_unit.h"
#include "limn/visibility/orthographic_depth.h"

namespace limn {

// Parallel projections of a drawing with z up. Those from the sides are upright.
enum class SvgProjection {
  kFront,  // along SheetOptions::front
  kBack,
  kLeft,  // from the left of who sees the front
  kRight,
  kTop,          // from above, the front below
  kBottom,       // from below, the front above
  kAxonometric,  // from `azimuth_deg` and `elevation_deg`
};

struct SheetOptions {
  SvgProjection projection = SvgProjection::kTop;
  // Unit vector, horizontal: along which who sees the front looks.
  Eigen::Vector3d front = Eigen::Vector3d::UnitY();
  // Unit rows right, down and forward of another projection, instead of these.
  std::optional<Eigen::Matrix3d> axes;
  // Viewpoint of an axonometric projection: its direction about z, from the right toward the
  // back, and above the horizon, in [-90, 90]. The default is isometric, from the front right: all
  // three axes are shortened to 0.816.
  double azimuth_deg = -45;
  double elevation_deg = 35.264389682754654;
  // Of the drawing. kNone: the sheet has no scale, only a size that fits on A3.
  LengthUnit unit = LengthUnit::kNone;
  // n of 1:n. 0: the largest scale with n = 1, 2 or 5 times a power of ten that fits on A3. Only of
  // a known unit.
  double sheet_scale = 0;
  // Empty margin around the drawing.
  double margin_mm = 10;
  // A scale bar and the directions of the axes below the drawing.
  bool legend = true;
  // What must be on the sheet besides links and dimensions.
  std::vector<Eigen::Vector3d> more_places;

  // Throws OptionError.
  void Check() const;
};

// In space, without a unit as if it were the meter.
inline double UnitMm(LengthUnit unit) {
  return Millimeters(unit == LengthUnit::kNone ? LengthUnit::kMeter : unit);
}

// A sheet of paper: drawing units along right and down, from its top left corner.
struct SvgSheet {
  // Unit rows: right, down, forward in the world.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  // Subtracted from (right, down): zero except for drawings more than 1000 times as far from the
  // origin as they are large, whose coordinates would have too many digits.
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  // Corners of the paper and of the drawing on it, after subtracting the origin.
  Eigen::Vector2d paper_min = Eigen::Vector2d::Zero();
  Eigen::Vector2d paper_max = Eigen::Vector2d::Zero();
  Eigen::Vector2d drawing_min = Eigen::Vector2d::Zero();
  Eigen::Vector2d drawing_max = Eigen::Vector2d::Zero();
  LengthUnit unit = LengthUnit::kNone;
  double scale_denominator = 1;  // without a unit, as if it were the meter
  // The lower margin has room for a legend.
  bool has_legend = false;

  // Drawing units per millimeter of paper, and per pixel (1/96 inch).
  double mm() const { return scale_denominator / UnitMm(unit); }
  double px() const { return 25.4 / 96 * mm(); }
  Eigen::Vector2d PaperMm() const { return (paper_max - paper_min) / mm(); }
  Eigen::Vector2d ToSheet(const Eigen::Vector3d& point_in_world) const {
    return axes.topRows<2>() * point_in_world - origin;
  }
};

// Throws OptionError, or InputError if there is nothing on the sheet.
SvgSheet MakeSheet(const DrawingGraph& graph, const SheetOptions& options);

// The part of the sheet with the drawing, for a depth image of what hides it: a depth pixel per
// pixel of the sheet, or larger ones if there would be more than 4096 in a row.
OrthographicFrame DepthFrame(const SvgSheet& sheet);

// "1:50", or "20:1" for enlargements; empty without a unit.
std::string ScaleText(const SvgSheet& sheet);

}  // namespace limn
