// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/export_drawing.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>
#include <variant>

#include "colmap_ext/host/plugin.h"
#include "colmap_ext/import/new_model_folder.h"
#include "colmap_ext/options/option_group.h"
#include "colmap_ext/verbs/curves_in_model.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/limap_model.h"
#include "colmap_ext/workspace/output_check.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/alignment/drawing_span.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/formats/svg/svg_drawing_writer.h"
#include "limn/geometry/curve_shape.h"
#include "limn/model/curve_set.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

// A model of LIMAP or COLMAP, in a folder: the formats that go with cameras.
constexpr const char* kLimapFormat = "limap";
constexpr const char* kColmapFormat = "colmap";

bool IsModel(const std::string& format) {
  return format == kLimapFormat || format == kColmapFormat;
}

std::string FormatName(const ExporterOptions& options) {
  if (IsModel(options.format.format)) return options.format.format;
  return DrawingFormatOf(options.output_path, options.format);
}

// Neither turned nor scaled.
bool IsInModel(const ExporterOptions& options) {
  const std::string name = FormatName(options);
  return IsModel(name) || (name == "svg" && !options.svg.IsSheet());
}

bool IsMetric(const DrawingMetadata& metadata) {
  return metadata.alignment && metadata.alignment->IsMetric();
}

// The coordinates of the file.
struct FileFrame {
  Similarity3d from_model;
  double units_per_world_unit = 1;
  LengthUnit unit = LengthUnit::kNone;
};

double UnitsPerMeter(LengthUnit unit) {
  return Millimeters(LengthUnit::kMeter) / Millimeters(unit);
}

// Of a drawing whose scale is known. kNone: the unit is that of the model, or the scale is another.
LengthUnit KnownUnit(const ExporterOptions& options) {
  const LengthUnit unit = options.format.unit;
  if (unit == LengthUnit::kNone) {
    const bool is_in_meters = options.IsAligned() || FormatName(options) == "glb";
    return is_in_meters && options.scale == 1 ? LengthUnit::kMeter : LengthUnit::kNone;
  }
  const bool agrees = std::abs(options.scale / UnitsPerMeter(unit) - 1) < 1e-9;
  if (options.scale == 1 || agrees) return unit;
  throw OptionError("scale = " + ShortNumber(options.scale) + " and unit = " + UnitName(unit) +
                    ": the scale of the drawing is known, and the unit converts to it: leave "
                    "one of them out");
}

// Where the scale is known a unit converts, and an aligned drawing is in meters; else the unit is
// what the options say of it.
FileFrame FrameOf(const ExporterOptions& options, const DrawingMetadata& metadata) {
  if (IsInModel(options)) return {{}, 1, options.format.unit};
  const bool is_metric = IsMetric(metadata);
  const LengthUnit unit = is_metric ? KnownUnit(options) : options.format.unit;
  const bool converts = is_metric && unit != LengthUnit::kNone;
  const double scale = converts ? UnitsPerMeter(unit) : options.scale;
  Similarity3d file_from_world = {scale, ZUpFrom(options.up_axis), Eigen::Vector3d::Zero()};
  if (options.IsAligned()) {
    const Alignment& alignment = RequireAlignment(options.input_path, metadata);
    return {file_from_world * alignment.world_from_model, scale, unit};
  }
  if (converts) file_from_world.scale *= metadata.alignment->world_from_model.scale;
  return {file_from_world, scale, unit};
}

std::vector<GlbPoint> ReadCloud(const std::string& path, const Similarity3d& file_from_model) {
  std::vector<GlbPoint> cloud;
  ReadPlyPoints(path, [&](const PlyPoint& point) {
    const auto& [red, green, blue] = point.color;
    cloud.push_back({file_from_model * point.position, {red, green, blue}});
  });
  return cloud;
}

// In the coordinates of the file, from those of the drawing after all else: where up is known.
std::optional<Eigen::Vector3d> UpOf(const ExporterOptions& options,
                                    const DrawingMetadata& metadata) {
  if (metadata.alignment) {
    return metadata.alignment->world_from_model.rotation.transpose() * Eigen::Vector3d::UnitZ();
  }
  if (options.up_axis != SignedAxis::kZ) return Eigen::Vector3d::UnitZ();
  return std::nullopt;
}

bool IsPlan(const ExporterOptions& options) {
  return FormatName(options) == "dxf" &&
         (!options.svg.view.empty() || !options.svg.plan.section.empty());
}

// What an SVG picture or a plan shows of the graph.
SvgScene SceneOf(const ExporterOptions& options, const SheetInput& input, Console* console) {
  SvgSource source = options.svg;
  source.style.junctions = options.junctions;
  return source.IsSheet()
             ? SceneOnSheet(source, input, console)
             : SceneInImage(source, options.workspace, input.graph, input.faces, console);
}

// What the arrow up the sheet is called: north if x is east, else the axis.
std::string UpName(const ExporterOptions& options, const SheetOptions& sheet,
                   const DrawingMetadata& metadata) {
  if (sheet.axes) return "";
  if (sheet.projection != SvgProjection::kTop) {
    return sheet.projection == SvgProjection::kAxonometric ||
                   sheet.projection == SvgProjection::kBottom
               ? ""
               : "z";
  }
  const int axis = std::abs(sheet.front.x()) > std::abs(sheet.front.y()) ? 0 : 1;
  const bool is_north = options.IsAligned() && metadata.alignment &&
                        metadata.alignment->axes == AxesSource::kPositions;
  if (is_north && axis == 1 && sheet.front.y() > 0) return "N";
  return std::string(sheet.front[axis] < 0 ? "-" : "") + (axis == 0 ? "x" : "y");
}

// Of a sheet: the project, if it has a name, and what of it is seen.
std::string TitleOf(const ExporterOptions& options) {
  namespace fs = std::filesystem;
  const fs::path of_drawing = fs::path(options.input_path).parent_path();
  const fs::path& workspace = options.workspace.workspace_path;
  const fs::path folder = workspace.empty() ? of_drawing : workspace;
  const fs::path absolute = folder.empty() ? folder : fs::absolute(folder).lexically_normal();
  const bool ends_in_slash = absolute.has_relative_path() && !absolute.has_filename();
  const std::string project =
      Printable((ends_in_slash ? absolute.parent_path() : absolute).filename().string());
  const auto height = options.svg.plan.SectionHeight();
  const std::string view = height ? "section at " + ShortNumber(*height) : options.svg.view;
  return project.empty() ? view : project + ", " + view;
}

// Makes the scene flat, for DXF.
DrawingGraph PutPlan(SvgScene scene, const ExporterOptions& options,
                     const DrawingMetadata& metadata, DxfOptions* dxf) {
  const SvgSheet sheet = MakeSheet(scene.graph, scene.picture.sheet);
  const bool is_oblique =
      !scene.picture.sheet.axes && scene.picture.sheet.projection == SvgProjection::kAxonometric;
  FlatOptions flat_options;
  flat_options.hidden = scene.picture.style.hidden_parts == SvgHiddenParts::kDashed;
  flat_options.regularize = options.regularize && !is_oblique;
  FlatDrawing flat = Flatten(scene.graph, sheet, scene.picture.is_hidden, flat_options);
  DxfPlan plan;
  plan.ellipses = std::move(flat.visible.ellipses);
  plan.hidden = std::move(flat.hidden);
  plan.lengths = std::move(flat.lengths);
  plan.layout = {sheet.mm(), TitleOf(options), ScaleText(sheet),
                 UpName(options, scene.picture.sheet, metadata)};
  if (scene.picture.style.section) {
    plan.section = std::move(*scene.picture.style.section);
    for (SectionLine& line : plan.section.lines) {
      for (Eigen::Vector3d& point : line.points) point = FlatPlace(sheet, point);
    }
    for (Eigen::Vector3d& point : plan.section.points) point = FlatPlace(sheet, point);
  }
  dxf->plan = std::move(plan);
  return std::move(flat.visible.graph);
}

// Pictures of images are in the coordinates of the model, but their lengths in the unit asked for,
// or in meters, if that is known.
DimensionText TextInImage(const DrawingMetadata& metadata, LengthUnit unit) {
  if (!IsMetric(metadata)) return {1, unit};
  if (unit == LengthUnit::kNone) unit = LengthUnit::kMeter;
  const double meters = metadata.alignment->world_from_model.scale;
  return {meters * UnitsPerMeter(unit), unit};
}

// The axis of the file along which most cameras look, as far as they look along one.
Eigen::Vector3d FrontOf(const DrawingMetadata& metadata) {
  constexpr double kLeastHorizontal = 0.3;
  const Eigen::Vector3d direction = metadata.main_view_direction.value_or(Eigen::Vector3d::Zero());
  if (direction.head<2>().norm() < kLeastHorizontal) return Eigen::Vector3d::UnitY();
  const bool is_along_x = std::abs(direction.x()) > std::abs(direction.y());
  const int axis = is_along_x ? 0 : 1;
  return std::copysign(1.0, direction[axis]) * Eigen::Vector3d::Unit(axis);
}

DrawingGraph InSegments(DrawingGraph graph) {
  for (DrawingLink& link : graph.links) {
    const bool is_curved =
        link.primitive && !std::holds_alternative<LineSegment>(link.primitive->shape);
    if (!is_curved) continue;
    link.primitive.reset();
    link.regularity.reset();
  }
  return graph;
}

std::vector<DrawingFace> TransformedFaces(std::vector<DrawingFace> faces,
                                          const Similarity3d& similarity) {
  for (DrawingFace& face : faces) face = Transformed(std::move(face), similarity);
  return faces;
}

// The drawing that is asked for; says which one was found.
std::string InputPath(const ExporterOptions& options, Console* console) {
  if (!options.input_path.empty()) return options.input_path;
  const std::string found = FindDrawing(options.workspace, DrawingChoice::kNewest, "input_path");
  console->Say("drawing: " + found);
  return found;
}

size_t ExportLimap(DrawingFile drawing, SparseModel model, const std::vector<View>& views,
                   const ExporterOptions& options, Console* console) {
  const size_t num_links = drawing.graph.links.size();
  const LimapModel limap = ToLimap(std::move(drawing), std::move(model), views, options.chains);
  WriteNewModel(limap.model, options.output_path, ModelFlavor::kBinary,
                [&](const OutputPath& folder) {
                  WriteLimapStructures(limap.structures, folder / "structures");
                });
  console->Say(std::to_string(limap.structures.lines.size()) + " lines, " +
               std::to_string(limap.structures.wireframe.size()) + " ends where lines meet");
  return options.chains ? num_links : limap.structures.lines.size();
}

size_t ExportColmap(DrawingFile drawing, SparseModel model, const std::vector<View>& views,
                    const ExporterOptions& options, Console* console) {
  const size_t num_links = drawing.graph.links.size();
  const size_t num_before = model.points.size();
  const SparseModel with_curves =
      WithCurves(std::move(drawing), std::move(model), views, options.point_spacing_px);
  WriteNewModel(with_curves, options.output_path, ModelFlavor::kBinary);
  console->Say(std::to_string(with_curves.points.size() - num_before) +
               " points of curves beside " + std::to_string(num_before) + " of the model");
  return num_links;
}

size_t ExportModel(DrawingFile drawing, const ExporterOptions& options, Console* console) {
  drawing.graph = Selected(std::move(drawing.graph), options.selection.Selection());
  const WorkspaceLayout layout = ResolveLayout(options.workspace);
  if (!layout.note.empty()) console->Say(layout.note);
  SparseModel model = ReadModelOf(layout);
  const ViewSet set = ToViews(model, layout.image_dir, {}, console->context());
  const auto write = FormatName(options) == kLimapFormat ? ExportLimap : ExportColmap;
  return write(std::move(drawing), std::move(model), set.views, options, console);
}

// Says what a wireframe's tolerance is that was not given.
void SetTolerance(const DrawingGraph& graph, WireframeOptions* wireframe, Console* console) {
  if (wireframe->tolerance > 0) return;
  wireframe->tolerance = DefaultWireframeTolerance(ToCurveSet(graph).polylines);
  console->Say("tolerance: " + ShortNumber(wireframe->tolerance) +
               ", a hundredth of the size of the scene (--Wireframe.tolerance)");
}

size_t Export(DrawingFile drawing, const ExporterOptions& options, Console* console) {
  WarnOfUnknownCurves(drawing.graph, options.selection.detail, console);
  if (IsModel(FormatName(options))) return ExportModel(std::move(drawing), options, console);
  DrawingMetadata& metadata = drawing.metadata;
  const FileFrame frame = FrameOf(options, metadata);
  if (options.sigmas) {
    MeasureDimensions(metadata.alignment.value_or(Alignment()), &drawing.graph);
  }
  const auto& [scale, rotation, translation] = frame.from_model;
  const std::vector<DrawingFace> faces = TransformedFaces(drawing.graph.faces, frame.from_model);
  DrawingGraph graph =
      Transformed(Selected(std::move(drawing.graph), options.selection.Selection()), scale,
                  rotation, translation);
  if (options.segments && FormatName(options) == "dxf") graph = InSegments(std::move(graph));
  DrawingFormatOptions format = options.format;
  if (FormatName(options) == "step") format.write_step = LoadStepWriter();
  format.unit = frame.unit;
  metadata = After(frame.from_model, std::move(metadata));
  format.dxf.junctions = format.glb.junctions = options.junctions;
  format.obj.segments = options.segments;
  format.glb.rods_as_tubes = format.step.rods_as_tubes = options.rods_as_tubes;
  if (!options.cloud_path.empty()) {
    format.glb.cloud = ReadCloud(options.cloud_path, frame.from_model);
  }
  format.dxf.dimension_text = {1, format.unit};
  const bool is_svg = FormatName(options) == "svg";
  if (is_svg || IsPlan(options)) {
    const SheetInput input = {.graph = graph,
                              .faces = faces,
                              .file_from_model = frame.from_model,
                              .up = UpOf(options, metadata),
                              .scale = frame.units_per_world_unit,
                              .unit = frame.unit,
                              .front = FrontOf(metadata)};
    SvgScene scene = SceneOf(options, input, console);
    scene.picture.style.dimension_text = options.svg.IsSheet()
                                             ? DimensionText{1, frame.unit}
                                             : TextInImage(metadata, options.format.unit);
    format.svg = scene.picture;
    graph =
        is_svg ? std::move(scene.graph) : PutPlan(std::move(scene), options, metadata, &format.dxf);
  }
  ThrowIfCancelled(console->context());
  if (FormatName(options) == "wireframe") SetTolerance(graph, &format.wireframe, console);
  if (FormatName(options) == "step" && frame.unit == LengthUnit::kNone) {
    console->Say(
        "WARNING: the unit of the coordinates is not known (--unit, --aligned 1): one is a "
        "millimeter in the file");
  }
  for (const std::string& note : WriteDrawing(options.output_path, graph, metadata, format)) {
    console->Say("WARNING: " + note);
  }
  return graph.links.size();
}

void CheckOutput(const ExporterOptions& options) {
  if (IsModel(FormatName(options))) {
    CheckNewModelFolder(options.output_path);
    return;
  }
  CheckNamedOutput(options.output_path,
                   {options.input_path, options.cloud_path, options.svg.dense.dense_path},
                   options.overwrite);
}

void AddFormatOptions(DrawingFormatOptions* format, OptionParser* parser) {
  parser->AddOption("y_up", &format->obj.y_up, "OBJ: y points up instead of z");
  parser->AddOption("objects", &format->glb.objects,
                    {{"kind", GlbObjects::kKind}, {"link", GlbObjects::kLink}},
                    "GLB: what becomes an object, all links of a kind of edge or each link");
  parser->AddOption("paper_space", &format->dxf.paper_space,
                    "DXF plans: a sheet in the paper space, which LibreCAD shows in the model");
  parser->AddOption(
      "layers", &format->dxf.layers,
      {{"class", DxfLayers::kClass},
       {"kind", DxfLayers::kKind},
       {"component", DxfLayers::kComponent},
       {"single", DxfLayers::kSingle},
       {"face", DxfLayers::kFace}},
      "DXF: what makes a layer, the kind of edge (with line types and weights), the shape of the "
      "curve (class), the connected component or the face");
  parser->AddOption(
      "unit", &format->unit,
      {{"none", LengthUnit::kNone},
       {"mm", LengthUnit::kMillimeter},
       {"cm", LengthUnit::kCentimeter},
       {"m", LengthUnit::kMeter},
       {"in", LengthUnit::kInch},
       {"ft", LengthUnit::kFoot}},
      BasicOption("unit of the file: converts if the scale of the drawing is known (none = m if "
                  "it is aligned), else says what one unit is after --scale; GLB is in m"));
}

}  // namespace

void ExporterOptions::AddOptions(OptionParser* parser) {
  std::vector<std::string> formats = DrawingFormats();
  formats.insert(formats.begin(), kAutoFormat);
  formats.push_back(kLimapFormat);
  formats.push_back(kColmapFormat);
  parser->AddOption("input_path", &input_path,
                    BasicOption("a drawing.json or a model of LIMAP, instead of the newest drawing "
                                "of the workspace"));
  parser->AddOption("output_path", &output_path,
                    BasicOption("the file to write; for limap and colmap a new folder"));
  parser->AddOption("workspace_path", &workspace.workspace_path,
                    BasicOption("COLMAP project: where the drawing is, the image of an SVG, the "
                                "model for limap and colmap"));
  parser->AddOption("image_path", &workspace.image_path, "images of the project");
  parser->AddOption("model_index", &workspace.model_index, "which of its models");
  parser->AddOption("overwrite", &overwrite, BasicOption(kOverwriteHelp));
  parser->AddOption(
      "output_type", &format.format, formats,
      BasicOption("its format; auto = by its extension; faces = only these, as .ply; wireframe = "
                  "corners and straight edges, as .obj or .json"));
  AddGroup("Wireframe", &format.wireframe, parser);
  parser->AddOption("scale", &scale, BasicOption("factor on all coordinates"));
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
  parser->AddOption("rods_as_tubes", &rods_as_tubes, "GLB and STEP: rods as tubes of their radius");
  parser->AddOption("segments", &segments,
                    "DXF: curves as the polylines of their points, for CloudCompare, which reads "
                    "no others; OBJ: elements of two vertices, for MeshLab");
  AddFormatOptions(&format, parser);
  parser->AddOption("cloud_path", &cloud_path, "GLB: a cloud to go with it, .ply");
  svg.AddOptions(parser);
  parser->AddOption("sigmas", &sigmas, "DXF and SVG: dimensions with their standard deviations");
  parser->AddOption("regularize", &regularize,
                    "DXF plans: lines that are level or plumb within their uncertainty are so");
  parser->AddOption("chains", &chains,
                    "limap: also links that are not straight, as chains of lines");
  parser->AddOption("point_spacing_px", &point_spacing_px,
                    "colmap: distance of the points along curves, px");
}

bool ExporterOptions::IsAligned() const { return aligned || !svg.plan.section.empty(); }

void ExporterOptions::Check() const {
  if (input_path.empty() && workspace.workspace_path.empty()) {
    throw OptionError("--input_path or --workspace_path must be given");
  }
  if (output_path.empty()) throw OptionError("--output_path must be given");
  if (!workspace.workspace_path.empty()) workspace.Check();
  selection.Selection();  // throws
  CheckGroup("Wireframe", format.wireframe);
  LIMN_CHECK_RANGE(scale, >= 1e-12, <= 1e12);
  if (IsAligned() && up_axis != SignedAxis::kZ) {
    throw OptionError("up_axis: z is up in an aligned drawing");
  }
  const std::string name = FormatName(*this);
  if (!cloud_path.empty() && name != "glb") {
    throw OptionError("cloud_path: only .glb files hold a cloud");
  }
  if (rods_as_tubes && name != "glb" && name != "step") {
    throw OptionError("rods_as_tubes: only in .glb and .step files");
  }
  if (segments && name != "dxf" && name != "obj") {
    throw OptionError("segments: only in .dxf and .obj files");
  }
  if (IsPlan(*this) && !svg.IsSheet()) {
    throw OptionError("view = " + svg.view + ": must be one of " + kSheetViews +
                      "; only SVG pictures show images");
  }
  if (name == "svg" || IsPlan(*this)) svg.Check(workspace);
  if (!svg.plan.section.empty() && name != "svg" && name != "dxf") {
    throw OptionError("section: only in .svg and .dxf files");
  }
  LIMN_CHECK_RANGE(point_spacing_px, >= 0.1, <= 1e4);
  if (IsModel(name) && workspace.workspace_path.empty()) {
    throw OptionError("output_type = " + name + ": the cameras of --workspace_path go with it");
  }
  if (IsModel(name) && format.unit != LengthUnit::kNone) {
    throw OptionError("unit: a model keeps its coordinates");
  }
  if (IsInModel(*this) && (scale != 1 || up_axis != SignedAxis::kZ || aligned)) {
    throw OptionError("scale, up_axis and aligned: " +
                      std::string(name == "svg" ? "the picture of an image is in its pixels"
                                                : "a model keeps its coordinates"));
  }
}

size_t ExportDrawing(const ExporterOptions& options, Console* console) {
  ExporterOptions of_file = options;
  of_file.input_path = InputPath(options, console);
  of_file.workspace.starts_from = DrawingsToStartFrom(DrawingChoice::kNewest, of_file.input_path);
  CheckOutput(of_file);
  return Export(ReadDrawing(of_file.input_path), of_file, console);
}

size_t ExportDrawing(DrawingFile drawing, const ExporterOptions& options, Console* console) {
  CheckOutput(options);
  return Export(std::move(drawing), options, console);
}

void RunExporter(const ExporterOptions& options, Console* console) {
  const size_t num_links = ExportDrawing(options, console);
  console->Say("Written: " + options.output_path + " (" + std::to_string(num_links) + " links)");
}

}  // namespace limn::colmap_ext
