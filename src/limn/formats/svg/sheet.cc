// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/sheet.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "limn/formats/svg/path.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Paper that a scale is chosen for: A3, less a usual printer's border.
constexpr double kPaperWidthMm = 400;
constexpr double kPaperHeightMm = 277;
constexpr double kLegendHeightMm = 16;
constexpr double kLeastPaperMm = 1;
constexpr double kLargestPaperMm = 100'000;
// Room for the legend below narrow drawings.
constexpr double kLegendWidthMm = 60;
// As for models: a drawing farther from the origin than this many times its size is moved there.
constexpr double kFar = 1000;

Eigen::Matrix3d Axes(const Eigen::Vector3d& right, const Eigen::Vector3d& up) {
  Eigen::Matrix3d axes;
  axes << right.transpose(), -up.transpose(), -right.cross(up).transpose();
  return axes;
}

Eigen::Matrix3d AxesOf(const SheetOptions& options) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d back = options.front;
  const Eigen::Vector3d right = back.cross(up);
  switch (options.projection) {
    case SvgProjection::kFront:
      return Axes(right, up);
    case SvgProjection::kBack:
      return Axes(-right, up);
    case SvgProjection::kLeft:
      return Axes(-back, up);
    case SvgProjection::kRight:
      return Axes(back, up);
    case SvgProjection::kTop:
      return Axes(right, back);
    case SvgProjection::kBottom:
      return Axes(right, -back);
    case SvgProjection::kAxonometric:
      break;
  }
  const double azimuth = options.azimuth_deg * kDeg;
  const double elevation = options.elevation_deg * kDeg;
  const Eigen::Vector3d level = std::cos(azimuth) * right + std::sin(azimuth) * back;
  return Axes(-std::sin(azimuth) * right + std::cos(azimuth) * back,
              std::cos(elevation) * up - std::sin(elevation) * level);
}

Eigen::AlignedBox2d BoxOf(const DrawingGraph& graph, const std::vector<Eigen::Vector3d>& places,
                          const Eigen::Matrix3d& axes) {
  Eigen::AlignedBox2d box;
  const auto extend = [&](const Eigen::Vector3d& point) {
    box.extend(Eigen::Vector2d(axes.topRows<2>() * point));
  };
  for (const DrawingLink& link : graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) extend(point);
  }
  for (const DrawingDimension& dimension : graph.dimensions) {
    for (const Eigen::Vector3d& place : {dimension.from, dimension.to}) {
      extend(place);
      extend(place + dimension.shift);
    }
  }
  for (const Eigen::Vector3d& place : places) extend(place);
  return box;
}

// The smallest of 1, 2 and 5 times a power of ten that is not below the value.
double RoundUp(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (value <= factor * power * (1 + 1e-9)) return factor * power;
  }
  return 10 * power;
}

double FittingDenominator(const Eigen::Vector2d& extent, const SheetOptions& options) {
  const double legend = options.legend ? kLegendHeightMm : 0;
  const double width = kPaperWidthMm - 2 * options.margin_mm;
  const double height = kPaperHeightMm - 2 * options.margin_mm - legend;
  const double needed = UnitMm(options.unit) * std::max(extent.x() / width, extent.y() / height);
  return needed > 0 ? RoundUp(needed) : 1;  // a single line that is seen from its end
}

}  // namespace

void SheetOptions::Check() const {
  LIMN_CHECK_RANGE(azimuth_deg, >= -360, <= 360);
  LIMN_CHECK_RANGE(elevation_deg, >= -90, <= 90);
  LIMN_CHECK_RANGE(sheet_scale, >= 0, <= 1e9);
  LIMN_CHECK_RANGE(margin_mm, >= 0, <= 100);
}

SvgSheet MakeSheet(const DrawingGraph& graph, const SheetOptions& options) {
  options.Check();
  CheckOption(options.sheet_scale == 0 || options.unit != LengthUnit::kNone, "sheet_scale",
              options.sheet_scale,
              "0 while the unit of the drawing is not known: --unit tells it (without --scale), or "
              "drawing_aligner --known_length finds it (--aligned 1)");
  SvgSheet sheet;
  sheet.axes = options.axes ? *options.axes : AxesOf(options);
  const Eigen::AlignedBox2d box = BoxOf(graph, options.more_places, sheet.axes);
  if (box.isEmpty()) throw InputError("the drawing has no links");
  const Eigen::Vector2d extent = box.sizes();
  if (box.center().norm() > kFar * extent.norm()) sheet.origin = box.center().array().round();
  sheet.unit = options.unit;
  sheet.scale_denominator =
      options.sheet_scale > 0 ? options.sheet_scale : FittingDenominator(extent, options);
  sheet.drawing_min = box.min() - sheet.origin;
  sheet.drawing_max = box.max() - sheet.origin;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(options.margin_mm * sheet.mm());
  sheet.paper_min = sheet.drawing_min - margin;
  sheet.paper_max = sheet.drawing_max + margin;
  // Paper has an extent even if the drawing has none.
  sheet.paper_max = sheet.paper_max.cwiseMax(sheet.paper_min +
                                             Eigen::Vector2d::Constant(kLeastPaperMm * sheet.mm()));
  sheet.has_legend = options.legend;
  if (options.legend) {
    sheet.paper_max.y() += kLegendHeightMm * sheet.mm();
    sheet.paper_max.x() =
        std::max(sheet.paper_max.x(), sheet.paper_min.x() + kLegendWidthMm * sheet.mm());
  }
  CheckOption(sheet.PaperMm().maxCoeff() <= kLargestPaperMm, "sheet_scale", sheet.scale_denominator,
              "such that the sheet is no larger than 100 m");
  return sheet;
}

OrthographicFrame DepthFrame(const SvgSheet& sheet) {
  constexpr double kMaxCells = 4096;
  OrthographicFrame frame;
  frame.axes = sheet.axes;
  frame.min = sheet.drawing_min + sheet.origin;
  frame.max = sheet.drawing_max + sheet.origin;
  frame.cell = std::max(sheet.px(), (frame.max - frame.min).maxCoeff() / kMaxCells);
  return frame;
}

std::string ScaleText(const SvgSheet& sheet) {
  if (sheet.unit == LengthUnit::kNone) return "";
  const double n = sheet.scale_denominator;
  const bool enlarged = n < 1;
  const std::string number = SvgNumber(enlarged ? 1 / n : n, 2);
  return enlarged ? number + ":1" : "1:" + number;
}

}  // namespace limn
