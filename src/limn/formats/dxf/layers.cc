// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/dxf/layers.h"

#include <algorithm>
#include <array>
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

constexpr int kWide = 35, kMiddle = 25, kThin = 18, kFine = 13, kSectionWeight = 50;

// As drafting wants them: what bounds a body is wide, what is on its surface thin, a center line
// dash-dotted. Unknown is gray, texture dark gray.
DxfLayer LayerOfKind(LinkKind kind) {
  static const std::array<DxfLayer, kNumLinkKinds> layers = {{
      {LinkKindName(LinkKind::kUnknown), 9, DxfLineType::kContinuous, kMiddle},
      {LinkKindName(LinkKind::kEdge), kForeground, DxfLineType::kContinuous, kWide},
      {LinkKindName(LinkKind::kPaint), 30, DxfLineType::kContinuous, kThin},
      {LinkKindName(LinkKind::kShadow), 170, DxfLineType::kDotted, kFine},
      {LinkKindName(LinkKind::kContour), 200, DxfLineType::kContinuous, kMiddle},
      {LinkKindName(LinkKind::kRod), 90, DxfLineType::kCenter, kMiddle},
      {LinkKindName(LinkKind::kTexture), 8, DxfLineType::kContinuous, kFine},
  }};
  return layers[static_cast<int>(kind)];
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

std::string Numbered(const char* name, size_t number, size_t count) {
  const std::string digits = std::to_string(number);
  const size_t width = std::to_string(count).size();
  return name + std::string(width - digits.size(), '0') + digits;
}

DxfLayer LayerOfFace(int face, size_t num_faces) {
  return {Numbered("face_", face, num_faces - 1), ColorOfComponent(face)};
}

// The largest face that each link bounds; -1: none.
std::vector<int> FacesOfLinks(const DrawingGraph& graph) {
  std::vector<int> of_link(graph.links.size(), -1);
  std::vector<double> area(graph.links.size(), -1);
  for (size_t id = 0; id < graph.faces.size(); ++id) {
    const double of_face = AreaOf(graph.faces[id]);
    for (const FaceLoop& loop : graph.faces[id].loops) {
      for (const FaceEdge& edge : loop) {
        if (edge.IsBridge() || of_face <= area[edge.link]) continue;
        area[edge.link] = of_face;
        of_link[edge.link] = static_cast<int>(id);
      }
    }
  }
  return of_link;
}

std::vector<DxfLayer> LayersOfLinks(const DrawingGraph& graph, DxfLayers layers) {
  std::vector<DxfLayer> of_links;
  if (layers == DxfLayers::kClass) {
    for (const DrawingLink& link : graph.links) of_links.push_back(LayerOfClass(link));
  } else if (layers == DxfLayers::kKind) {
    for (const DrawingLink& link : graph.links) of_links.push_back(LayerOfKind(link.kind));
  } else if (layers == DxfLayers::kComponent) {
    const std::vector<int> components = ComponentsOfLinks(graph);
    const int count =
        components.empty() ? 0 : *std::max_element(components.begin(), components.end()) + 1;
    for (const int component : components) {
      of_links.push_back(
          {Numbered("component_", component + 1, count), ColorOfComponent(component)});
    }
  } else if (layers == DxfLayers::kFace) {
    for (const int face : FacesOfLinks(graph)) {
      of_links.push_back(face < 0 ? DxfLayer{"no_face", kForeground}
                                  : LayerOfFace(face, graph.faces.size()));
    }
  } else {
    of_links.assign(graph.links.size(), {"drawing", kForeground});
  }
  return of_links;
}

std::vector<DxfLayer> LayersOfFaces(const DrawingGraph& graph, DxfLayers layers) {
  constexpr int kGray = 8;
  std::vector<DxfLayer> of_faces(graph.faces.size(), {"faces", kGray});
  if (layers != DxfLayers::kFace) return of_faces;
  for (size_t id = 0; id < of_faces.size(); ++id) {
    of_faces[id] = LayerOfFace(static_cast<int>(id), of_faces.size());
  }
  return of_faces;
}

}  // namespace

const char* DxfLineTypeName(DxfLineType type) {
  switch (type) {
    case DxfLineType::kContinuous:
      return "Continuous";
    case DxfLineType::kHidden:
      return "HIDDEN";
    case DxfLineType::kCenter:
      return "CENTER";
    case DxfLineType::kDotted:
      return "DOT";
  }
  return "";
}

DxfLayerPlan PlanDxfLayers(const DrawingGraph& graph, const DxfOptions& options) {
  const std::vector<DxfLayer> of_links = LayersOfLinks(graph, options.layers);
  const std::vector<DxfLayer> of_faces = LayersOfFaces(graph, options.layers);
  std::map<std::string, DxfLayer> named;
  for (const DxfLayer& layer : of_links) named[layer.name] = layer;
  for (const DxfLayer& layer : of_faces) named[layer.name] = layer;
  DxfLayerPlan plan;
  std::map<std::string, int> index;
  for (const auto& [name, layer] : named) {
    index[name] = static_cast<int>(plan.layers.size());
    plan.layers.push_back(layer);
  }
  for (const DxfLayer& layer : of_links) plan.of_link.push_back(index.at(layer.name));
  for (const DxfLayer& layer : of_faces) plan.of_face.push_back(index.at(layer.name));
  const bool has_junctions =
      std::any_of(graph.nodes.begin(), graph.nodes.end(),
                  [](const DrawingNode& node) { return node.kind == NodeKind::kJunction; });
  if (options.junctions && has_junctions) {
    plan.of_junctions = static_cast<int>(plan.layers.size());
    plan.layers.push_back({"junctions", kForeground});
  }
  const auto add_if = [&](bool is_needed, const DxfLayer& layer) {
    if (!is_needed) return -1;
    plan.layers.push_back(layer);
    return static_cast<int>(plan.layers.size()) - 1;
  };
  add_if(!graph.dimensions.empty(),
         {kDxfDimensionLayer, kForeground, DxfLineType::kContinuous, kThin});
  if (options.plan) {
    constexpr int kLightGray = 9;
    plan.of_hidden = add_if(!options.plan->hidden.graph.links.empty(),
                            {"hidden", kLightGray, DxfLineType::kHidden, kThin});
    const Section& section = options.plan->section;
    plan.of_section = add_if(!section.lines.empty(),
                             {"section", kForeground, DxfLineType::kContinuous, kSectionWeight});
    plan.of_section_points =
        add_if(!section.points.empty(),
               {"section_points", kForeground, DxfLineType::kContinuous, kSectionWeight});
    if (options.paper_space) plan.layers.push_back({kDxfSheetLayer, kForeground});
  }
  return plan;
}

}  // namespace limn
