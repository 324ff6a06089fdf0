// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/glb_drawing_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>
#include <string>

#include <Eigen/Geometry>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include "limn/formats/face_mesh.h"
#include "limn/formats/link_kind.h"
#include "limn/formats/tube_mesh.h"
#include "limn/geometry/polyline.h"
#include "limn/model/drawing_paths.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"
#include "limn/version.h"

namespace limn {
namespace {

using Value = tinygltf::Value;

// A vertex's bytes in each of the buffer views, and an index's.
constexpr size_t kPositionBytes = 3 * sizeof(float);
constexpr size_t kNormalBytes = 3 * sizeof(float);
constexpr size_t kColorBytes = 4 * sizeof(uint16_t);
constexpr size_t kLinkBytes = sizeof(float);
constexpr size_t kIndexBytes = sizeof(uint32_t);
// Room for the JSON beside the buffer in a file of at most 4 GB.
constexpr size_t kMaxBufferBytes = 3'500'000'000;

uint16_t LinearFromSrgb(uint8_t channel) {
  const double value = channel / 255.0;
  const double linear = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  return static_cast<uint16_t>(std::lround(65535 * linear));
}

Eigen::Vector3d YUp(const Eigen::Vector3d& point) { return {point.x(), point.z(), -point.y()}; }

Eigen::Vector3d MiddleOf(const DrawingGraph& graph) {
  Eigen::AlignedBox3d box;
  for (const DrawingLink& link : graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) box.extend(point);
  }
  return box.isEmpty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(box.center());
}

tinygltf::Material CurveMaterial() {
  tinygltf::Material material;
  material.name = "curves and points";
  material.extensions["KHR_materials_unlit"] = Value(Value::Object());
  return material;
}

tinygltf::Material MattMaterial(const std::string& name) {
  constexpr double kGray = 0.6;
  tinygltf::Material material;
  material.name = name;
  material.doubleSided = true;
  material.pbrMetallicRoughness.baseColorFactor = {kGray, kGray, kGray, 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 1;
  return material;
}

// A normal per vertex.
struct Triangles {
  const std::vector<Eigen::Vector3d>& vertices;
  const std::vector<Eigen::Vector3d>& normals;
  const std::vector<std::array<int, 3>>& triangles;
};

// Collects vertices and what refers to them: first those with colors, then those with normals.
class SceneBuilder {
 public:
  explicit SceneBuilder(const Eigen::Vector3d& origin) : origin_(origin) {
    model_.asset.version = "2.0";
    model_.asset.generator = "limn " LIMN_VERSION;
    model_.materials.push_back(CurveMaterial());
    model_.extensionsUsed = {"KHR_materials_unlit"};
    tinygltf::Node root;
    root.name = "drawing";
    const Eigen::Vector3d at = YUp(origin);
    root.translation = {at.x(), at.y(), at.z()};
    model_.nodes.push_back(root);
    model_.scenes.resize(1);
    model_.scenes[0].nodes = {0};
    model_.defaultScene = 0;
  }

  // Vertices are added, then made a child of the drawing.
  void AddVertex(const Eigen::Vector3d& point, const Color& color) {
    AddPosition(point);
    for (const uint8_t channel : {color.red, color.green, color.blue}) {
      colors_.push_back(LinearFromSrgb(channel));
    }
    colors_.push_back(std::numeric_limits<uint16_t>::max());
  }

  // The vertices since the last child, as points or as a strip; a ring returns to its first.
  void AddChild(const std::string& name, int mode, bool is_ring, Value::Object extras) {
    const size_t count = positions_.size() / 3 - first_vertex_;
    tinygltf::Primitive primitive;
    primitive.mode = mode;
    primitive.material = kCurves;
    primitive.attributes["POSITION"] = AddPositions(count);
    primitive.attributes["COLOR_0"] = AddColors(count);
    if (is_ring) primitive.indices = AddRing(count);
    first_vertex_ += count;
    AddMesh(name, primitive, std::move(extras));
  }

  // The vertices since the last child, each of which is of a link, joined in pairs by `segments`.
  void AddLines(const std::string& name, const std::vector<uint32_t>& segments,
                const std::vector<LinkId>& links, Value::Object extras) {
    const size_t count = links.size();
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_LINE;
    primitive.material = kCurves;
    primitive.attributes["POSITION"] = AddPositions(count);
    primitive.attributes["COLOR_0"] = AddColors(count);
    primitive.attributes["_LINK"] = AddLinkIds(links);
    primitive.indices = AddIndices(segments);
    first_vertex_ += count;
    AddMesh(name, primitive, std::move(extras));
  }

  // Triangles; after all children with colors.
  void AddTriangles(const std::string& name, const Triangles& surface, const std::string& material,
                    Value::Object extras) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = MattMaterialNamed(material);
    for (const Eigen::Vector3d& vertex : surface.vertices) AddPosition(vertex);
    primitive.attributes["POSITION"] = AddPositions(surface.vertices.size());
    primitive.attributes["NORMAL"] = AddNormals(surface.normals);
    std::vector<uint32_t> corners;
    for (const auto& triangle : surface.triangles) {
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    primitive.indices = AddIndices(corners);
    first_vertex_ += surface.vertices.size();
    AddMesh(name, primitive, std::move(extras));
  }

  void Write(std::ostream& out) {
    if (NumBytes() > kMaxBufferBytes) {
      throw InputError("the drawing and its cloud are too large for a .glb file");
    }
    if (NumBytes() > 0) AddBuffer();
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model_, out, /*prettyPrint=*/false,
                                                     /*writeBinary=*/true)) {
      throw InputError("the scene cannot be written");
    }
  }

 private:
  static constexpr int kCurves = 0;  // the material
  // Accessors name their buffer views by these until the views are made.
  enum ViewKind { kPositions, kColors, kIndices, kNormals, kLinkIds };

  // The material's index.
  int MattMaterialNamed(const std::string& name) {
    std::vector<tinygltf::Material>& materials = model_.materials;
    const auto found = std::ranges::find(materials, name, &tinygltf::Material::name);
    const auto index = static_cast<int>(found - materials.begin());
    if (found == materials.end()) materials.push_back(MattMaterial(name));
    return index;
  }

  void AddPosition(const Eigen::Vector3d& point) {
    const Eigen::Vector3f place = YUp(point - origin_).cast<float>();
    if (!place.allFinite()) throw InputError("coordinates are too large for a .glb file");
    positions_.insert(positions_.end(), place.data(), place.data() + 3);
  }

  // An object with this mesh.
  void AddMesh(const std::string& name, const tinygltf::Primitive& primitive,
               Value::Object extras) {
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(primitive);
    model_.meshes.push_back(mesh);
    tinygltf::Node node;
    node.name = name;
    node.mesh = static_cast<int>(model_.meshes.size()) - 1;
    if (!extras.empty()) node.extras = Value(std::move(extras));
    model_.nodes[0].children.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(node);
  }

  size_t NumBytes() const {
    return sizeof(float) * (positions_.size() + normals_.size() + link_ids_.size()) +
           sizeof(uint16_t) * colors_.size() + kIndexBytes * indices_.size();
  }

  int AddAccessor(const tinygltf::Accessor& accessor) {
    model_.accessors.push_back(accessor);
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int AddPositions(size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = kPositions;
    accessor.byteOffset = kPositionBytes * first_vertex_;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.count = count;
    for (int axis = 0; axis < 3; ++axis) {
      float lowest = std::numeric_limits<float>::infinity();
      float highest = -lowest;
      for (size_t i = 3 * first_vertex_ + axis; i < positions_.size(); i += 3) {
        lowest = std::min(lowest, positions_[i]);
        highest = std::max(highest, positions_[i]);
      }
      accessor.minValues.push_back(lowest);
      accessor.maxValues.push_back(highest);
    }
    return AddAccessor(accessor);
  }

  int AddColors(size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = kColors;
    accessor.byteOffset = kColorBytes * first_vertex_;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    accessor.normalized = true;
    accessor.type = TINYGLTF_TYPE_VEC4;
    accessor.count = count;
    return AddAccessor(accessor);
  }

  int AddLinkIds(const std::vector<LinkId>& links) {
    tinygltf::Accessor accessor;
    accessor.bufferView = kLinkIds;
    accessor.byteOffset = kLinkBytes * link_ids_.size();
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;  // no attribute may be a uint32
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = links.size();
    link_ids_.insert(link_ids_.end(), links.begin(), links.end());
    return AddAccessor(accessor);
  }

  int AddNormals(const std::vector<Eigen::Vector3d>& normals) {
    tinygltf::Accessor accessor;
    accessor.bufferView = kNormals;
    accessor.byteOffset = sizeof(float) * normals_.size();
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = TINYGLTF_TYPE_VEC3;
    accessor.count = normals.size();
    for (const Eigen::Vector3d& normal : normals) {
      const Eigen::Vector3f y_up = YUp(normal).cast<float>();
      normals_.insert(normals_.end(), y_up.data(), y_up.data() + 3);
    }
    return AddAccessor(accessor);
  }

  int AddRing(size_t count) {
    std::vector<uint32_t> indices(count + 1);
    std::iota(indices.begin(), indices.end() - 1, 0);
    indices.back() = 0;
    return AddIndices(indices);
  }

  int AddIndices(const std::vector<uint32_t>& indices) {
    tinygltf::Accessor accessor;
    accessor.bufferView = kIndices;
    accessor.byteOffset = kIndexBytes * indices_.size();
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = indices.size();
    indices_.insert(indices_.end(), indices.begin(), indices.end());
    return AddAccessor(accessor);
  }

  // Returns its index, -1 if there are no values.
  template <typename T>
  int AddView(const std::vector<T>& values, int target, size_t stride) {
    if (values.empty()) return -1;
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = sizeof(T) * values.size();
    view.byteStride = stride;
    view.target = target;
    model_.bufferViews.push_back(view);
    bytes.resize(bytes.size() + view.byteLength);
    std::memcpy(bytes.data() + view.byteOffset, values.data(), view.byteLength);
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }

  void AddBuffer() {
    model_.buffers.resize(1);
    model_.buffers[0].data.reserve(NumBytes());
    const int index_of[] = {AddView(positions_, TINYGLTF_TARGET_ARRAY_BUFFER, kPositionBytes),
                            AddView(colors_, TINYGLTF_TARGET_ARRAY_BUFFER, kColorBytes),
                            AddView(indices_, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, 0),
                            AddView(normals_, TINYGLTF_TARGET_ARRAY_BUFFER, kNormalBytes),
                            AddView(link_ids_, TINYGLTF_TARGET_ARRAY_BUFFER, kLinkBytes)};
    for (tinygltf::Accessor& accessor : model_.accessors) {
      accessor.bufferView = index_of[accessor.bufferView];
    }
  }

  Eigen::Vector3d origin_;
  tinygltf::Model model_;
  std::vector<float> positions_;
  std::vector<uint16_t> colors_;
  std::vector<float> normals_;
  std::vector<float> link_ids_;
  std::vector<uint32_t> indices_;
  size_t first_vertex_ = 0;
};

std::string NodeNameOf(const DrawingGraph& graph, LinkId id) {
  return "link_" + std::to_string(NumberOfLink(graph, id));
}

Value::Object ExtrasOf(const DrawingGraph& graph, LinkId id, LinkId curve) {
  const DrawingLink& link = graph.links[id];
  Value::Object extras = {{"link", Value(NumberOfLink(graph, id))},
                          {"curve", Value(NumberOfLink(graph, curve))},
                          {"length", Value(Length(link.points_in_world))},
                          {"closed", Value(link.closed)},
                          {"residual_px", Value(link.residual_px)},
                          {"views", Value(static_cast<int>(link.supporting_views.size()))}};
  if (link.primitive) extras["primitive"] = Value(std::string(ShapeName(link.primitive->shape)));
  if (link.dense) extras["class"] = Value(std::string(DenseClassName(link.dense->dense_class)));
  if (link.kind != LinkKind::kUnknown) {
    extras["kind"] = Value(std::string(LinkKindName(link.kind)));
    extras["kind_confidence"] = Value(link.kind_confidence);
  }
  if (link.kind == LinkKind::kRod) extras["rod_radius"] = Value(link.rod_radius);
  if (link.tentative) extras["tentative"] = Value(true);
  return extras;
}

// A closed link repeats its first.
size_t NumDistinctPoints(const DrawingLink& link) {
  return link.points_in_world.size() - (link.closed ? 1 : 0);
}

void AddLink(const DrawingGraph& graph, LinkId id, LinkId curve, SceneBuilder* scene) {
  const DrawingLink& link = graph.links[id];
  const size_t count = NumDistinctPoints(link);
  for (size_t i = 0; i < count; ++i) scene->AddVertex(link.points_in_world[i], ColorOfCurve(curve));
  scene->AddChild(NodeNameOf(graph, id), TINYGLTF_MODE_LINE_STRIP, link.closed,
                  ExtrasOf(graph, id, curve));
}

// The name of the object that has a link if each kind is one.
std::string KindObject(const DrawingLink& link) {
  return link.tentative ? "tentative" : LinkKindName(link.kind);
}

void AddKind(const DrawingGraph& graph, const std::string& name, const std::vector<LinkId>& ids,
             const std::vector<LinkId>& curves, SceneBuilder* scene) {
  std::vector<uint32_t> segments;
  std::vector<LinkId> link_of_vertex;
  double length = 0;
  for (const LinkId id : ids) {
    const DrawingLink& link = graph.links[id];
    const auto first = static_cast<uint32_t>(link_of_vertex.size());
    const auto count = static_cast<uint32_t>(NumDistinctPoints(link));
    for (uint32_t i = 0; i < count; ++i) {
      scene->AddVertex(link.points_in_world[i], ColorOfCurve(curves[id]));
      if (i + 1 < count || link.closed) {
        segments.insert(segments.end(), {first + i, first + (i + 1) % count});
      }
    }
    link_of_vertex.insert(link_of_vertex.end(), count, NumberOfLink(graph, id));
    length += Length(link.points_in_world);
  }
  scene->AddLines(name, segments, link_of_vertex,
                  {{"kind", Value(name)},
                   {"links", Value(static_cast<int>(ids.size()))},
                   {"length", Value(length)}});
}

void AddKinds(const DrawingGraph& graph, const std::vector<LinkId>& links,
              const std::vector<LinkId>& curves, SceneBuilder* scene) {
  std::map<std::string, std::vector<LinkId>> kinds;
  for (const LinkId id : links) kinds[KindObject(graph.links[id])].push_back(id);
  for (const auto& [name, ids] : kinds) AddKind(graph, name, ids, curves, scene);
}

void AddTube(const DrawingGraph& graph, LinkId id, LinkId curve, SceneBuilder* scene) {
  const DrawingLink& link = graph.links[id];
  const TubeMesh tube = MakeTube(link.points_in_world, link.closed, link.rod_radius);
  scene->AddTriangles(NodeNameOf(graph, id), {tube.vertices, tube.normals, tube.triangles}, "rods",
                      ExtrasOf(graph, id, curve));
}

void AddJunctions(const DrawingGraph& graph, SceneBuilder* scene) {
  constexpr Color kWhite = {255, 255, 255};
  Value::Array ids;
  for (size_t id = 0; id < graph.nodes.size(); ++id) {
    if (graph.nodes[id].kind != NodeKind::kJunction) continue;
    scene->AddVertex(graph.nodes[id].position_in_world, kWhite);
    ids.push_back(Value(NumberOfNode(graph, id)));
  }
  if (ids.empty()) return;
  scene->AddChild("junctions", TINYGLTF_MODE_POINTS, false, {{"nodes", Value(std::move(ids))}});
}

void AddFaces(const DrawingGraph& graph, SceneBuilder* scene) {
  for (size_t id = 0; id < graph.faces.size(); ++id) {
    const DrawingFace& face = graph.faces[id];
    if (face.triangles.empty()) continue;
    scene->AddTriangles("face_" + std::to_string(id),
                        {face.vertices, VertexNormals(face), face.triangles}, "faces",
                        {{"face", Value(static_cast<int>(id))},
                         {"surface", Value(std::string(FaceSurfaceName(face.surface)))},
                         {"area", Value(AreaOf(face))},
                         {"confidence", Value(face.confidence)},
                         {"views", Value(static_cast<int>(face.views.size()))}});
  }
}

void WriteInMeters(const DrawingGraph& graph, const GlbOptions& options, std::ostream& out) {
  SceneBuilder scene(MiddleOf(graph));
  const std::vector<LinkId> curves = CurvesOf(graph);
  std::vector<LinkId> lines, tubes;
  for (LinkId id = 0; id < static_cast<LinkId>(graph.links.size()); ++id) {
    const bool is_tube = options.rods_as_tubes && graph.links[id].kind == LinkKind::kRod;
    (is_tube ? tubes : lines).push_back(id);
  }
  if (options.objects == GlbObjects::kKind) {
    AddKinds(graph, lines, curves, &scene);
  } else {
    for (const LinkId id : lines) AddLink(graph, id, curves[id], &scene);
  }
  if (options.junctions) AddJunctions(graph, &scene);
  for (const GlbPoint& point : options.cloud) scene.AddVertex(point.position, point.color);
  if (!options.cloud.empty()) scene.AddChild("cloud", TINYGLTF_MODE_POINTS, false, {});
  for (const LinkId id : tubes) AddTube(graph, id, curves[id], &scene);
  AddFaces(graph, &scene);
  scene.Write(out);
}

}  // namespace

void WriteDrawingGlb(const DrawingGraph& graph, const GlbOptions& options, LengthUnit unit,
                     std::ostream& out) {
  if (unit == LengthUnit::kNone || unit == LengthUnit::kMeter) {
    WriteInMeters(graph, options, out);
    return;
  }
  const double meters = Millimeters(unit) / 1000;
  GlbOptions in_meters = options;
  for (GlbPoint& point : in_meters.cloud) point.position *= meters;
  WriteInMeters(Transformed(graph, meters, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()),
                in_meters, out);
}

}  // namespace limn
