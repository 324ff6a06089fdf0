#include "limn/export/svg_legend.h"

#include <cmath>
#include <ostream>
#include <string>

#include "limn/export/svg_path.h"

namespace limn {
namespace {

constexpr double kTextMm = 3;
constexpr double kTickMm = 1.5;
constexpr double kArrowMm = 8;
constexpr double kDotMm = 0.6;

// The largest of 1, 2 and 5 times a power of ten that is not above the value.
double RoundDown(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value * (1 + 1e-9)) return factor * power;
  }
  return power;
}

std::string LengthText(double meters) {
  if (meters >= 1000) return ShortNumber(meters / 1000, 3) + " km";
  if (meters >= 1) return ShortNumber(meters, 3) + " m";
  if (meters >= 0.01) return ShortNumber(100 * meters, 3) + " cm";
  if (meters >= 0.001) return ShortNumber(1000 * meters, 3) + " mm";
  return ShortNumber(1e6 * meters, 3) + " \xc2\xb5m";
}

class LegendWriter {
 public:
  LegendWriter(const SvgSheet& sheet, std::ostream& out)
      : sheet_(sheet), decimals_(DecimalsFor(0.01 * sheet.px())), out_(out) {}

  void Write() {
    out_ << "<g id=\"legend\">\n";
    PutScaleBar();
    PutAxes();
    out_ << "</g>\n";
  }

 private:
  // mm from the lower left corner of the paper, right and up.
  Eigen::Vector2d FromLeft(double right_mm, double up_mm) const {
    return {sheet_.paper_min.x() + right_mm * sheet_.mm(),
            sheet_.paper_max.y() - up_mm * sheet_.mm()};
  }

  std::string Number(double value) const { return ShortNumber(value, decimals_); }

  void PutText(const Eigen::Vector2d& at, const char* anchor, const std::string& text) {
    out_ << "<text x=\"" << Number(at.x()) << "\" y=\"" << Number(at.y()) << "\" text-anchor=\""
         << anchor << "\">" << XmlEscaped(text) << "</text>\n";
  }

  void PutPath(const SvgPath& path) { out_ << "<path d=\"" << path.text() << "\"/>\n"; }

  void PutScaleBar() {
    constexpr double kLeftMm = 5;
    constexpr double kBarMm = 5;
    const double length = RoundDown((sheet_.paper_max.x() - sheet_.paper_min.x()) / 3);
    const Eigen::Vector2d start = FromLeft(kLeftMm, kBarMm);
    const Eigen::Vector2d end = start + Eigen::Vector2d(length, 0);
    const Eigen::Vector2d tick(0, -kTickMm * sheet_.mm());
    SvgPath path(decimals_);
    path.MoveTo(start + tick);
    path.LineTo(start);
    path.LineTo(end);
    path.LineTo(end + tick);
    PutPath(path);
    PutText(start + 2 * tick, "start", ScaleText(sheet_.scale_denominator));
    PutText(end + 2 * tick, "end", LengthText(length));
  }

  void PutAxes() {
    // Room for arrows to all sides.
    constexpr double kRightMm = 14;
    constexpr double kUpMm = 8;
    const Eigen::Vector2d origin =
        sheet_.paper_max - sheet_.mm() * Eigen::Vector2d(kRightMm, kUpMm);
    const char* names[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector2d arrow = kArrowMm * sheet_.mm() * sheet_.axes.col(axis).head<2>();
      PutAxis(origin, arrow, names[axis]);
    }
  }

  void PutAxis(const Eigen::Vector2d& origin, const Eigen::Vector2d& arrow, const char* name) {
    const double length = arrow.norm();
    if (length < 2 * kDotMm * sheet_.mm()) {
      out_ << "<circle cx=\"" << Number(origin.x()) << "\" cy=\"" << Number(origin.y()) << "\" r=\""
           << Number(kDotMm * sheet_.mm()) << "\"/>\n";
      PutText(origin + sheet_.mm() * Eigen::Vector2d(-2, 1), "middle", name);
      return;
    }
    const Eigen::Vector2d tip = origin + arrow;
    const Eigen::Vector2d back = -kTickMm * sheet_.mm() / length * arrow;
    const Eigen::Vector2d aside(-0.4 * back.y(), 0.4 * back.x());
    SvgPath path(decimals_);
    path.MoveTo(origin);
    path.LineTo(tip);
    path.MoveTo(tip + back + aside);
    path.LineTo(tip);
    path.LineTo(tip + back - aside);
    PutPath(path);
    const Eigen::Vector2d beyond = tip + 2 * sheet_.mm() / length * arrow;
    // Half the height of a small letter below its middle.
    PutText(beyond + Eigen::Vector2d(0, 0.25 * kTextMm * sheet_.mm()), "middle", name);
  }

  const SvgSheet& sheet_;
  int decimals_;
  std::ostream& out_;
};

}  // namespace

void WriteLegend(const SvgSheet& sheet, std::ostream& out) { LegendWriter(sheet, out).Write(); }

}  // namespace limn
