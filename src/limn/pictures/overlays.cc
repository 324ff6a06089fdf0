// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pictures/overlays.h"

#include <algorithm>

#include "limn/formats/tracks_writer.h"
#include "limn/model/drawing_paths.h"
#include "limn/pictures/canvas.h"
#include "limn/pictures/draw_node.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr int kSmallImagePx = 1000;
// Largest radius of a mark, as a share of the longest link at the node.
constexpr double kMarkShare = 1.0 / 6;

int Scale(const PictureOptions& options, int width, int height) {
  if (options.scale > 0) return options.scale;
  return std::max(width, height) < kSmallImagePx ? 2 : 1;
}

Canvas MakeCanvas(const Image& photo, const PictureOptions& options) {
  return Canvas(photo, options.brightness, Scale(options, photo.width, photo.height));
}

void CheckSize(const Image& photo, int width, int height, const std::string& what) {
  if (photo.ViewWidth() == width && photo.ViewHeight() == height) return;
  throw InputError(what + ": the photograph has " + std::to_string(photo.ViewWidth()) + "x" +
                   std::to_string(photo.ViewHeight()) + " pixels, not " + std::to_string(width) +
                   "x" + std::to_string(height));
}

Color Faded(const Color& color) {
  const auto fade = [](uint8_t channel) { return static_cast<uint8_t>((channel + 110) / 2); };
  return {fade(color.red), fade(color.green), fade(color.blue)};
}

// Returns the length of what is drawn, stored px.
double DrawPolyline(const View& view, const std::vector<Eigen::Vector3d>& points,
                    const Color& color, int width, Canvas* canvas) {
  double length = 0;
  for (const auto& run : ProjectPolyline(view, points)) {
    canvas->DrawLine(run, color, width);
    for (size_t k = 0; k + 1 < run.size(); ++k) length += (run[k + 1] - run[k]).norm();
  }
  return length;
}

// Whether a link is to be seen clearly: the view supports it, and exports have it, or a rod in its
// place.
bool IsClear(ViewId view, const DrawingLink& link) {
  return LinkSelection::AsSeen().Has(link) &&
         std::ranges::binary_search(link.supporting_views, view);
}

// All kinds, and tentative links, too, faded as they may be.
LinkSelection DrawnLinks(Detail detail) {
  LinkSelection selection;
  selection.kinds = KindsFromNames("all");
  selection.kinds[static_cast<int>(LinkKind::kTexture)] = false;
  selection.tentative = true;
  selection.Set(detail);
  return selection;
}

Color ColorOf(EdgelFate fate) {
  switch (fate) {
    case EdgelFate::kTexture:
      return {90, 70, 130};
    case EdgelFate::kNotLinked:
    case EdgelFate::kNotSketched:
      return {128, 128, 128};
    case EdgelFate::kFragmentTooShort:
      return {70, 110, 255};
    case EdgelFate::kNoPartner:
    case EdgelFate::kTooFewViews:
      return {255, 40, 40};
    case EdgelFate::kInconsistent:
    case EdgelFate::kPieceTooShort:
    case EdgelFate::kSketched:
    case EdgelFate::kLostSupport:
    case EdgelFate::kNotTraced:
      return {255, 150, 0};
    case EdgelFate::kDoubtfulLink:
      return {255, 255, 0};
    case EdgelFate::kPrunedLink:
      return {0, 220, 255};
    case EdgelFate::kDrawn:
    case EdgelFate::kExplained:
      return {0, 255, 0};
  }
  return {};
}

}  // namespace

void PictureOptions::Check() const {
  LIMN_CHECK_OPTION(scale, >= 0);
  LIMN_CHECK_OPTION(scale, <= 8);
  LIMN_CHECK_OPTION(brightness, >= 0);
  LIMN_CHECK_OPTION(brightness, <= 1);
  LIMN_CHECK_OPTION(line_width_px, >= 1);
  LIMN_CHECK_OPTION(line_width_px, <= 100);
  LIMN_CHECK_OPTION(node_radius_px, >= 0);
  LIMN_CHECK_OPTION(node_radius_px, <= 100);
}

Picture DrawOverlay(const Image& photo, const View& view, ViewId view_id, const DrawingGraph& graph,
                    const PictureOptions& options) {
  options.Check();
  CheckSize(photo, view.camera.width, view.camera.height, view.name);
  Canvas canvas = MakeCanvas(photo, options);
  const std::vector<LinkId> curves = CurvesOf(graph);
  const int scale = Scale(options, photo.width, photo.height);
  const LinkSelection drawn = DrawnLinks(options.detail);
  std::vector<double> clear_px(graph.links.size(), 0);  // of the picture
  for (const bool clear : {false, true}) {
    for (size_t id = 0; id < graph.links.size(); ++id) {
      const DrawingLink& link = graph.links[id];
      if (!drawn.Has(link) || IsClear(view_id, link) != clear) continue;
      const Color color = ColorOfCurve(curves[id]);
      const double length = DrawPolyline(view, link.points_in_world, clear ? color : Faded(color),
                                         clear ? options.line_width_px : 1, &canvas);
      if (clear) clear_px[id] = length * scale;
    }
  }
  for (DrawingNode node : graph.nodes) {
    std::erase_if(node.incident,
                  [&](const LinkEnd& end) { return !drawn.Has(graph.links[end.link]); });
    node.kind = KindOf(graph, node);
    double longest_px = 0;
    for (const LinkEnd& end : node.incident) {
      longest_px = std::max(longest_px, clear_px[end.link]);
    }
    const double radius_px = std::min(options.node_radius_px, kMarkShare * longest_px);
    if (radius_px > 0) DrawNode(view, node, radius_px, &canvas);
  }
  return canvas.picture();
}

Picture DrawOverlay(const Image& photo, const View& view, const CurveSketch& sketch,
                    const PictureOptions& options) {
  options.Check();
  CheckSize(photo, view.camera.width, view.camera.height, view.name);
  Canvas canvas = MakeCanvas(photo, options);
  for (size_t id = 0; id < sketch.curves.size(); ++id) {
    const Curve3D& curve = sketch.curves[id];
    std::vector<Eigen::Vector3d> points = curve.points_in_world;
    if (curve.closed && !points.empty()) points.push_back(points.front());
    DrawPolyline(view, points, ColorOfCurve(static_cast<int>(id)), options.line_width_px, &canvas);
  }
  return canvas.picture();
}

Picture DrawFragments(const Image& photo, const ImageCurves& curves,
                      const PictureOptions& options) {
  options.Check();
  CheckSize(photo, curves.edge_map.width, curves.edge_map.height, "fragments");
  Canvas canvas = MakeCanvas(photo, options);
  for (size_t id = 0; id < curves.fragments.size(); ++id) {
    const CurveFragment& fragment = curves.fragments[id];
    std::vector<Eigen::Vector2d> points;
    for (const EdgelId edgel : fragment.edgel_ids) {
      points.push_back(curves.edge_map.edgels[edgel].stored_px.cast<double>());
    }
    if (fragment.closed && !points.empty()) points.push_back(points.front());
    canvas.DrawLine(points, ColorOfCurve(static_cast<int>(id)), options.line_width_px);
  }
  return canvas.picture();
}

Picture DrawAccount(const Image& photo, const ImageCurves& curves,
                    const std::vector<EdgelFate>& fates, const PictureOptions& options) {
  options.Check();
  CheckSize(photo, curves.edge_map.width, curves.edge_map.height, "account");
  Canvas canvas = MakeCanvas(photo, options);
  constexpr double kHalfLengthPx = 0.5;
  for (size_t id = 0; id < fates.size(); ++id) {
    const Edgel& edgel = curves.edge_map.edgels[id];
    const Eigen::Vector2d center = edgel.stored_px.cast<double>();
    const Eigen::Vector2d half =
        kHalfLengthPx * (edgel.stored_from_virtual.cast<double>() * edgel.Tangent()).normalized();
    canvas.DrawLine({center - half, center + half}, ColorOf(fates[id]), 1);
  }
  return canvas.picture();
}

}  // namespace limn
