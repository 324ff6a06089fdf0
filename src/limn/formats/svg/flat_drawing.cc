// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/flat_drawing.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "limn/formats/dimension_lines.h"
#include "limn/formats/svg/link.h"
#include "limn/geometry/shape_part.h"
#include "limn/geometry/similarity3.h"
#include "limn/plans/level_nodes.h"
#include "limn/plans/link_parts.h"

namespace limn {
namespace {

constexpr double kTolerancePx = 0.1;
constexpr double kLeastPx = 0.01;
// Curves turn and grow with their ends if these are apart by this share of their length, and move
// against each other by no more than this share of the way between them.
constexpr double kLeastChord = 0.5;
constexpr double kMostMotion = 0.25;

// Rows x, y and zero.
Eigen::Matrix3d FlatFromWorld(const SvgSheet& sheet) {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
  rows.row(0) = sheet.axes.row(0);
  rows.row(1) = -sheet.axes.row(1);
  return rows;
}

// Whether points run along the straight way between the first and the last, within a tolerance.
bool IsStraight(const Polyline3d& points, double tolerance) {
  const Eigen::Vector3d way = points.back() - points.front();
  if (!(way.norm() > tolerance)) return false;
  const Eigen::Vector3d along = way.normalized();
  double before = 0;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d from_start = point - points.front();
    const double place = from_start.dot(along);
    if ((from_start - place * along).norm() > tolerance || place < before - tolerance) return false;
    before = std::max(before, place);
  }
  return before <= way.norm() + tolerance;
}

struct FlatWay {
  Eigen::Vector3d from, to;
};

// In the plane z = 0: takes one way to another.
Similarity3d Between(const FlatWay& before, const FlatWay& after) {
  const auto complex = [](const FlatWay& way) {
    return std::complex(way.to.x() - way.from.x(), way.to.y() - way.from.y());
  };
  const std::complex<double> ratio = complex(after) / complex(before);
  Similarity3d similarity;
  similarity.scale = std::abs(ratio);
  similarity.rotation =
      Eigen::AngleAxisd(std::arg(ratio), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  similarity.translation = after.from - similarity.scale * (similarity.rotation * before.from);
  return similarity;
}

EllipticalArc Moved(EllipticalArc arc, const Similarity3d& similarity) {
  arc.center = similarity * arc.center;
  arc.major = similarity.scale * (similarity.rotation * arc.major);
  arc.minor = similarity.scale * (similarity.rotation * arc.minor);
  return arc;
}

// A part of a link on the sheet.
struct FlatCurve {
  Polyline3d points;
  std::optional<CurveShape> shape;
  std::optional<EllipticalArc> ellipse;
};

class Flattener {
 public:
  Flattener(const DrawingGraph& graph, const SvgSheet& sheet, bool regularize)
      : sheet_(sheet), tolerance_(kStraightMm * sheet.mm()) {
    for (const DrawingNode& node : graph.nodes) {
      projected_.push_back(FlatPlace(sheet, node.position_in_world));
    }
    places_ = regularize ? Leveled(graph) : projected_;
    visible_ = hidden_ = LinkPartsBuilder(Nodes(graph));
  }

  void Add(const DrawingLink& link, const ShownRun& run, const LinkRuns& runs) {
    FlatCurve curve = Project(link, run, runs.of_shape);
    if (IsTooShort(curve)) return;
    const double first = runs.runs.front().from, last = runs.runs.back().to;
    const auto share = [&](double t) { return (t - first) / (last - first); };
    curve = MovedWithEnds(link, share(run.from), share(run.to), std::move(curve));
    if (IsTooShort(curve)) return;
    const bool has_begin = run.from == first;
    const bool has_end = run.to == last;
    (run.hidden ? hidden_ : visible_)
        .Add(link, has_begin, has_end, {std::move(curve.points), std::move(curve.shape)});
    (run.hidden ? hidden_ellipses_ : visible_ellipses_).push_back(curve.ellipse);
  }

  // Where a place is that may be that of a node.
  Eigen::Vector3d PlaceOf(const Eigen::Vector3d& point_in_world) const {
    const Eigen::Vector3d place = FlatPlace(sheet_, point_in_world);
    const auto node = std::ranges::find_if(projected_, [&](const Eigen::Vector3d& of_node) {
      return (of_node - place).norm() < kLeastPx * sheet_.px();
    });
    return node == projected_.end() ? place : places_[node - projected_.begin()];
  }

  FlatDrawing Build() && {
    FlatDrawing flat;
    flat.visible = {std::move(visible_).Build(), std::move(visible_ellipses_)};
    flat.hidden = {std::move(hidden_).Build(), std::move(hidden_ellipses_)};
    return flat;
  }

 private:
  bool IsTooShort(const FlatCurve& curve) const {
    return Length(curve.points) < kLeastPx * sheet_.px();
  }

  std::vector<DrawingNode> Nodes(const DrawingGraph& graph) const {
    std::vector<DrawingNode> nodes = graph.nodes;
    for (size_t n = 0; n < nodes.size(); ++n) {
      nodes[n].number = NumberOfNode(graph, n);
      nodes[n].position_in_world = places_[n];
      nodes[n].covariance.setZero();
    }
    return nodes;
  }

  std::vector<Eigen::Vector3d> Leveled(const DrawingGraph& graph) const {
    const Eigen::Matrix3d flat_from_world = FlatFromWorld(sheet_);
    std::vector<Eigen::Matrix3d> covariances;
    for (const DrawingNode& node : graph.nodes) {
      covariances.push_back(flat_from_world * node.covariance * flat_from_world.transpose());
    }
    std::vector<FlatLine> lines;
    for (const DrawingLink& link : graph.links) {
      if (IsStraight(Flat(link.points_in_world), tolerance_)) {
        lines.push_back({link.node0, link.node1});
      }
    }
    return LevelNodes(projected_, covariances, lines);
  }

  Polyline3d Flat(Polyline3d points) const {
    for (Eigen::Vector3d& point : points) point = FlatPlace(sheet_, point);
    return points;
  }

  FlatCurve Project(const DrawingLink& link, const ShownRun& run, bool of_shape) const {
    FlatCurve curve;
    if (!of_shape) {
      curve.points = Flat(CutPolyline(link.points_in_world, run.from, run.to));
    } else {
      const CurveShape part = PartOf(link.primitive->shape, run.from, run.to);
      curve.points = Flat(SampleShape(part, kTolerancePx * sheet_.px()));
      std::visit([&](const auto& shape) { Project(shape, &curve); }, part);
    }
    if (IsStraight(curve.points, tolerance_)) {
      curve = {{curve.points.front(), curve.points.back()},
               LineSegment{curve.points.front(), curve.points.back()},
               std::nullopt};
    }
    return curve;
  }

  void Project(const LineSegment& line, FlatCurve* curve) const {
    curve->shape = LineSegment{FlatPlace(sheet_, line.start), FlatPlace(sheet_, line.end)};
  }

  void Project(CubicBSpline spline, FlatCurve* curve) const {
    spline.control_points = Flat(std::move(spline.control_points));
    curve->shape = std::move(spline);
  }

  void Project(const CircularArc& arc, FlatCurve* curve) const {
    const double cosine = std::abs(sheet_.axes.row(2).dot(arc.Normal()));
    const Eigen::Vector3d center = FlatPlace(sheet_, arc.center);
    constexpr double kFrontal = 0.5;  // tiny arcs seen edge-on are none
    if (cosine < kFrontal || arc.radius * (1 - cosine) > kTolerancePx * sheet_.px()) {
      const Eigen::Matrix3d flat_from_world = FlatFromWorld(sheet_);
      const EllipticalArc ellipse =
          ImageOf(arc, flat_from_world, center - flat_from_world * arc.center);
      // Else it is seen edge-on, and drawn by its points.
      if (ellipse.minor.norm() > tolerance_) curve->ellipse = ellipse;
      return;
    }
    CircularArc flat = arc;
    flat.center = center;
    flat.x_axis = (FlatPlace(sheet_, arc.center + arc.x_axis) - center).normalized();
    flat.y_axis = Eigen::Vector3d(-flat.x_axis.y(), flat.x_axis.x(), 0);
    const Eigen::Vector3d y_axis = FlatPlace(sheet_, arc.center + arc.y_axis) - center;
    if (y_axis.dot(flat.y_axis) < 0) flat.y_axis = -flat.y_axis;
    curve->shape = flat;
  }

  // The part of a link between two shares of it, as the link moves with its ends. Where these come
  // near to each other, or away, and it is not rather straight, only its points follow.
  FlatCurve MovedWithEnds(const DrawingLink& link, double begin, double end,
                          FlatCurve curve) const {
    const FlatWay before = {projected_[link.node0], projected_[link.node1]};
    const FlatWay after = {places_[link.node0], places_[link.node1]};
    const Eigen::Vector3d at_start = after.from - before.from, at_end = after.to - before.to;
    if (at_start == at_end) {
      return Moved(std::move(curve), {1, Eigen::Matrix3d::Identity(), at_start});
    }
    if (link.primitive && std::holds_alternative<LineSegment>(link.primitive->shape)) {
      const auto at = [&](double share) -> Eigen::Vector3d {
        return after.from + share * (after.to - after.from);
      };
      return {{at(begin), at(end)}, LineSegment{at(begin), at(end)}, std::nullopt};
    }
    const double chord = (before.to - before.from).norm();
    if (chord >= kLeastChord * Length(Flat(link.points_in_world)) &&
        (at_end - at_start).norm() <= kMostMotion * chord) {
      return Moved(std::move(curve), Between(before, after));
    }
    curve.shape.reset();
    curve.ellipse.reset();
    const auto last = static_cast<double>(curve.points.size() - 1);
    for (size_t i = 0; i < curve.points.size(); ++i) {
      const double share = begin + (end - begin) * static_cast<double>(i) / last;
      curve.points[i] += (1 - share) * at_start + share * at_end;
    }
    return curve;
  }

  static FlatCurve Moved(FlatCurve curve, const Similarity3d& similarity) {
    const auto& [scale, rotation, translation] = similarity;
    for (Eigen::Vector3d& point : curve.points) point = similarity * point;
    if (curve.shape) curve.shape = Transformed(*curve.shape, scale, rotation, translation);
    if (curve.ellipse) curve.ellipse = limn::Moved(*curve.ellipse, similarity);
    return curve;
  }

  const SvgSheet& sheet_;
  double tolerance_;
  std::vector<Eigen::Vector3d> projected_;  // nodes
  std::vector<Eigen::Vector3d> places_;     // and where they are drawn
  LinkPartsBuilder visible_ = LinkPartsBuilder({}), hidden_ = LinkPartsBuilder({});
  std::vector<std::optional<EllipticalArc>> visible_ellipses_, hidden_ellipses_;
};

}  // namespace

Eigen::Vector3d FlatPlace(const SvgSheet& sheet, const Eigen::Vector3d& point_in_world) {
  const Eigen::Vector2d place = sheet.ToSheet(point_in_world);
  return {place.x(), -place.y(), 0};
}

FlatDrawing Flatten(const DrawingGraph& graph, const SvgSheet& sheet, const IsHidden& is_hidden,
                    const FlatOptions& options) {
  Flattener flattener(graph, sheet, options.regularize);
  for (size_t l = 0; l < graph.links.size(); ++l) {
    DrawingLink link = graph.links[l];
    link.number = NumberOfLink(graph, l);
    const LinkRuns runs = RunsOnSheet(sheet, link, is_hidden, {});
    for (const ShownRun& run : runs.runs) {
      if (!run.hidden || options.hidden) flattener.Add(link, run, runs);
    }
  }
  std::vector<DrawingDimension> dimensions;
  std::vector<double> lengths;
  for (const DrawingDimension& dimension : graph.dimensions) {
    const Eigen::Vector3d from = flattener.PlaceOf(dimension.from);
    const Eigen::Vector3d to = flattener.PlaceOf(dimension.to);
    if ((to - from).norm() < sheet.px()) continue;
    const DimensionLines lines = LinesOf(dimension);
    const Eigen::Vector3d shift =
        FlatPlace(sheet, lines.from) - FlatPlace(sheet, lines.measured_from);
    dimensions.push_back({from, to, shift, dimension.sigma});
    lengths.push_back((dimension.to - dimension.from).norm());
  }
  FlatDrawing flat = std::move(flattener).Build();
  flat.visible.graph.dimensions = std::move(dimensions);
  flat.lengths = std::move(lengths);
  return flat;
}

}  // namespace limn
