// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/legend.h"

#include <cmath>
#include <ostream>
#include <string>

#include "limn/formats/svg/path.h"

namespace limn {
namespace {

// Pixels of the sheet, the unit of the legend: renderers lay text out badly in sizes far below one.
constexpr double kMm = 96 / 25.4;
constexpr double kLegendTickPx = 1.5 * kMm;
constexpr double kArrowPx = 8 * kMm;
constexpr double kDotPx = 0.6 * kMm;
constexpr int kDecimals = 2;

// The largest of 1, 2 and 5 times a power of ten that is not above the value.
double RoundDown(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value * (1 + 1e-9)) return factor * power;
  }
  return power;
}

std::string LengthText(double length, LengthUnit unit) {
  if (unit == LengthUnit::kNone) return SvgNumber(length, 6) + " model units";
  if (unit == LengthUnit::kInch || unit == LengthUnit::kFoot) {
    return SvgNumber(length, 3) + ' ' + UnitName(unit);
  }
  const double meters = length * Millimeters(unit) / 1000;
  if (meters >= 1000) return SvgNumber(meters / 1000, 3) + " km";
  if (meters >= 1) return SvgNumber(meters, 3) + " m";
  if (meters >= 0.01) return SvgNumber(100 * meters, 3) + " cm";
  if (meters >= 0.001) return SvgNumber(1000 * meters, 3) + " mm";
  return SvgNumber(1e6 * meters, 3) + " \xc2\xb5m";
}

std::string Number(double value) { return SvgNumber(value, kDecimals); }

// In pixels from the lower left corner of the paper, x right and y down.
class LegendWriter {
 public:
  LegendWriter(const SvgSheet& sheet, std::ostream& out)
      : sheet_(sheet), width_px_((sheet.paper_max - sheet.paper_min).x() / sheet.px()), out_(out) {}

  void Write() {
    const int decimals = DecimalsFor(0.01 * sheet_.px());
    // Enough digits for the width of the paper.
    const int scale_decimals = DecimalsFor(0.01 * sheet_.px() / width_px_);
    out_ << "<g id=\"legend\" transform=\"translate(" << SvgNumber(sheet_.paper_min.x(), decimals)
         << ' ' << SvgNumber(sheet_.paper_max.y(), decimals) << ") scale("
         << SvgNumber(sheet_.px(), scale_decimals) << ")\">\n";
    PutScaleBar();
    PutAxes();
    out_ << "</g>\n";
  }

 private:
  void PutText(const Eigen::Vector2d& at, const char* anchor, const std::string& text) {
    out_ << "<text x=\"" << Number(at.x()) << "\" y=\"" << Number(at.y()) << "\" text-anchor=\""
         << anchor << "\">" << XmlEscaped(text) << "</text>\n";
  }

  void PutPath(const SvgPath& path) { out_ << "<path d=\"" << path.text() << "\"/>\n"; }

  void PutScaleBar() {
    const double length = RoundDown(width_px_ * sheet_.px() / 3);
    const Eigen::Vector2d start(5 * kMm, -5 * kMm);
    const Eigen::Vector2d end = start + Eigen::Vector2d(length / sheet_.px(), 0);
    const Eigen::Vector2d tick(0, -kLegendTickPx);
    SvgPath path(kDecimals);
    path.MoveTo(start + tick);
    path.LineTo(start);
    path.LineTo(end);
    path.LineTo(end + tick);
    PutPath(path);
    PutText(start + 1.5 * tick, "start", ScaleText(sheet_));
    PutText(end + 1.5 * tick, "end", LengthText(length, sheet_.unit));
  }

  void PutAxes() {
    // Room for arrows to all sides.
    const Eigen::Vector2d origin(width_px_ - 14 * kMm, -10 * kMm);
    const char* names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
      PutAxis(origin, kArrowPx * sheet_.axes.col(axis).head<2>(), names[axis]);
    }
  }

  void PutAxis(const Eigen::Vector2d& origin, const Eigen::Vector2d& arrow, const char* name) {
    // Half the height of a small letter below its middle.
    const Eigen::Vector2d below(0, 0.25 * kLegendTextPx);
    const double length = arrow.norm();
    if (length < 2 * kDotPx) {
      out_ << "<circle cx=\"" << Number(origin.x()) << "\" cy=\"" << Number(origin.y()) << "\" r=\""
           << Number(kDotPx) << "\"/>\n";
      PutText(origin + kMm * Eigen::Vector2d(-2, 2) + below, "middle", name);
      return;
    }
    const Eigen::Vector2d tip = origin + arrow;
    const Eigen::Vector2d back = -kLegendTickPx / length * arrow;
    const Eigen::Vector2d aside(-0.4 * back.y(), 0.4 * back.x());
    SvgPath path(kDecimals);
    path.MoveTo(origin);
    path.LineTo(tip);
    path.MoveTo(tip + back + aside);
    path.LineTo(tip);
    path.LineTo(tip + back - aside);
    PutPath(path);
    PutText(tip + 2 * kMm / length * arrow + below, "middle", name);
  }

  const SvgSheet& sheet_;
  double width_px_;
  std::ostream& out_;
};

}  // namespace

void WriteLegend(const SvgSheet& sheet, std::ostream& out) { LegendWriter(sheet, out).Write(); }

}  // namespace limn
