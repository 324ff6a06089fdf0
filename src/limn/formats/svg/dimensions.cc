// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/dimensions.h"

#include <cmath>
#include <numbers>
#include <ostream>

#include <Eigen/Geometry>

#include "limn/formats/svg/path.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// Pixels.
constexpr double kTickPx = 4;
constexpr double kOvershootPx = 4;
constexpr double kTextPx = 3;  // above the line

// A dimension on the picture.
struct FlatLines {
  Eigen::Vector2d measured_from, measured_to, from, to;
};

std::optional<FlatLines> Flat(const DimensionLines& lines, const DimensionPicture& picture) {
  const auto measured_from = picture.place_of(lines.measured_from);
  const auto measured_to = picture.place_of(lines.measured_to);
  const auto from = picture.place_of(lines.from);
  const auto to = picture.place_of(lines.to);
  if (!measured_from || !measured_to || !from || !to) return std::nullopt;
  if ((*to - *from).norm() < picture.px) return std::nullopt;
  return FlatLines{*measured_from, *measured_to, *from, *to};
}

// A line from a place to the dimension line and a little farther.
void PutWitness(const Eigen::Vector2d& place, const Eigen::Vector2d& end, double px,
                SvgPath* path) {
  const double length = (end - place).norm();
  if (length < px) return;
  path->MoveTo(place);
  path->LineTo(end + kOvershootPx * px / length * (end - place));
}

double TextAngle(const Eigen::Vector2d& way) {
  // y is down: text that goes up is read from the right.
  double degrees = Degrees(std::atan2(way.y(), way.x()));
  if (degrees >= 90) degrees -= 180;
  if (degrees < -90) degrees += 180;
  return degrees;
}

void Put(const FlatLines& flat, const std::string& text, const DimensionPicture& picture,
         std::ostream& out) {
  SvgPath path(picture.decimals);
  PutWitness(flat.measured_from, flat.from, picture.px, &path);
  PutWitness(flat.measured_to, flat.to, picture.px, &path);
  path.MoveTo(flat.from);
  path.LineTo(flat.to);
  const Eigen::Vector2d way = (flat.to - flat.from).normalized();
  const Eigen::Vector2d tick =
      kTickPx * picture.px * (Eigen::Rotation2Dd(-0.25 * std::numbers::pi) * way);
  for (const Eigen::Vector2d& end : {flat.from, flat.to}) {
    path.MoveTo(end - tick);
    path.LineTo(end + tick);
  }
  const Eigen::Vector2d middle = 0.5 * (flat.from + flat.to);
  // Renderers lay text out badly in sizes far below a unit.
  out << "<path d=\"" << path.text() << "\"/><text transform=\"translate("
      << SvgNumber(middle.x(), picture.decimals) << ' ' << SvgNumber(middle.y(), picture.decimals)
      << ") rotate(" << SvgNumber(TextAngle(way), 3) << ") scale("
      << SvgNumber(picture.px, DecimalsFor(1e-3 * picture.px)) << ")\" y=\""
      << SvgNumber(-kTextPx, 2) << "\">" << XmlEscaped(text) << "</text>";
}

}  // namespace

void WriteDimensions(const std::vector<DrawingDimension>& dimensions,
                     const DimensionPicture& picture, std::ostream& out) {
  out << "<g id=\"dimensions\">\n";
  for (size_t i = 0; i < dimensions.size(); ++i) {
    const double length = (dimensions[i].to - dimensions[i].from).norm();
    if (length == 0) continue;
    const auto flat = Flat(LinesOf(dimensions[i]), picture);
    if (!flat) continue;
    out << "<g id=\"dimension_" << i << "\">";
    Put(*flat, picture.text.Of(length, dimensions[i].sigma), picture, out);
    out << "</g>\n";
  }
  out << "</g>\n";
}

}  // namespace limn
