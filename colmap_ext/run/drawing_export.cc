#include "colmap_ext/run/drawing_export.h"

#include <utility>

#include "colmap_ext/run/alignment_run.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

std::string FormatName(const ExporterOptions& options) {
  return DrawingFormatOf(options.output_path, options.format);
}

// From the coordinates of the model.
Similarity3d FileFromModel(const ExporterOptions& options, const DrawingMetadata& metadata) {
  const Similarity3d by_options = {options.scale, ZUpFrom(options.up_axis),
                                   Eigen::Vector3d::Zero()};
  if (!options.aligned) return by_options;
  return by_options * RequireAlignment(options.input_path, metadata).world_from_model;
}

// An aligned drawing is in meters, unless it is scaled further or the options say otherwise.
LengthUnit UnitOf(const ExporterOptions& options, const DrawingMetadata& metadata) {
  const bool in_meters = options.aligned && metadata.alignment->IsMetric() && options.scale == 1;
  const bool is_open = options.format.unit == LengthUnit::kNone;
  return in_meters && is_open ? LengthUnit::kMeter : options.format.unit;
}

std::vector<GlbPoint> ReadCloud(const std::string& path, const Similarity3d& file_from_model) {
  std::vector<GlbPoint> cloud;
  ReadPlyPoints(path, [&](const PlyPoint& point) {
    const auto& [red, green, blue] = point.color;
    cloud.push_back({file_from_model * point.position, {red, green, blue}});
  });
  return cloud;
}

// What an SVG picture shows of the graph.
SvgScene SceneOf(const ExporterOptions& options, const DrawingGraph& graph,
                 const Similarity3d& file_from_model, Console* console) {
  SvgSource source = options.svg;
  source.style.junctions = options.junctions;
  return source.IsSheet() ? SceneOnSheet(source, graph, file_from_model)
                          : SceneInImage(source, graph, options.output_path, console);
}

void AddFormatOptions(DrawingFormatOptions* format, OptionParser* parser) {
  parser->AddOption(
      "layers", &format->dxf.layers,
      {{"class", DxfLayers::kClass},
       {"kind", DxfLayers::kKind},
       {"component", DxfLayers::kComponent},
       {"single", DxfLayers::kSingle}},
      "DXF: what makes a layer, the shape of the curve (class), the kind of edge or the "
      "connected component");
  parser->AddOption("unit", &format->unit,
                    {{"none", LengthUnit::kNone},
                     {"mm", LengthUnit::kMillimeter},
                     {"cm", LengthUnit::kCentimeter},
                     {"m", LengthUnit::kMeter},
                     {"in", LengthUnit::kInch},
                     {"ft", LengthUnit::kFoot}},
                    BasicOption("DXF and STEP: what one unit is after scaling"));
}

}  // namespace

void ExporterOptions::AddOptions(OptionParser* parser) {
  std::vector<std::string> formats = DrawingFormats();
  formats.insert(formats.begin(), kAutoFormat);
  parser->AddOption("input_path", &input_path, BasicOption("the drawing.json"));
  parser->AddOption("output_path", &output_path, BasicOption("the file to write"));
  parser->AddOption("overwrite", &overwrite, BasicOption(kOverwriteHelp));
  parser->AddOption("output_type", &format.format, formats,
                    BasicOption("its format; auto = by its extension"));
  parser->AddOption("scale", &scale, BasicOption("what coordinates are multiplied by"));
  parser->AddOption("up_axis", &up_axis,
                    {{"x", SignedAxis::kX},
                     {"y", SignedAxis::kY},
                     {"z", SignedAxis::kZ},
                     {"-x", SignedAxis::kMinusX},
                     {"-y", SignedAxis::kMinusY},
                     {"-z", SignedAxis::kMinusZ}},
                    BasicOption("the axis of the model that points up, often -y; it becomes z"));
  parser->AddOption("aligned", &aligned,
                    BasicOption("in the world, as drawing_aligner or --align auto found it: z up, "
                                "in meters if the scale is known"));
  parser->AddOption("junctions", &junctions,
                    "DXF, GLB and SVG: junctions as points on their own layer");
  selection.AddOptions(parser);
  AddFormatOptions(&format, parser);
  parser->AddOption("cloud_path", &cloud_path, BasicOption("GLB: a cloud to go with it, .ply"));
  svg.AddOptions(parser);
}

void ExporterOptions::Check() const {
  if (input_path.empty()) throw OptionError("--input_path must be given");
  if (output_path.empty()) throw OptionError("--output_path must be given");
  selection.Selection();  // throws
  LIMN_CHECK_RANGE(scale, >= 1e-12, <= 1e12);
  if (aligned && up_axis != SignedAxis::kZ) {
    throw OptionError("up_axis: z is up in an aligned drawing");
  }
  if (!cloud_path.empty() && FormatName(*this) != "glb") {
    throw OptionError("cloud_path: only .glb files hold a cloud");
  }
  if (FormatName(*this) != "svg") return;
  svg.Check();
  if (!svg.IsSheet() && (scale != 1 || up_axis != SignedAxis::kZ || aligned)) {
    throw OptionError("scale, up_axis and aligned: the picture of an image is in its pixels");
  }
}

ExportedDrawing PrepareExport(const ExporterOptions& options, Console* console) {
  const DenseOptionsPaths& dense = options.svg.dense;
  CheckNamedOutput(options.output_path, {options.input_path, options.cloud_path, dense.dense_path},
                   options.overwrite);
  ExportedDrawing exported = {ReadDrawingJson(options.input_path), options.format};
  DrawingGraph& graph = exported.drawing.graph;
  graph = Selected(std::move(graph), options.selection.Selection());
  DrawingFormatOptions& format = exported.format;
  DrawingMetadata& metadata = exported.drawing.metadata;
  const Similarity3d file_from_model = FileFromModel(options, metadata);
  const auto& [scale, rotation, translation] = file_from_model;
  graph = Transformed(std::move(graph), scale, rotation, translation);
  format.unit = UnitOf(options, metadata);
  if (metadata.alignment) metadata.alignment = After(file_from_model, *metadata.alignment);
  format.dxf.junctions = format.glb.junctions = options.junctions;
  if (!options.cloud_path.empty())
    format.glb.cloud = ReadCloud(options.cloud_path, file_from_model);
  if (FormatName(options) == "svg") {
    SvgScene scene = SceneOf(options, graph, file_from_model, console);
    format.svg = std::move(scene.picture);
    graph = std::move(scene.graph);
  }
  return exported;
}

}  // namespace limn::colmap_ext
