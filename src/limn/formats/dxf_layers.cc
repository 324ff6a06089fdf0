#include "limn/formats/dxf_layers.h"

#include <algorithm>
#include <map>

#include "limn/formats/link_kind.h"
#include "limn/model/drawing_paths.h"

namespace limn {
namespace {

constexpr int kForeground = 7;  // black on white, white on black

// Colors 10, 20, ... 240 are the hues of the color wheel; + 2, 4, 6 the same darker.
int ColorOfClass(const std::string& primitive, DenseClass dense_class) {
  static const std::map<std::string, int> hues = {
      {"line", 40}, {"arc", 10}, {"circle", 210}, {"spline", 150}, {"polyline", 90}};
  return hues.at(primitive) + 2 * static_cast<int>(dense_class);
}

int ColorOfKind(LinkKind kind) {
  switch (kind) {
    case LinkKind::kUnknown:
      return 9;  // gray
    case LinkKind::kEdge:
      return kForeground;
    case LinkKind::kPaint:
      return 30;
    case LinkKind::kShadow:
      return 170;
    case LinkKind::kContour:
      return 200;
  }
  return kForeground;
}

// Hues of neighboring numbers are far apart: 7 and 24 have no common divisor.
int ColorOfComponent(int component) { return 10 + 10 * (component * 7 % 24); }

DxfLayer LayerOfClass(const DrawingLink& link) {
  const std::string primitive = PrimitiveName(link);
  const DenseClass dense_class = ClassOf(link);
  const std::string suffix =
      link.dense ? std::string("_") + DenseClassName(dense_class) : std::string();
  return {primitive + suffix, ColorOfClass(primitive, dense_class)};
}

std::vector<DxfLayer> LayersOfLinks(const DrawingGraph& graph, DxfLayers layers) {
  std::vector<DxfLayer> of_links;
  if (layers == DxfLayers::kClass) {
    for (const DrawingLink& link : graph.links) of_links.push_back(LayerOfClass(link));
  } else if (layers == DxfLayers::kKind) {
    for (const DrawingLink& link : graph.links) {
      of_links.push_back({LinkKindName(link.kind), ColorOfKind(link.kind)});
    }
  } else if (layers == DxfLayers::kComponent) {
    const std::vector<int> components = ComponentsOfLinks(graph);
    const int count =
        components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
    const size_t width = std::to_string(count).size();
    for (const int component : components) {
      const std::string number = std::to_string(component + 1);
      of_links.push_back({"component_" + std::string(width - number.size(), '0') + number,
                          ColorOfComponent(component)});
    }
  } else {
    of_links.assign(graph.links.size(), {"drawing", kForeground});
  }
  return of_links;
}

}  // namespace

DxfLayerPlan PlanDxfLayers(const DrawingGraph& graph, const DxfOptions& options) {
  const std::vector<DxfLayer> of_links = LayersOfLinks(graph, options.layers);
  std::map<std::string, int> colors;
  for (const DxfLayer& layer : of_links) colors[layer.name] = layer.color;
  DxfLayerPlan plan;
  std::map<std::string, int> index;
  for (const auto& [name, color] : colors) {
    index[name] = static_cast<int>(plan.layers.size());
    plan.layers.push_back({name, color});
  }
  for (const DxfLayer& layer : of_links) plan.of_link.push_back(index.at(layer.name));
  const bool has_junctions =
      std::any_of(graph.nodes.begin(), graph.nodes.end(),
                  [](const DrawingNode& node) { return node.kind == NodeKind::kJunction; });
  if (options.junctions && has_junctions) {
    plan.of_junctions = static_cast<int>(plan.layers.size());
    plan.layers.push_back({"junctions", kForeground});
  }
  return plan;
}

}  // namespace limn
