// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pictures/draw_node.h"

namespace limn {
namespace {

constexpr Color kRimColor = {0, 0, 0};
constexpr double kRimPx = 1;

Color ColorOfKind(NodeKind kind) {
  if (kind == NodeKind::kJunction) return {255, 255, 255};
  return kind == NodeKind::kEnd ? Color{255, 230, 0} : Color{0, 230, 255};
}

void DrawMark(NodeKind kind, const Eigen::Vector2d& pixel, double radius, double rim,
              const Color& color, Canvas* canvas) {
  switch (kind) {
    case NodeKind::kJunction:
      canvas->DrawDisc(pixel, radius + rim, color);
      break;
    case NodeKind::kEnd:
      canvas->DrawSquare(pixel, 0.45 * radius + rim, color);
      break;
    case NodeKind::kLoopAnchor:
      canvas->DrawDiamond(pixel, radius + rim, color);
      break;
  }
}

}  // namespace

void DrawNode(const View& view, const DrawingNode& node, double radius_px, Canvas* canvas) {
  const std::optional<Eigen::Vector2d> pixel = view.Project(node.position_in_world);
  const std::optional<Eigen::Vector2d> stored =
      pixel ? view.StoredFromVirtual(*pixel) : std::nullopt;
  if (!stored) return;
  DrawMark(node.kind, *stored, radius_px, kRimPx, kRimColor, canvas);
  DrawMark(node.kind, *stored, radius_px, 0, ColorOfKind(node.kind), canvas);
}

}  // namespace limn
