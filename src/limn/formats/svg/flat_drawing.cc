#include "limn/formats/svg/flat_drawing.h"

#include <cmath>
#include <optional>
#include <utility>

#include "limn/formats/dimension_lines.h"
#include "limn/formats/svg/link.h"
#include "limn/geometry/shape_part.h"
#include "limn/plans/link_parts.h"

namespace limn {
namespace {

constexpr double kTolerancePx = 0.1;
constexpr double kLeastPx = 0.01;

class Flattener {
 public:
  Flattener(const DrawingGraph& graph, const SvgSheet& sheet)
      : sheet_(sheet), parts_(Nodes(graph)) {}

  void Add(const DrawingLink& link, const ShownRun& run, const LinkRuns& runs) {
    const bool has_begin = run.from == runs.runs.front().from;
    const bool has_end = run.to == runs.runs.back().to;
    std::optional<CurveShape> shape;
    Polyline3d points;
    if (runs.of_shape) {
      const CurveShape part = PartOf(link.primitive->shape, run.from, run.to);
      points = Flat(SampleShape(part, kTolerancePx * sheet_.px()));
      shape = std::visit([&](const auto& s) { return FlatShape(s); }, part);
    } else {
      points = Flat(CutPolyline(link.points_in_world, run.from, run.to));
    }
    if (Length(points) < kLeastPx * sheet_.px()) return;
    if (run.hidden) {
      hidden_.push_back(std::move(points));
    } else {
      parts_.Add(link, has_begin, has_end, {std::move(points), std::move(shape)});
    }
  }

  FlatDrawing Build() && {
    FlatDrawing flat;
    flat.graph = std::move(parts_).Build();
    flat.hidden = std::move(hidden_);
    return flat;
  }

 private:
  std::vector<DrawingNode> Nodes(const DrawingGraph& graph) const {
    std::vector<DrawingNode> nodes = graph.nodes;
    for (DrawingNode& node : nodes) {
      node.position_in_world = FlatPlace(sheet_, node.position_in_world);
    }
    return nodes;
  }

  Polyline3d Flat(Polyline3d points) const {
    for (Eigen::Vector3d& point : points) point = FlatPlace(sheet_, point);
    return points;
  }

  std::optional<CurveShape> FlatShape(const LineSegment& line) const {
    return LineSegment{FlatPlace(sheet_, line.start), FlatPlace(sheet_, line.end)};
  }

  std::optional<CurveShape> FlatShape(CubicBSpline spline) const {
    spline.control_points = Flat(std::move(spline.control_points));
    return spline;
  }

  // Nothing if it is an ellipse on the sheet.
  std::optional<CurveShape> FlatShape(const CircularArc& arc) const {
    const double cosine = std::abs(sheet_.axes.row(2).dot(arc.Normal()));
    if (arc.radius * (1 - cosine) > kTolerancePx * sheet_.px()) return std::nullopt;
    const Eigen::Vector3d center = FlatPlace(sheet_, arc.center);
    CircularArc flat = arc;
    flat.center = center;
    flat.x_axis = (FlatPlace(sheet_, arc.center + arc.x_axis) - center).normalized();
    flat.y_axis = Eigen::Vector3d(-flat.x_axis.y(), flat.x_axis.x(), 0);
    const Eigen::Vector3d y_axis = FlatPlace(sheet_, arc.center + arc.y_axis) - center;
    if (y_axis.dot(flat.y_axis) < 0) flat.y_axis = -flat.y_axis;
    return flat;
  }

  const SvgSheet& sheet_;
  LinkPartsBuilder parts_;
  std::vector<Polyline3d> hidden_;
};

}  // namespace

Eigen::Vector3d FlatPlace(const SvgSheet& sheet, const Eigen::Vector3d& point_in_world) {
  const Eigen::Vector2d place = sheet.ToSheet(point_in_world);
  return {place.x(), -place.y(), 0};
}

FlatDrawing Flatten(const DrawingGraph& graph, const SvgSheet& sheet, const IsHidden& is_hidden,
                    bool with_hidden) {
  Flattener flattener(graph, sheet);
  for (const DrawingLink& link : graph.links) {
    const LinkRuns runs = RunsOnSheet(sheet, link, is_hidden, {});
    for (const ShownRun& run : runs.runs) {
      if (!run.hidden || with_hidden) flattener.Add(link, run, runs);
    }
  }
  FlatDrawing flat = std::move(flattener).Build();
  for (const DrawingDimension& dimension : graph.dimensions) {
    const Eigen::Vector3d from = FlatPlace(sheet, dimension.from);
    const Eigen::Vector3d to = FlatPlace(sheet, dimension.to);
    if ((to - from).norm() < sheet.px()) continue;
    const DimensionLines lines = LinesOf(dimension);
    flat.graph.dimensions.push_back({from, to, FlatPlace(sheet, lines.from) - from});
    flat.lengths.push_back((dimension.to - dimension.from).norm());
  }
  return flat;
}

}  // namespace limn
