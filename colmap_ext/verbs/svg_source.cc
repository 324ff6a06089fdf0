// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/svg_source.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "colmap_ext/host/project.h"
#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/dense_input.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/geometry/point_spacing.h"
#include "limn/pictures/thumbnail.h"
#include "limn/plans/depth_range.h"
#include "limn/plans/face_axes.h"
#include "limn/util/errors.h"
#include "limn/util/number_text.h"
#include "limn/util/parse_number.h"
#include "limn/viewer/packing.h"
#include "limn/visibility/face_surface.h"
#include "limn/visibility/render_depth.h"

namespace limn::colmap_ext {
namespace {

constexpr const char* kFaceView = "face:";
// A type of what hides, beside the dense results.
constexpr const char* kFacesType = "faces";

struct NamedProjection {
  const char* name;
  SvgProjection projection;
};
constexpr std::array<NamedProjection, 7> kProjections = {
    {{"front", SvgProjection::kFront},
     {"back", SvgProjection::kBack},
     {"left", SvgProjection::kLeft},
     {"right", SvgProjection::kRight},
     {"top", SvgProjection::kTop},
     {"bottom", SvgProjection::kBottom},
     {"axonometric", SvgProjection::kAxonometric}}};
// Of the area of the faces that are seen from one of their sides.
constexpr double kMostlyBacks = 2.0 / 3;

const NamedProjection* ProjectionOf(const std::string& view) {
  const auto found = std::find_if(kProjections.begin(), kProjections.end(),
                                  [&](const NamedProjection& p) { return view == p.name; });
  return found == kProjections.end() ? nullptr : &*found;
}

// A little more than the spacing of a cloud's points, so that its discs leave no holes.
constexpr double kRadiusOfSpacing = 1.5;

std::vector<Eigen::Vector3d> ReadCloud(const std::string& path) {
  std::vector<Eigen::Vector3d> points;
  ReadPlyPoints(path, [&](const PlyPoint& point) { points.push_back(point.position); });
  return points;
}

// What a mesh or cloud hides on a sheet.
IsHidden HiddenBy(const std::string& path, const Similarity3d& sheet_from_model,
                  const DepthRange& range, const OrthographicFrame& frame) {
  const auto turn = [&](std::vector<Eigen::Vector3d>* points) {
    for (Eigen::Vector3d& point : *points) point = sheet_from_model * point;
  };
  if (IsMeshFile(path)) {
    TriangleMesh mesh = ReadMesh(path);
    turn(&mesh.vertices);
    return HiddenOnSheet(RenderOrthographicDepth(Clipped(mesh, range), frame));
  }
  std::vector<Eigen::Vector3d> points = ReadCloud(path);
  turn(&points);
  const double radius = kRadiusOfSpacing * PointSpacing(points);
  std::erase_if(points, [&](const Eigen::Vector3d& point) { return !range.Has(point); });
  return HiddenOnSheet(SplatOrthographicDepth(points, frame, radius));
}

// Whether the faces of a drawing hide parts of it; says so.
bool FacesHide(const SvgSource& source, const std::vector<DrawingFace>& faces, Console* console) {
  if (source.dense.dense_type == kFacesType && faces.empty()) {
    throw OptionError("dense_type = faces: the drawing has none; drawing_surfacer finds them");
  }
  if (source.hidden != SvgSource::Hidden::kAuto && faces.empty()) {
    throw OptionError(
        "hidden: nothing is known that hides: neither has the drawing faces (drawing_surfacer), "
        "nor "
        "are there dense results (--dense_path)");
  }
  console->Say(faces.empty() ? "no dense results and no faces: nothing is hidden"
                             : "hidden parts: by " + std::to_string(faces.size()) + " faces");
  return !faces.empty();
}

SvgOptions StyleOf(const SvgSource& source) {
  SvgOptions style = source.style;
  if (source.hidden == SvgSource::Hidden::kDashed) style.hidden_parts = SvgHiddenParts::kDashed;
  return style;
}

IsHidden HiddenOn(const SvgSheet& sheet, const DepthRange& range, const SvgSource& source,
                  const SheetInput& input, Console* console) {
  if (source.show_hidden) return {};
  const OrthographicFrame frame = DepthFrame(sheet);
  const std::string& path = source.dense.dense_path;
  if (!path.empty()) return HiddenBy(path, input.file_from_model, range, frame);
  if (!FacesHide(source, input.faces, console)) return {};
  const TriangleMesh mesh = Clipped(MeshOf(input.faces), range);
  return HiddenOnSheet(RenderOrthographicDepth(mesh, frame));
}

const DrawingFace& FaceOf(const SvgSource& source, const std::vector<DrawingFace>& faces) {
  const auto id = static_cast<size_t>(*source.Face());
  if (id >= faces.size()) {
    throw OptionError("view = " + source.view + ": the drawing has " +
                      std::to_string(faces.size()) + " faces, counted from 0");
  }
  if (faces[id].surface != FaceSurface::kPlane) {
    throw OptionError("view = " + source.view + ": the face is not flat");
  }
  return faces[id];
}

DepthRange RangeAt(const DrawingFace& face, const PlanOptions& plan) {
  DepthRange range = {-face.normal};
  if (plan.depth_before >= 0) range.near = -face.offset - plan.depth_before;
  if (plan.depth_behind >= 0) range.far = -face.offset + plan.depth_behind;
  return range;
}

Section SectionAt(double height, const PlanOptions& plan, const SheetInput& input,
                  Console* console) {
  const double gap = plan.section_gap >= 0 ? plan.section_gap : UsualGap(input.graph.links);
  Section section = CutAt(height, input.faces, input.graph.links, gap);
  console->Say("section: " + std::to_string(section.lines.size()) + " lines of faces, " +
               std::to_string(section.NumClosed()) + " closed (gaps up to " + ShortNumber(gap) +
               "); " + std::to_string(section.points.size()) + " places where links are cut");
  if (input.faces.empty()) {
    console->Say("WARNING: the drawing has no faces to cut: run drawing_surfacer first");
  }
  return section;
}

std::vector<Eigen::Vector3d> PlacesOf(const Section& section) {
  std::vector<Eigen::Vector3d> places = section.points;
  for (const SectionLine& line : section.lines) {
    places.insert(places.end(), line.points.begin(), line.points.end());
  }
  return places;
}

ViewId FindView(const Scene& project, const std::string& name) {
  for (size_t v = 0; v < project.views().size(); ++v) {
    if (project.views()[v].name == name) return static_cast<ViewId>(v);
  }
  throw OptionError("view = " + name + ": must be " + std::string(kSheetViews) +
                    " or the name of an image");
}

void WarnOfBacks(const std::vector<DrawingFace>& faces, const Eigen::Vector3d& forward,
                 const std::string& view, Console* console) {
  double seen = 0, from_behind = 0;
  for (const DrawingFace& face : faces) {
    if (face.surface != FaceSurface::kPlane) continue;
    const double toward = -AreaOf(face) * face.normal.dot(forward);
    seen += std::abs(toward);
    from_behind += std::max(0.0, -toward);
  }
  if (!(from_behind > kMostlyBacks * seen)) return;
  console->Say("WARNING: view = " + view + ": " +
               ShortNumber(std::round(100 * from_behind / seen)) +
               " % of the faces, by area, turn their backs; the other side was photographed");
}

// As a URL that holds it: programs open no files beside a picture, or ask for each.
std::string EmbeddedPhoto(const Scene& scene, ViewId view) {
  constexpr int kLongerSide = 1024;
  const std::string jpeg = SmallJpeg(scene.images().read(view), kLongerSide);
  ReleaseDecoded(scene.view_set());
  return "data:image/jpeg;base64," + Base64(jpeg);
}

}  // namespace

void SvgSource::AddOptions(OptionParser* parser) {
  parser->AddOption(
      "view", &view,
      BasicOption("SVG and DXF: front (along which most cameras look), back, left, "
                  "right, top, bottom, axonometric or face:<id> (along a face); SVG: "
                  "or the name of an image. Empty: axonometric, in DXF the drawing in "
                  "space"));
  parser->AddOption("dense_path", &dense.dense_path,
                    BasicOption("SVG, DXF plans: what hides parts; for sheets a mesh or a cloud"));
  parser->AddOption("dense_type", &dense.dense_type,
                    {"auto", "depth_maps", "fused", "pmvs", "mesh", kFacesType},
                    "SVG of an image: which dense results, as in drawing_fuser; faces = the "
                    "drawing's faces hide, as they do without dense results");
  parser->AddOption(
      "hidden", &hidden,
      {{"auto", Hidden::kAuto}, {"removed", Hidden::kRemoved}, {"dashed", Hidden::kDashed}},
      "SVG, DXF plans: hidden parts (dashed in DXF: on a layer of that line type); auto = removed, "
      "where faces or depths are known");
  parser->AddOption("show_hidden", &show_hidden, "SVG, DXF plans: do not look for hidden parts");
  plan.AddOptions(parser);
  parser->AddOption("photo", &photo,
                    BasicOption("SVG of an image: the photograph beneath the drawing"));
  parser->AddOption("colors", &style.colors,
                    {{"black", SvgColors::kBlack},
                     {"link", SvgColors::kLink},
                     {"primitive", SvgColors::kPrimitive},
                     {"class", SvgColors::kClass},
                     {"kind", SvgColors::kKind}},
                    BasicOption("SVG: meaning of colors"));
  parser->AddOption("line_width_px", &style.line_width_px, "SVG: width of lines, px");
  parser->AddOption("sheet_scale", &sheet.sheet_scale,
                    BasicOption("SVG, DXF plans: n of 1:n, 0 = the largest that fits on A3"));
  parser->AddOption("azimuth_deg", &sheet.azimuth_deg,
                    "SVG: axonometric, direction of the viewpoint about z, deg");
  parser->AddOption("elevation_deg", &sheet.elevation_deg,
                    "SVG: axonometric, height of the viewpoint, deg");
}

bool SvgSource::IsSheet() const { return view.empty() || Face() || ProjectionOf(view) != nullptr; }

std::optional<int> SvgSource::Face() const {
  if (!view.starts_with(kFaceView)) return std::nullopt;
  const auto face = ParseNumber<int>(std::string_view(view).substr(std::strlen(kFaceView)));
  return face && *face >= 0 ? face : std::nullopt;
}

void SvgSource::Check(const LayoutOptions& workspace) const {
  if (dense.dense_type != kFacesType) dense.Check();
  if (dense.dense_type == kFacesType && !dense.dense_path.empty()) {
    throw OptionError("dense_type = faces: the drawing has them, not --dense_path");
  }
  plan.Check();
  if (!plan.section.empty() && !view.empty() && view != "top") {
    throw OptionError("section: is seen from the top, not with --view " + view);
  }
  if (!Face() && (plan.depth_before != -1 || plan.depth_behind != -1)) {
    throw OptionError("depth_before, depth_behind: only with --view face:<id>");
  }
  sheet.Check();
  style.Check();
  if (IsSheet() && photo) throw OptionError("photo = 1: a sheet has no photograph");
  if (!IsSheet() && workspace.workspace_path.empty()) {
    throw OptionError("view = " + view + ": the picture of an image needs --workspace_path");
  }
}

SvgScene SceneOnSheet(const SvgSource& source, const SheetInput& input, Console* console) {
  SvgScene scene;
  scene.picture.style = StyleOf(source);
  scene.picture.sheet = source.sheet;
  SheetOptions& sheet = scene.picture.sheet;
  sheet.unit = input.unit;
  sheet.front = input.front;
  DepthRange range;
  std::string view = source.view;
  if (source.Face()) {
    const DrawingFace& face = FaceOf(source, input.faces);
    sheet.axes = AxesAlong(face, input.up);
    range = RangeAt(face, source.plan);
  } else {
    const bool is_plan = source.plan.SectionHeight().has_value();
    if (view.empty()) view = is_plan ? "top" : "axonometric";
    sheet.projection = ProjectionOf(view)->projection;
  }
  scene.graph = input.graph;
  if (const auto height = source.plan.SectionHeight()) {
    range = {-Eigen::Vector3d::UnitZ(), -input.scale * *height};
    scene.picture.style.section = SectionAt(input.scale * *height, source.plan, input, console);
    if (!source.plan.section_below) scene.graph = {};
    sheet.more_places = PlacesOf(*scene.picture.style.section);
  }
  scene.graph = Clipped(scene.graph, range);
  if (scene.graph.links.empty() && sheet.more_places.empty()) {
    throw InputError("nothing of the drawing is on the sheet");
  }
  const SvgSheet made = MakeSheet(scene.graph, sheet);
  WarnOfBacks(input.faces, made.axes.row(2).transpose(), view, console);
  scene.picture.is_hidden = HiddenOn(made, range, source, input, console);
  return scene;
}

SvgScene SceneInImage(const SvgSource& source, const LayoutOptions& workspace,
                      const DrawingGraph& graph, const std::vector<DrawingFace>& faces,
                      Console* console) {
  RunOptions options;
  options.layout = workspace;
  const Scene project(ChooseLayout(options.layout, console), options, console);
  const ViewId view = FindView(project, source.view);
  SvgScene scene = {{}, Moved(graph, -project.origin())};
  scene.picture.view = project.views()[view];
  scene.picture.style = StyleOf(source);
  if (source.photo && project.view_set().Window(view)) {
    throw OptionError("photo = 1: the view is a part of a panorama");
  }
  if (source.photo) scene.picture.style.photo = EmbeddedPhoto(project, view);
  if (source.show_hidden) return scene;
  const bool by_faces =
      source.dense.dense_type == kFacesType ||
      !LookForDenseProducts(source.dense, workspace.workspace_path, project.layout().dense_dir);
  if (by_faces) {
    if (!FacesHide(source, faces, console)) return scene;
    TriangleMesh mesh = MeshOf(faces);
    for (Eigen::Vector3d& vertex : mesh.vertices) vertex -= project.origin();
    const View& seen_in = project.views()[view];
    scene.picture.is_hidden = HiddenInView(seen_in, RenderDepth(mesh, seen_in, /*scale=*/1));
    return scene;
  }
  const DenseInput dense = OpenDenseInput(project, source.dense, workspace.workspace_path, console);
  if (const auto depth = dense.depths(view)) {
    scene.picture.is_hidden = HiddenInView(project.views()[view], *depth);
  }
  return scene;
}

}  // namespace limn::colmap_ext
