// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/dxf_drawing_writer.h"

#include <ostream>
#include <sstream>

#include <Eigen/Geometry>

#include "limn/formats/dxf/entities.h"
#include "limn/formats/dxf/layers.h"
#include "limn/formats/dxf/layout.h"
#include "limn/formats/dxf/tables.h"
#include "limn/formats/dxf/writer.h"

namespace limn {
namespace {

// Of the header variable $INSUNITS, by LengthUnit.
constexpr int kUnitCodes[] = {0, 4, 5, 6, 1, 2};

void Extend(const Polyline3d& points, Eigen::AlignedBox3d* extent) {
  for (const Eigen::Vector3d& point : points) extent->extend(point);
}

// Of points, primitives, faces, dimensions and the plan; what an arc has between its samples
// matters for no view.
Eigen::AlignedBox3d ExtentOf(const DrawingGraph& graph, const DxfOptions& options) {
  constexpr int kSamples = 64;
  Eigen::AlignedBox3d extent;
  for (const DrawingLink& link : graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) extent.extend(point);
    if (!link.primitive) continue;
    for (int k = 0; k <= kSamples; ++k) {
      extent.extend(PointAt(link.primitive->shape, static_cast<double>(k) / kSamples));
    }
  }
  for (const DrawingFace& face : graph.faces) {
    for (const Eigen::Vector3d& vertex : face.vertices) extent.extend(vertex);
  }
  for (const DrawingDimension& dimension : graph.dimensions) {
    Extend({dimension.from, dimension.to, dimension.from + dimension.shift,
            dimension.to + dimension.shift},
           &extent);
  }
  if (options.plan) {
    for (const DrawingLink& link : options.plan->hidden.graph.links) {
      Extend(link.points_in_world, &extent);
    }
    for (const SectionLine& line : options.plan->section.lines) Extend(line.points, &extent);
    Extend(options.plan->section.points, &extent);
  }
  return extent;
}

DxfDimensions DimensionsOf(const DrawingGraph& graph, const DxfOptions& options,
                           const Eigen::AlignedBox3d& extent) {
  constexpr double kHeightOfExtent = 0.01, kTextMm = 2.5;
  DxfDimensions dimensions;
  dimensions.text_height =
      options.plan ? kTextMm * options.plan->layout.mm : kHeightOfExtent * extent.diagonal().norm();
  for (size_t i = 0; i < graph.dimensions.size(); ++i) {
    const DrawingDimension& dimension = graph.dimensions[i];
    if (dimension.from == dimension.to) continue;
    const double length =
        options.plan ? options.plan->lengths[i] : (dimension.to - dimension.from).norm();
    dimensions.all.push_back({LinesOf(dimension), length,
                              options.dimension_text.Of(length, dimension.sigma),
                              static_cast<int>(i)});
  }
  return dimensions;
}

// Drawing units per millimeter of line types.
double LineTypeScale(const Eigen::AlignedBox3d& extent, const DxfOptions& options) {
  constexpr double kPaperMm = 400;
  if (options.plan) return options.plan->layout.mm;
  const double size = extent.isEmpty() ? 0 : extent.diagonal().norm();
  return size > 0 ? size / kPaperMm : 1;
}

struct DxfHead {
  Eigen::AlignedBox3d extent;
  LengthUnit unit = LengthUnit::kNone;
  double line_type_scale = 1;
  int next_handle = 1;
};

void PutHeader(const DxfHead& head, DxfWriter* writer) {
  const auto& [extent, unit, line_type_scale, next_handle] = head;
  constexpr double kNowhere = 1e20;  // how AutoCAD says that there is nothing
  const bool empty = extent.isEmpty();
  const bool imperial = unit == LengthUnit::kInch || unit == LengthUnit::kFoot;
  const auto variable = [&](const char* name, int code, auto value) {
    writer->Put(9, name);
    writer->Put(code, value);
  };
  writer->BeginSection("HEADER");
  variable("$ACADVER", 1, "AC1015");
  variable("$DWGCODEPAGE", 3, "ANSI_1252");
  writer->Put(9, "$INSBASE");
  writer->PutPoint(10, Eigen::Vector3d::Zero());
  writer->Put(9, "$EXTMIN");
  writer->PutPoint(10, empty ? Eigen::Vector3d::Constant(kNowhere) : extent.min());
  writer->Put(9, "$EXTMAX");
  writer->PutPoint(10, empty ? Eigen::Vector3d::Constant(-kNowhere) : extent.max());
  variable("$LUNITS", 70, 2);
  variable("$LUPREC", 70, 6);
  variable("$CLAYER", 8, "0");
  variable("$LTSCALE", 40, line_type_scale);
  variable("$PSLTSCALE", 70, 0);  // in windows as in the model
  // Points as small circles, 1 % of the window.
  variable("$PDMODE", 70, 32);
  variable("$PDSIZE", 40, -1.0);
  variable("$MEASUREMENT", 70, imperial ? 0 : 1);
  variable("$INSUNITS", 70, kUnitCodes[static_cast<int>(unit)]);
  writer->Put(9, "$HANDSEED");
  writer->PutHandle(5, next_handle);
  writer->EndSection();
}

}  // namespace

void WriteDrawingDxf(const DrawingGraph& graph, const DxfOptions& options, LengthUnit unit,
                     std::ostream& out) {
  const DxfLayerPlan plan = PlanDxfLayers(graph, options);
  const Eigen::AlignedBox3d extent = ExtentOf(graph, options);
  const DxfDimensions dimensions = DimensionsOf(graph, options, extent);
  // The header says which handle is free after all others.
  std::ostringstream body;
  DxfWriter writer(body);
  int next_handle = 1;
  PutDxfClasses(&writer);
  const DxfSpaces spaces = PutDxfTables(plan.layers, extent, dimensions, &next_handle, &writer);
  PutDxfBlocks(spaces, dimensions, &next_handle, &writer);
  writer.BeginSection("ENTITIES");
  const DxfLayoutRecords& records = spaces.records;
  PutDxfEntities(graph, plan, options.plan, records.model, &next_handle, &writer);
  for (size_t i = 0; i < dimensions.all.size(); ++i) {
    PutDimension(dimensions.all[i], i, dimensions.text_height, records.model, &next_handle,
                 &writer);
  }
  std::optional<DxfLayout> layout;
  if (options.plan && options.paper_space) layout = options.plan->layout;
  if (layout) PutPaperSpace(*layout, extent, records.paper, &next_handle, &writer);
  writer.EndSection();
  PutDxfObjects(spaces, layout, extent, &next_handle, &writer);
  writer.Put(0, "EOF");

  DxfWriter header(out);
  PutHeader({extent, unit, LineTypeScale(extent, options), next_handle}, &header);
  out << body.view();
}

}  // namespace limn
