#include <iostream>
#include <utility>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/run/svg_source.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/formats/write_drawing.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

struct ExporterOptions {
  std::string input_path, output_path;
  bool junctions = true;
  std::string cloud_path;
  DrawingFormatOptions format;
  double scale = 1;
  SignedAxis up_axis = SignedAxis::kZ;
  SvgSource svg;
};

void AddOptions(ExporterOptions* options, OptionParser* parser) {
  std::vector<std::string> formats = DrawingFormats();
  formats.insert(formats.begin(), kAutoFormat);
  parser->AddOption("input_path", &options->input_path, "the drawing.json");
  parser->AddOption("output_path", &options->output_path, "the file to write");
  parser->AddOption("output_type", &options->format.format, formats,
                    "its format; auto = by its extension");
  parser->AddOption("scale", &options->scale, "what coordinates are multiplied by");
  parser->AddOption("up_axis", &options->up_axis,
                    {{"x", SignedAxis::kX},
                     {"y", SignedAxis::kY},
                     {"z", SignedAxis::kZ},
                     {"-x", SignedAxis::kMinusX},
                     {"-y", SignedAxis::kMinusY},
                     {"-z", SignedAxis::kMinusZ}},
                    "the axis of the model that points up, often -y; it becomes z");
  DxfOptions& dxf = options->format.dxf;
  parser->AddOption("layers", &dxf.layers,
                    {{"class", DxfLayers::kClass},
                     {"component", DxfLayers::kComponent},
                     {"single", DxfLayers::kSingle}},
                    "DXF: what makes a layer, the kind of curve or the connected component");
  parser->AddOption("junctions", &options->junctions,
                    "DXF, GLB and SVG: junctions as points on their own layer");
  parser->AddOption("unit", &options->format.unit,
                    {{"none", LengthUnit::kNone},
                     {"mm", LengthUnit::kMillimeter},
                     {"cm", LengthUnit::kCentimeter},
                     {"m", LengthUnit::kMeter},
                     {"in", LengthUnit::kInch},
                     {"ft", LengthUnit::kFoot}},
                    "DXF and STEP: what one unit is after scaling");
  parser->AddOption("cloud_path", &options->cloud_path, "GLB: a cloud to go with it, .ply");
  options->svg.AddOptions(parser);
}

bool IsSvg(const ExporterOptions& options) {
  return DrawingFormatOf(options.output_path, options.format) == "svg";
}

// Scaled and turned as the drawing is.
std::vector<GlbPoint> ReadCloud(const ExporterOptions& options) {
  std::vector<GlbPoint> cloud;
  const Eigen::Matrix3d z_up = ZUpFrom(options.up_axis);
  ReadPlyPoints(options.cloud_path, [&](const PlyPoint& point) {
    const auto& [red, green, blue] = point.color;
    cloud.push_back({options.scale * (z_up * point.position), {red, green, blue}});
  });
  return cloud;
}

// What an SVG picture shows instead of the graph, and how.
void SetUpSvg(ExporterOptions* options, DrawingGraph* graph) {
  SvgScene scene =
      options->svg.IsSheet()
          ? SceneOnSheet(options->svg, *graph, ZUpFrom(options->up_axis), options->scale)
          : SceneInImage(options->svg, *graph, options->output_path);
  options->format.svg = std::move(scene.picture);
  *graph = std::move(scene.graph);
}

void Check(const ExporterOptions& options) {
  if (options.input_path.empty()) throw OptionError("--input_path must be given");
  if (options.output_path.empty()) throw OptionError("--output_path must be given");
  CheckOption(options.scale > 0, "scale", options.scale, "> 0");
  if (!options.cloud_path.empty() &&
      DrawingFormatOf(options.output_path, options.format) != "glb") {
    throw OptionError("cloud_path: only .glb files hold a cloud");
  }
  if (!IsSvg(options)) return;
  options.svg.Check();
  if (!options.svg.IsSheet() && (options.scale != 1 || options.up_axis != SignedAxis::kZ)) {
    throw OptionError("scale and up_axis: the picture of an image is in its pixels");
  }
}

}  // namespace

int RunDrawingExporter(int argc, const char* const* argv) {
  ExporterOptions options;
  OptionParser parser("drawing_exporter", "write a drawing in the format of another program");
  AddOptions(&options, &parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  Check(options);
  DrawingFile drawing = ReadDrawingJson(options.input_path);
  drawing.graph = Transformed(std::move(drawing.graph), options.scale, ZUpFrom(options.up_axis),
                              Eigen::Vector3d::Zero());
  options.format.dxf.junctions = options.format.glb.junctions = options.junctions;
  options.svg.style.junctions = options.junctions;
  if (!options.cloud_path.empty()) options.format.glb.cloud = ReadCloud(options);
  if (IsSvg(options)) SetUpSvg(&options, &drawing.graph);
  WriteDrawing(options.output_path, drawing.graph, drawing.metadata, options.format);
  std::cout << "Written: " << options.output_path << " (" << drawing.graph.links.size()
            << " links)\n";
  return 0;
}

}  // namespace limn::colmap_ext
