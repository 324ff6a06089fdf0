#include "colmap_ext/run/svg_source.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "colmap_ext/run/fusion_results.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/world_shift.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/geometry/point_spacing.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

struct NamedProjection {
  const char* name;
  SvgProjection projection;
};
constexpr std::array<NamedProjection, 4> kProjections = {
    {{"top", SvgProjection::kTop},
     {"front", SvgProjection::kFront},
     {"side", SvgProjection::kSide},
     {"axonometric", SvgProjection::kAxonometric}}};

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
                  const OrthographicFrame& frame) {
  const auto turn = [&](std::vector<Eigen::Vector3d>* points) {
    for (Eigen::Vector3d& point : *points) point = sheet_from_model * point;
  };
  if (IsMeshFile(path)) {
    TriangleMesh mesh = ReadMesh(path);
    turn(&mesh.vertices);
    return HiddenOnSheet(RenderOrthographicDepth(mesh, frame));
  }
  std::vector<Eigen::Vector3d> points = ReadCloud(path);
  turn(&points);
  const double radius = kRadiusOfSpacing * PointSpacing(points);
  return HiddenOnSheet(SplatOrthographicDepth(points, frame, radius));
}

ViewId FindView(const Scene& project, const std::string& name) {
  for (size_t v = 0; v < project.views().size(); ++v) {
    if (project.views()[v].name == name) return static_cast<ViewId>(v);
  }
  throw OptionError("view = " + name +
                    ": must be top, front, side, axonometric or the name of an image");
}

// As a reference from the folder of the picture.
std::string RelativeTo(const fs::path& picture, const fs::path& photo) {
  std::error_code error;
  const fs::path folder = fs::absolute(picture).parent_path();
  const fs::path relative = fs::proximate(fs::absolute(photo), folder, error);
  return (error ? fs::absolute(photo) : relative).generic_string();
}

}  // namespace

void SvgSource::AddOptions(OptionParser* parser) {
  parser->AddOption("view", &view,
                    BasicOption("SVG: top, front, side or axonometric to scale, or the name of an "
                                "image"));
  parser->AddOption("dense_path", &dense.dense_path,
                    BasicOption("SVG: what hides parts; for sheets a mesh or a cloud"));
  parser->AddOption("dense_type", &dense.dense_type,
                    {"auto", "depth_maps", "fused", "pmvs", "mesh"},
                    "SVG of an image: which dense results, as in drawing_fuser");
  parser->AddOption("hidden", &style.hidden_parts,
                    {{"removed", SvgHiddenParts::kRemoved}, {"dashed", SvgHiddenParts::kDashed}},
                    "SVG: hidden parts, where depths are known");
  parser->AddOption("show_hidden", &show_hidden, "SVG: do not look for hidden parts");
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
                    BasicOption("SVG: n of 1:n for units of a meter, 0 = the largest that fits on "
                                "A3"));
  parser->AddOption("azimuth_deg", &sheet.azimuth_deg, "SVG: axonometric, from where");
  parser->AddOption("elevation_deg", &sheet.elevation_deg, "SVG: axonometric, from how high");
}

bool SvgSource::IsSheet() const { return ProjectionOf(view) != nullptr; }

void SvgSource::Check(const LayoutOptions& workspace) const {
  dense.Check();
  sheet.Check();
  style.Check();
  if (IsSheet() && photo) throw OptionError("photo = 1: a sheet has no photograph");
  if (!IsSheet() && workspace.workspace_path.empty()) {
    throw OptionError("view = " + view + ": the picture of an image needs --workspace_path");
  }
}

SvgScene SceneOnSheet(const SvgSource& source, const DrawingGraph& graph,
                      const Similarity3d& graph_from_model) {
  SvgScene scene = {{}, graph};
  scene.picture.sheet = source.sheet;
  scene.picture.sheet.projection = ProjectionOf(source.view)->projection;
  scene.picture.style = source.style;
  if (!source.show_hidden && !source.dense.dense_path.empty()) {
    const OrthographicFrame frame = DepthFrame(MakeSheet(graph, scene.picture.sheet));
    scene.picture.is_hidden = HiddenBy(source.dense.dense_path, graph_from_model, frame);
  }
  return scene;
}

SvgScene SceneInImage(const SvgSource& source, const LayoutOptions& workspace,
                      const DrawingGraph& graph, const std::string& output_path, Console* console) {
  RunOptions options;
  options.layout = workspace;
  const Scene project(ChooseLayout(options, console), options, console);
  const ViewId view = FindView(project, source.view);
  SvgScene scene = {{}, Moved(graph, -project.origin())};
  scene.picture.view = project.views()[view];
  scene.picture.style = source.style;
  if (source.photo && project.view_set().Window(view)) {
    throw OptionError("photo = 1: the view is a part of a panorama");
  }
  if (source.photo) {
    scene.picture.style.photo = RelativeTo(output_path, project.view_set().image_paths[view]);
  }
  if (source.show_hidden) return scene;
  FuserOptions fuser;
  fuser.paths = source.dense;
  if (!LookForDenseProducts(fuser.paths, workspace.workspace_path, project.layout().dense_dir)) {
    console->Say("no dense results: nothing is hidden");
    return scene;
  }
  const DenseInput dense = OpenDenseInput(project, fuser, workspace.workspace_path, console);
  if (const auto depth = dense.depths(view)) {
    scene.picture.is_hidden = HiddenInView(project.views()[view], *depth);
  }
  return scene;
}

}  // namespace limn::colmap_ext
