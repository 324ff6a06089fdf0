// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <variant>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/python/arrays.h"
#include "colmap_ext/python/bindings.h"
#include "colmap_ext/python/run_free.h"
#include "colmap_ext/workspace/view_set.h"
#include "limn/formats/tracks_writer.h"
#include "limn/geometry/polyline.h"
#include "limn/model/link_selection.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace py = pybind11;

namespace {

using Array = py::array_t<double>;
using Owner = std::shared_ptr<SceneDrawing>;

struct Link {
  Owner drawing;
  size_t id = 0;

  const DrawingLink& Get() const { return drawing->graph.links[id]; }
};

struct Node {
  Owner drawing;
  size_t id = 0;

  const DrawingNode& Get() const { return drawing->graph.nodes[id]; }
};

struct Face {
  Owner drawing;
  size_t id = 0;

  const DrawingFace& Get() const { return drawing->graph.faces[id]; }
};

struct Primitive {
  Link link;

  const LinkPrimitive& Get() const { return *link.Get().primitive; }
  template <typename Shape>
  const Shape* As() const {
    return std::get_if<Shape>(&Get().shape);
  }
};

// Links, nodes or faces as a sequence.
template <typename Item>
struct Items {
  Owner drawing;
};

std::vector<std::string> NamesOf(const std::vector<ViewId>& views, const SceneDrawing& drawing) {
  std::vector<std::string> names;
  for (const ViewId view : views) names.push_back(drawing.metadata.view_names[view]);
  return names;
}

std::vector<std::string> SupportingViews(const Link& link) {
  return NamesOf(link.Get().supporting_views, *link.drawing);
}

// Per loop the edges: the link, or none of a bridge, and where on it the edge begins and ends.
using EdgeTuple = std::tuple<std::optional<LinkId>, double, double>;
std::vector<std::vector<EdgeTuple>> LoopsOf(const Face& face) {
  std::vector<std::vector<EdgeTuple>> loops;
  for (const FaceLoop& loop : face.Get().loops) {
    loops.emplace_back();
    for (const FaceEdge& edge : loop) {
      const auto link = edge.IsBridge() ? std::nullopt : std::optional<LinkId>(edge.link);
      loops.back().emplace_back(link, edge.from, edge.to);
    }
  }
  return loops;
}

std::optional<Array> NormalOf(const Face& face) {
  if (face.Get().surface != FaceSurface::kPlane) return std::nullopt;
  return CopyOf(face.Get().normal);
}

std::optional<double> OffsetOf(const Face& face) {
  if (face.Get().surface != FaceSurface::kPlane) return std::nullopt;
  return face.Get().offset;
}

// Runs in a row, with not-a-number between them.
Array JoinRuns(const std::vector<std::vector<Eigen::Vector2d>>& runs) {
  std::vector<Eigen::Vector2d> rows;
  for (const auto& run : runs) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    if (!rows.empty()) rows.emplace_back(kNaN, kNaN);
    rows.insert(rows.end(), run.begin(), run.end());
  }
  Array array({rows.size(), size_t{2}});
  auto values = array.mutable_unchecked<2>();
  for (size_t i = 0; i < rows.size(); ++i) {
    values(i, 0) = rows[i].x();
    values(i, 1) = rows[i].y();
  }
  return array;
}

py::dict TracksOf(const Link& link) {
  const SceneDrawing& drawing = *link.drawing;
  if (!drawing.scene) {
    throw InputError("tracks: the drawing was read without its cameras: read_drawing(path, scene)");
  }
  Polyline3d points = link.Get().points_in_world;
  for (Eigen::Vector3d& point : points) point -= drawing.scene->scene.origin();
  // Parts of a panorama are one image.
  std::map<std::string, std::vector<std::vector<Eigen::Vector2d>>> runs_of_image;
  for (const ViewId id : link.Get().supporting_views) {
    const View view = InStoredImage(drawing.scene->scene.view_set(), id, drawing.views[id]);
    auto runs = ProjectPolyline(view, points);
    if (runs.empty()) continue;
    auto& all = runs_of_image[view.name];
    all.insert(all.end(), std::make_move_iterator(runs.begin()),
               std::make_move_iterator(runs.end()));
  }
  py::dict tracks;
  for (const auto& [name, runs] : runs_of_image) tracks[py::str(name)] = JoinRuns(runs);
  return tracks;
}

std::optional<Primitive> PrimitiveOf(const Link& link) {
  if (!link.Get().primitive) return std::nullopt;
  return Primitive{link};
}

std::optional<std::string> DenseClassOf(const Link& link) {
  const auto& dense = link.Get().dense;
  if (!dense) return std::nullopt;
  return DenseClassName(dense->dense_class);
}

// Of what an object has as an attribute.
py::tuple AttributeOf(const py::object& object, const char* name) {
  return CallOf(py::module_::import("builtins").attr("getattr"), py::make_tuple(object, name));
}

template <typename Item>
py::tuple ItemOf(const Item& item, const char* items) {
  return CallOf(py::module_::import("operator").attr("getitem"),
                py::make_tuple(py::cast(item.drawing).attr(items), item.id));
}

std::array<double, 3> Numbers(const Eigen::Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}
Eigen::Vector3d ToVector3(const std::array<double, 3>& numbers) {
  return Eigen::Map<const Eigen::Vector3d>(numbers.data());
}

py::tuple PickledBody(const RoundBody& body) {
  return CallOf(PickleFunction("round_body"),
                py::make_tuple(RoundShapeName(body.shape), Numbers(body.start), Numbers(body.end),
                               body.start_radius, body.end_radius, body.radius_sigma, body.rms_px));
}

RoundBody ToBody(const std::string& shape, const std::array<double, 3>& start,
                 const std::array<double, 3>& end, double start_radius, double end_radius,
                 double radius_sigma, double rms_px) {
  const auto known = RoundShapeNamed(shape);
  if (!known) throw InputError("unknown shape of a body");
  const RoundBody body = {*known,     ToVector3(start), ToVector3(end), start_radius,
                          end_radius, radius_sigma,     rms_px};
  const std::string broken = Validate(body);
  if (!broken.empty()) throw InputError(broken);
  return body;
}

// Without its scene: as it is saved and read.
py::tuple PickledDrawing(const Owner& drawing) {
  const std::string text =
      RunFree(py::none(), [drawing](RunMonitor*) { return DrawingAsJson(*drawing); });
  return CallOf(PickleFunction("drawing"), py::make_tuple(py::bytes(text)));
}

Owner ToDrawing(const py::bytes& text) {
  return RunFree(py::none(),
                 [text = std::string(text)](RunMonitor*) { return DrawingFromJson(text); });
}

// Of a drawing that has nothing else.
py::tuple PickledAlignment(const Alignment& alignment) {
  auto drawing = std::make_shared<SceneDrawing>();
  drawing->metadata.options_json = "{}";
  drawing->metadata.alignment = alignment;
  return AttributeOf(py::cast(drawing), "alignment");
}

// A getter of a vector of one kind of shape; nothing for the others.
template <typename Shape>
auto VectorOf(Eigen::Vector3d Shape::*field) {
  return [field](const Primitive& primitive) -> std::optional<Array> {
    const Shape* shape = primitive.As<Shape>();
    if (!shape) return std::nullopt;
    return CopyOf(shape->*field);
  };
}

auto NumberOf(double CircularArc::*field) {
  return [field](const Primitive& primitive) -> std::optional<double> {
    const CircularArc* arc = primitive.As<CircularArc>();
    if (!arc) return std::nullopt;
    return arc->*field;
  };
}

Owner SelectedLinks(const Owner& drawing, const std::string& kinds, bool tentative,
                    bool rods_as_outlines, const std::string& detail) {
  LinkSelection selection;
  selection.kinds = KindsFromNames(kinds);
  selection.tentative = tentative;
  selection.rods_as_outlines = rods_as_outlines;
  selection.Set(DetailFromName(detail));
  auto selected = std::make_shared<SceneDrawing>(*drawing);
  selected->graph = Selected(std::move(selected->graph), selection);
  return selected;
}

template <typename Item>
void BindItems(py::module_* module, const char* name, const char* attribute, const char* text,
               size_t (*size)(const SceneDrawing&)) {
  py::class_<Items<Item>>(*module, name, text)
      .def("__reduce__",
           [attribute](const Items<Item>& items) {
             return AttributeOf(py::cast(items.drawing), attribute);
           })
      .def("__getitem__",
           [size](const Items<Item>& items, py::ssize_t i) {
             return Item{items.drawing, IndexOf(i, size(*items.drawing))};
           })
      .def("__getitem__",
           [size](const Items<Item>& items, const py::slice& slice) {
             return SliceOf(slice, size(*items.drawing), [&](size_t i) {
               return Item{items.drawing, i};
             });
           })
      .def("__len__", [size](const Items<Item>& items) { return size(*items.drawing); })
      .def("__iter__", IterateSequence);
}

void BindRoundBody(py::module_* module) {
  py::class_<RoundBody>(*module, "RoundBody",
                        "A smooth body of which a link is an outline. Lengths are in the model's "
                        "unit.")
      .def_property_readonly(
          "shape", [](const RoundBody& body) { return std::string(RoundShapeName(body.shape)); },
          "'cylinder', 'cone' or 'sphere'.")
      .def_property_readonly(
          "start", [](const RoundBody& body) { return CopyOf(body.start); },
          "3 point of the axis where outlines begin; of a sphere the center.")
      .def_property_readonly(
          "end", [](const RoundBody& body) { return CopyOf(body.end); },
          "3 point of the axis where they end; of a sphere the center.")
      .def_readonly("start_radius", &RoundBody::start_radius, "Radius at start.")
      .def_readonly("end_radius", &RoundBody::end_radius, "Radius at end.")
      .def_readonly("radius_sigma", &RoundBody::radius_sigma,
                    "Standard deviation of the mean radius.")
      .def_readonly("rms_px", &RoundBody::rms_px,
                    "Distance of the edges in the images from its outlines, root mean square, px.")
      .def("__reduce__", PickledBody)
      .def("__repr__", [](const RoundBody& body) {
        return "<limn.RoundBody " + std::string(RoundShapeName(body.shape)) + ">";
      });
}

void BindPrimitive(py::module_* module) {
  py::class_<Primitive>(*module, "Primitive",
                        "The simplest curve that explains a link. What a kind of curve does not "
                        "have is None. Points are in the model's coordinates, lengths in its "
                        "unit.")
      .def_property_readonly(
          "type", [](const Primitive& p) { return std::string(ShapeName(p.Get().shape)); },
          "'line', 'arc', 'circle' or 'spline'.")
      .def_property_readonly(
          "rms_px", [](const Primitive& p) { return p.Get().rms_px; },
          "Distance of the link's points from the curve in the images, root mean square, px.")
      .def_property_readonly(
          "max_px", [](const Primitive& p) { return p.Get().max_px; },
          "The largest of these distances, px.")
      .def_property_readonly("start", VectorOf(&LineSegment::start), "Line: 3 first point.")
      .def_property_readonly("end", VectorOf(&LineSegment::end), "Line: 3 last point.")
      .def_property_readonly("center", VectorOf(&CircularArc::center), "Arc, circle: 3 center.")
      .def_property_readonly("x_axis", VectorOf(&CircularArc::x_axis),
                             "Arc, circle: 3 unit vector to the first point.")
      .def_property_readonly("y_axis", VectorOf(&CircularArc::y_axis),
                             "Arc, circle: 3 unit vector that it turns towards.")
      .def_property_readonly("radius", NumberOf(&CircularArc::radius), "Arc, circle: radius.")
      .def_property_readonly("sweep", NumberOf(&CircularArc::sweep_rad),
                             "Arc, circle: the angle it covers, rad.")
      .def_property_readonly(
          "knots",
          [](const Primitive& p) -> std::optional<Array> {
            const CubicBSpline* spline = p.As<CubicBSpline>();
            if (!spline) return std::nullopt;
            return NumbersOver(spline->knots, p.link.drawing);
          },
          "Spline, of degree 3: K + 4 knots.")
      .def_property_readonly(
          "control_points",
          [](const Primitive& p) -> std::optional<Array> {
            const CubicBSpline* spline = p.As<CubicBSpline>();
            if (!spline) return std::nullopt;
            return PointsOver(spline->control_points, p.link.drawing);
          },
          "Spline: K x 3 control points.")
      .def("__reduce__",
           [](const Primitive& p) { return AttributeOf(py::cast(p.link), "primitive"); })
      .def("__repr__", [](const Primitive& p) {
        return "<limn.Primitive " + std::string(ShapeName(p.Get().shape)) + ">";
      });
}

void BindLink(py::module_* module) {
  py::class_<Link>(*module, "Link",
                   "A curve of the drawing from node to node: N points. Arrays are read-only, not "
                   "copied, and keep the drawing.")
      .def_property_readonly(
          "id", [](const Link& link) { return link.id; }, "Index in the drawing's links.")
      .def_property_readonly(
          "points",
          [](const Link& link) { return PointsOver(link.Get().points_in_world, link.drawing); },
          "N x 3 points in the model's coordinates; the first and the last are nodes.")
      .def_property_readonly(
          "sigma", [](const Link& link) { return NumbersOver(link.Get().sigma, link.drawing); },
          "N standard deviations across the curve, in the model's unit; infinity if unknown.")
      .def_property_readonly(
          "length", [](const Link& link) { return Length(link.Get().points_in_world); },
          "Length, in the model's unit.")
      .def_property_readonly(
          "node0", [](const Link& link) { return link.Get().node0; },
          "Index of the node at the first point.")
      .def_property_readonly(
          "node1", [](const Link& link) { return link.Get().node1; },
          "Index of the node at the last point.")
      .def_property_readonly(
          "closed", [](const Link& link) { return link.Get().closed; },
          "Whether the curve returns to its first point.")
      .def_property_readonly(
          "confidence", [](const Link& link) { return link.Get().confidence; },
          "Probability that its curve exists, 0 to 1; -1 if unknown.")
      .def_property_readonly(
          "kind", [](const Link& link) { return std::string(LinkKindName(link.Get().kind)); },
          "'edge' (crease or border), 'paint', 'shadow', 'contour' (outline of a smooth body), "
          "'rod' (center line of a wire or bar), 'texture' (one of many short curves) or "
          "'unknown'.")
      .def_property_readonly(
          "kind_confidence", [](const Link& link) { return link.Get().kind_confidence; },
          "How sure the kind is, 0 to 1; 0 if unknown.")
      .def_property_readonly(
          "rod_radius", [](const Link& link) { return link.Get().rod_radius; },
          "Half the thickness of a rod, in the model's unit; 0 for other kinds.")
      .def_property_readonly(
          "body", [](const Link& link) { return link.Get().body; },
          "Of a contour, the round body whose outline it is, if one fits: a RoundBody; else None.")
      .def_property_readonly(
          "depth_sigma", [](const Link& link) { return link.Get().depth_sigma; },
          "Standard deviation in the direction that its images measure least, in the model's unit; "
          "-1 if unknown.")
      .def_property_readonly(
          "tentative", [](const Link& link) { return link.Get().tentative; },
          "Whether there is little evidence for it; exports leave it out by default.")
      .def_property_readonly(
          "doubt", [](const Link& link) { return std::string(LinkDoubtName(link.Get().doubt)); },
          "Why it is tentative: 'few views', 'chance', 'seen through', 'explained by others', "
          "'outline of a rod', 'depth not measured', 'still in the images' or 'short and "
          "unlikely'; empty if unknown or not tentative.")
      .def_property_readonly(
          "residual_px", [](const Link& link) { return link.Get().residual_px; },
          "Median distance from the edges of the images, px.")
      .def_property_readonly(
          "tri_angle_deg", [](const Link& link) { return link.Get().tri_angle_deg; },
          "Angle by which its views measure its depth, 0 to 90 degrees; -1 if unknown.")
      .def_property_readonly(
          "curve_px", [](const Link& link) { return link.Get().curve_px; },
          "Length of the curve that it is a part of, px of the images as used; 0 if unknown.")
      .def_property_readonly(
          "primitive", PrimitiveOf,
          "The simplest curve that explains it; None in a drawing without primitives.")
      .def_property_readonly(
          "dense_class", DenseClassOf,
          "After limn.fuse(), by where the dense surface goes on: 'surface' (on both sides: paint "
          "or a fold), 'boundary' (on one: a rim), 'free' (none there) or 'unknown'; else None.")
      .def_property_readonly("supporting_views", SupportingViews,
                             "Names of the images with edges along it.")
      .def_property_readonly(
          "tracks", TracksOf,
          "The link in its supporting images: name of the image to M x 2 "
          "polyline (x, y), px of the image as stored, as in tracks.txt but with "
          "the center of the top-left pixel at (0, 0). Rows of not-a-number "
          "separate parts. Columns of a panorama run from -1/8 to 7/8 "
          "of its width. Raises limn.InputError for a drawing that was read without its scene.")
      .def("__len__", [](const Link& link) { return link.Get().points_in_world.size(); })
      .def("__reduce__", [](const Link& link) { return ItemOf(link, "links"); })
      .def("__repr__", [](const Link& link) {
        return "<limn.Link " + std::to_string(link.id) + ": " + std::to_string(link.Get().size()) +
               " points>";
      });
}

void BindAlignment(py::module_* module) {
  py::class_<Alignment>(*module, "Alignment",
                        "The similarity from the model to a world with z up: X_world = scale "
                        "rotation X_model + translation.")
      .def_property_readonly(
          "scale", [](const Alignment& a) { return a.world_from_model.scale; },
          "Units of the world per unit of the model.")
      .def_property_readonly(
          "rotation", [](const Alignment& a) { return CopyOf(a.world_from_model.rotation); },
          "3 x 3 rotation.")
      .def_property_readonly(
          "translation", [](const Alignment& a) { return CopyOf(a.world_from_model.translation); },
          "3 translation, in the unit of the world.")
      .def_property_readonly(
          "scale_sigma", [](const Alignment& a) { return a.scale_sigma; },
          "Standard deviation of the scale, relative; 0 if unknown.")
      .def_property_readonly("unit", &Alignment::Unit, "'m', or 'none' if the scale is unknown.")
      .def_property_readonly(
          "up_from", [](const Alignment& a) { return SourceName(a.up); },
          "The source of z: 'gravity', 'positions', 'lines' or 'cameras'.")
      .def_property_readonly(
          "axes_from", [](const Alignment& a) { return SourceName(a.axes); },
          "The source of x and y: 'lines', 'positions', 'model' or 'plan'.")
      .def_property_readonly(
          "scale_from", [](const Alignment& a) { return SourceName(a.scale); },
          "The source of the scale: 'none', 'lengths' or 'positions'.")
      .def("__reduce__", PickledAlignment)
      .def("__repr__", [](const Alignment& a) {
        return std::string("<limn.Alignment, up from ") + SourceName(a.up) + ", scale from " +
               SourceName(a.scale) + ">";
      });
}

void BindNode(py::module_* module) {
  py::class_<Node>(*module, "Node", "Where links end or meet.")
      .def_property_readonly(
          "id", [](const Node& node) { return node.id; }, "Index in the drawing's nodes.")
      .def_property_readonly(
          "position", [](const Node& node) { return CopyOf(node.Get().position_in_world); },
          "3 position in the model's coordinates.")
      .def_property_readonly(
          "covariance", [](const Node& node) { return CopyOf(node.Get().covariance); },
          "3 x 3 covariance of the position, in the square of the model's unit; zero if unknown.")
      .def_property_readonly(
          "kind", [](const Node& node) { return std::string(NodeKindName(node.Get().kind)); },
          "'end', 'junction' (3 or more links) or 'loop_anchor'.")
      .def_property_readonly(
          "degree", [](const Node& node) { return node.Get().Degree(); }, "Number of link ends.")
      .def_property_readonly(
          "link_ends",
          [](const Node& node) {
            std::vector<std::pair<LinkId, int>> ends;
            for (const LinkEnd& end : node.Get().incident) ends.emplace_back(end.link, end.end);
            return ends;
          },
          "Pairs of a link's index and 0 for its first or 1 for its last point.")
      .def("__reduce__", [](const Node& node) { return ItemOf(node, "nodes"); })
      .def("__repr__", [](const Node& node) {
        return "<limn.Node " + std::to_string(node.id) + ": " + NodeKindName(node.Get().kind) + ">";
      });
}

void BindFace(py::module_* module) {
  py::class_<Face>(*module, "Face",
                   "A surface that links bound, as a mesh. Arrays are read-only, not copied, and "
                   "keep the drawing.")
      .def_property_readonly(
          "id", [](const Face& face) { return face.id; }, "Index in the drawing's faces.")
      .def_property_readonly(
          "surface",
          [](const Face& face) { return std::string(FaceSurfaceName(face.Get().surface)); },
          "'plane', 'ruled' (straight lines between two rails) or 'patch'.")
      .def_property_readonly(
          "vertices",
          [](const Face& face) { return PointsOver(face.Get().vertices, face.drawing); },
          "V x 3 points in the model's coordinates.")
      .def_property_readonly(
          "triangles",
          [](const Face& face) {
            const auto& triangles = face.Get().triangles;
            return ColumnsOver<int>(triangles, triangles.empty() ? nullptr : triangles[0].data(), 3,
                                    face.drawing);
          },
          "T x 3 indices of vertices, counterclockwise seen from the visible side.")
      .def_property_readonly("normal", NormalOf,
                             "Plane: 3 unit vector towards the visible side; else None.")
      .def_property_readonly("offset", OffsetOf,
                             "Plane: normal . x of its points, in the model's unit; else None.")
      .def_property_readonly(
          "area", [](const Face& face) { return AreaOf(face.Get()); },
          "Area, in the square of the model's unit.")
      .def_property_readonly(
          "loops", LoopsOf,
          "The border, then holes: lists of (link, from, to), an index of a point plus a fraction; "
          "link is None where no curve was found.")
      .def_property_readonly(
          "confidence", [](const Face& face) { return face.Get().confidence; },
          "How sure it is, 0 to 1.")
      .def_property_readonly(
          "views", [](const Face& face) { return NamesOf(face.Get().views, *face.drawing); },
          "Names of the images that see it.")
      .def("__reduce__", [](const Face& face) { return ItemOf(face, "faces"); })
      .def("__repr__", [](const Face& face) {
        return "<limn.Face " + std::to_string(face.id) + ": " +
               FaceSurfaceName(face.Get().surface) + ">";
      });
}

// A function of limn._interop.
py::object Interop(const char* name) { return py::module_::import("limn._interop").attr(name); }

}  // namespace

void BindDrawing(py::module_* module) {
  BindRoundBody(module);
  BindPrimitive(module);
  BindLink(module);
  BindNode(module);
  BindFace(module);
  BindAlignment(module);
  BindItems<Link>(module, "Links", "links", "The links of a drawing, a sequence.",
                  [](const SceneDrawing& drawing) { return drawing.graph.links.size(); });
  BindItems<Node>(module, "Nodes", "nodes", "The nodes of a drawing, a sequence.",
                  [](const SceneDrawing& drawing) { return drawing.graph.nodes.size(); });
  BindItems<Face>(module, "Faces", "faces", "The faces of a drawing, a sequence.",
                  [](const SceneDrawing& drawing) { return drawing.graph.faces.size(); });
  module->def("make_round_body", ToBody, py::arg("shape"), py::arg("start"), py::arg("end"),
              py::arg("start_radius"), py::arg("end_radius"), py::arg("radius_sigma"),
              py::arg("rms_px"));
  py::class_<SceneDrawing, Owner>(*module, "Drawing",
                                  "A 3D drawing: curves in space (links) that meet at nodes.")
      .def_property_readonly(
          "links", [](Owner drawing) { return Items<Link>{std::move(drawing)}; }, "The curves.")
      .def_property_readonly(
          "nodes", [](Owner drawing) { return Items<Node>{std::move(drawing)}; },
          "Where they end or meet.")
      .def_property_readonly(
          "faces", [](Owner drawing) { return Items<Face>{std::move(drawing)}; },
          "The surfaces between them, from limn.find_faces() or drawing_surfacer.")
      .def_property_readonly(
          "views", [](const SceneDrawing& drawing) { return drawing.metadata.view_names; },
          "Names of the images.")
      .def_property_readonly(
          "cameras",
          [](const SceneDrawing& drawing) {
            if (!drawing.scene) return std::vector<SceneCamera>();
            return CamerasOf(Moved(drawing.views, drawing.scene->scene.origin()));
          },
          "The cameras that it fits, per image; empty for a drawing that was read without them.")
      .def_property_readonly(
          "scene",
          [](const SceneDrawing& drawing) -> std::optional<std::shared_ptr<OpenScene>> {
            if (!drawing.scene) return std::nullopt;
            return std::const_pointer_cast<OpenScene>(drawing.scene);
          },
          "What it was drawn from; None for a drawing that was read without it.")
      .def_property_readonly(
          "alignment", [](const SceneDrawing& drawing) { return drawing.metadata.alignment; },
          "How it lies in the world, from limn.align() or drawing_aligner; None if unknown.")
      .def_property_readonly(
          "options",
          [](const SceneDrawing& drawing) -> py::dict {
            return py::module_::import("json").attr("loads")(drawing.metadata.options_json);
          },
          "The options it was made with, as in drawing.json: those of a group in a dictionary.")
      .def_property_readonly(
          "warnings", [](const SceneDrawing& drawing) { return WarningsOf(drawing.made.log); },
          "Warnings: what to check before trusting it, as lines of text.")
      .def_property_readonly(
          "stages", [](const SceneDrawing& drawing) { return StagesOf(drawing.made.log); },
          "The stages that made it, in order: a dictionary each with the name (stage), seconds of "
          "wall time, and counts by name (in, kept, dropped).")
      .def("selected", SelectedLinks, py::arg("kinds") = "default", py::arg("tentative") = false,
           py::arg("rods_as_outlines") = false, py::arg("detail") = "normal",
           "The drawing with some of its links only; their ids are counted anew.\n\n"
           "- `kinds`: names of kinds, separated by commas; 'all'; or 'default', all but outlines "
           "of smooth bodies and texture. Others raise limn.OptionError.\n"
           "- `tentative`: with links of little evidence.\n"
           "- `rods_as_outlines`: rods as their outlines instead of their center lines.\n"
           "- `detail`: 'coarse', curves of 80 px and more without texture; 'normal', what `kinds` "
           "says; 'all', texture, too.")
      .def(
          "save",
          [](const Owner& drawing, const std::filesystem::path& path) {
            RunWithoutLock(py::none(),
                           [drawing, path](RunMonitor*) { SaveDrawing(*drawing, path.string()); });
          },
          py::arg("path"),
          "Writes the drawing in the format of the extension (.json, .ply, .obj, .dxf, .step, "
          ".glb, .graphml, .svg): as .json all of it, without loss; in other formats without "
          "tentative links and outlines of smooth bodies. limn.export() has options. Raises "
          "limn.IoError for other extensions, and if the file cannot be written.")
      .def(
          "to_networkx", [](const py::object& self) { return Interop("to_networkx")(self); },
          "A networkx.MultiGraph: nodes with position and kind, edges with link, points, length, "
          "kind and tentative. Raises ImportError without networkx.")
      .def(
          "to_open3d", [](const py::object& self) { return Interop("to_open3d")(self); },
          "An open3d.geometry.LineSet with a color per link. Raises ImportError without open3d.")
      .def("__reduce__", PickledDrawing)
      .def("__repr__", [](const SceneDrawing& drawing) {
        return "<limn.Drawing of " + std::to_string(drawing.graph.links.size()) + " links and " +
               std::to_string(drawing.graph.nodes.size()) + " nodes>";
      });
  module->def("make_drawing", ToDrawing, py::arg("json_text"));
}

}  // namespace limn::colmap_ext
