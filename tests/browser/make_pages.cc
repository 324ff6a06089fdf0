// SPDX-License-Identifier: BSD-3-Clause
// make_pages <folder>: the pages that the browser tests open.
//   wires.html, wires.json    a synthetic scene and what its page must show
//   edit.html, edit.json      links to edit
//   kept/, renewed/           the same of a drawing.json, and of another state of it
//   large.html, many.html     for tests/bench
//   day/, distorted/          the truth of the sample scene over its photographs, made by
//                             `limn drawing_viewer`; distorted/ has a lens

#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <tuple>

#include <nlohmann/json.hpp>

#include "browser/edit_scene.h"
#include "browser/wire_scene.h"
#include "end_to_end/run_limn.h"
#include "limn/files/atomic_file.h"
#include "limn/formats/read_curves.h"
#include "limn/formats/write_drawing.h"
#include "limn/viewer/viewer_page.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;

constexpr int kNumSampleViews = 24;

void WritePage(const fs::path& path, const ViewerScene& scene) {
  WriteFileAtomically(path.string(), [&](std::ostream& out) { WriteViewerPage(scene, out); });
}

// Truth curves as a drawing; ends at the same place are one node.
DrawingGraph TruthGraph() {
  const CurveSet truth = ReadCurves(std::string(LIMN_SAMPLE_DIR) + "/truth/curves-visible.ply");
  DrawingGraph graph;
  std::map<std::tuple<double, double, double>, NodeId> nodes;
  const auto node_at = [&](const Eigen::Vector3d& point) {
    const auto [at, is_new] = nodes.try_emplace({point.x(), point.y(), point.z()},
                                                static_cast<NodeId>(graph.nodes.size()));
    if (is_new) graph.nodes.emplace_back().position_in_world = point;
    return at->second;
  };
  for (const Polyline3d& polyline : truth.polylines) {
    DrawingLink link;
    link.points_in_world = polyline;
    link.sigma.assign(polyline.size(), 0.001);
    link.node0 = node_at(polyline.front());
    link.node1 = node_at(polyline.back());
    link.closed = link.node0 == link.node1;
    for (ViewId view = 0; view < kNumSampleViews; ++view) link.supporting_views.push_back(view);
    graph.links.push_back(link);
  }
  RebuildIncidence(&graph);
  return graph;
}

bool MakeSamplePage(const fs::path& folder, const std::string& workspace) {
  DrawingMetadata metadata;
  for (int view = 0; view < kNumSampleViews; ++view) {
    metadata.view_names.push_back((view < 10 ? "view_0" : "view_") + std::to_string(view) + ".jpg");
  }
  WriteDrawing((folder / "drawing.json").string(), TruthGraph(), metadata);
  const LimnRun run =
      RunLimn({"drawing_viewer", "--workspace_path", std::string(LIMN_SAMPLE_DIR) + "/" + workspace,
               "--output_path", folder.string(), "--thumbnail_size", "640"});
  std::cout << run.out << run.err;
  return run.exit_code == 0;
}

bool MakePages(const fs::path& folder) {
  const ViewerScene wires = WireScene();
  WritePage(folder / "wires.html", wires);
  WriteFileAtomically((folder / "wires.json").string(), Expectations(wires).dump());
  const ViewerScene edit = EditScene();
  WritePage(folder / "edit.html", edit);
  WriteFileAtomically((folder / "edit.json").string(), EditExpectations(edit).dump());
  for (const std::string name : {"kept", "renewed"}) {
    ViewerScene scene = edit;
    scene.drawing = {"drawing.json", name};
    WritePage(folder / name / "drawing.html", scene);
  }
  WritePage(folder / "large.html", LargeScene());
  WritePage(folder / "many.html", ManyLinksScene());
  return MakeSamplePage(folder / "day", "day") && MakeSamplePage(folder / "distorted", "distorted");
}

}  // namespace
}  // namespace limn::testing

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_pages <folder>\n";
    return 1;
  }
  try {
    return limn::testing::MakePages(argv[1]) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "ERROR: " << error.what() << "\n";
    return 1;
  }
}
