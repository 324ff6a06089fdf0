// SPDX-License-Identifier: BSD-3-Clause
// write_pictures <folder>: drawings of a small scene for tests by programs that are not ours, and
// what these must find, computed without the writers:
//   view.svg, view-hidden.svg, sheet.svg, sheet-hidden.svg (dashed: sheet-dashed.svg) with
//   <name>.txt:
//     "x y state" per sample of a link, in px of the picture, state 0 visible, 1 hidden, 2 too near
//     to the border of what hides to tell
//   drawing.glb with drawing.json: counts, length and box

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "limn/formats/glb_drawing_writer.h"
#include "limn/formats/picture_scene.h"
#include "limn/formats/svg/svg_drawing_writer.h"
#include "limn/visibility/render_depth.h"

namespace limn {
namespace {

// Moves the .glb away from the origin; exact in float.
const Eigen::Vector3d kGlbShift(1000, -2000, 50);

SvgOptions LinesOnly() {
  SvgOptions options;
  options.junctions = false;
  return options;
}

std::vector<Eigen::Vector3d> DensePoints(const DrawingLink& link) {
  return ResampleUniform(link.points_in_world, 0.001);
}

// `place` gives the px of a point or nothing, `eye` where a point is seen from.
template <typename Place, typename Eye>
void WriteSamples(const std::string& path, const DrawingGraph& graph, bool with_wall,
                  const Place& place, const Eye& eye) {
  constexpr double kBorder = 0.03;
  std::ofstream out(path);
  out.precision(10);
  for (const DrawingLink& link : graph.links) {
    for (const Eigen::Vector3d& point : DensePoints(link)) {
      const std::optional<Eigen::Vector2d> at = place(point);
      if (!at) continue;
      const bool surely = WallHides(eye(point), point, -kBorder);
      const bool perhaps = WallHides(eye(point), point, kBorder);
      out << at->x() << ' ' << at->y() << ' '
          << (!with_wall ? 0
              : surely   ? 1
              : perhaps  ? 2
                         : 0)
          << '\n';
    }
  }
}

void WriteViews(const std::string& folder) {
  const DrawingGraph graph = PictureScene();
  const View view = SceneView();
  const Eigen::Vector3d center = view.CenterInWorld();
  const auto place = [&](const Eigen::Vector3d& point) -> std::optional<Eigen::Vector2d> {
    const auto pixel = view.Project(point);
    if (!pixel) return std::nullopt;
    return Eigen::Vector2d(view.lens->StoredFromVirtual(*pixel)->array() + 0.5);
  };
  const auto eye = [&](const Eigen::Vector3d&) { return center; };
  std::ofstream all(folder + "/view.svg");
  WriteDrawingSvg(graph, view, {}, LinesOnly(), all);
  WriteSamples(folder + "/view.txt", graph, false, place, eye);
  std::ofstream hidden(folder + "/view-hidden.svg");
  WriteDrawingSvg(graph, view, HiddenInView(view, RenderDepth(SceneWall(), view, 1)), LinesOnly(),
                  hidden);
  WriteSamples(folder + "/view-hidden.txt", graph, true, place, eye);
}

void WriteSheets(const std::string& folder) {
  const DrawingGraph graph = PictureScene();
  SheetOptions options;
  options.projection = SvgProjection::kAxonometric;
  options.unit = LengthUnit::kMeter;
  options.sheet_scale = 20;
  options.legend = false;
  const SvgSheet sheet = MakeSheet(graph, options);
  // Isometric, 1:20, in px of 1/96 inch from the corner of the paper.
  const double px = 20 * 0.0254 / 96;
  const auto place = [&](const Eigen::Vector3d& p) -> std::optional<Eigen::Vector2d> {
    const double right = (p.x() + p.y()) / std::sqrt(2.0);
    const double down = (p.x() - p.y() - 2 * p.z()) / std::sqrt(6.0);
    return Eigen::Vector2d((Eigen::Vector2d(right, down) - sheet.paper_min) / px);
  };
  const auto eye = [](const Eigen::Vector3d& point) {
    return Eigen::Vector3d(point + 100 * Eigen::Vector3d(1, -1, 1));
  };
  std::ofstream all(folder + "/sheet.svg");
  WriteDrawingSvg(graph, sheet, {}, LinesOnly(), all);
  WriteSamples(folder + "/sheet.txt", graph, false, place, eye);
  const IsHidden is_hidden = HiddenOnSheet(RenderOrthographicDepth(SceneWall(), DepthFrame(sheet)));
  std::ofstream hidden(folder + "/sheet-hidden.svg");
  WriteDrawingSvg(graph, sheet, is_hidden, LinesOnly(), hidden);
  WriteSamples(folder + "/sheet-hidden.txt", graph, true, place, eye);
  // With all that a sheet may hold, to be parsed.
  options.legend = true;
  SvgOptions dashed;
  dashed.hidden_parts = SvgHiddenParts::kDashed;
  dashed.title = "R&D <\"sheet\">";
  std::ofstream full(folder + "/sheet-dashed.svg");
  WriteDrawingSvg(graph, MakeSheet(graph, options), is_hidden, dashed, full);
}

void WriteGlb(const std::string& folder) {
  DrawingGraph graph = PictureScene();
  nlohmann::json expected = {{"links", graph.links.size()}, {"junctions", 0}};
  for (DrawingNode& node : graph.nodes) {
    node.position_in_world += kGlbShift;
    if (node.kind == NodeKind::kJunction)
      expected["junctions"] = 1 + expected["junctions"].get<int>();
  }
  Eigen::AlignedBox3d box;
  for (DrawingLink& link : graph.links) {
    for (Eigen::Vector3d& point : link.points_in_world) {
      point += kGlbShift;
      box.extend(point);
    }
    expected["vertices"].push_back(link.points_in_world.size() - (link.closed ? 1 : 0));
    expected["edges"].push_back(link.points_in_world.size() - 1);
    expected["length"].push_back(Length(link.points_in_world));
  }
  expected["min"] = {box.min().x(), box.min().y(), box.min().z()};
  expected["max"] = {box.max().x(), box.max().y(), box.max().z()};
  GlbOptions options;
  options.objects = GlbObjects::kLink;
  for (int k = 0; k < 100; ++k) {
    options.cloud.push_back({kGlbShift + 0.01 * k * Eigen::Vector3d::Ones(), {255, 128, 0}});
  }
  expected["cloud"] = options.cloud.size();
  std::ofstream glb(folder + "/drawing.glb", std::ios::binary);
  WriteDrawingGlb(graph, options, LengthUnit::kNone, glb);
  std::ofstream(folder + "/drawing.json") << expected;
}

}  // namespace
}  // namespace limn

int main(int argc, char** argv) {
  if (argc != 2 || !std::filesystem::is_directory(argv[1])) {
    std::cerr << "usage: write_pictures <existing folder>\n";
    return 1;
  }
  limn::WriteViews(argv[1]);
  limn::WriteSheets(argv[1]);
  limn::WriteGlb(argv[1]);
  return 0;
}
