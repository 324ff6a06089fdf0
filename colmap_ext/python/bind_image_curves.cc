// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "colmap_ext/python/arrays.h"
#include "colmap_ext/python/bindings.h"

namespace limn::colmap_ext {

namespace py = pybind11;

namespace {

// The edgels of an image.
struct ImageEdges {
  std::shared_ptr<const void> owner;
  const EdgeMap* map;
};

// The curves of an image.
struct ImageFragments {
  std::shared_ptr<const SceneCurves> owner;
  const ImageCurves* curves;
};

struct SketchCurve {
  std::shared_ptr<const SceneSketch> sketch;
  size_t index = 0;

  const Curve3D& Get() const { return sketch->in_model->curves[index]; }
};

// A column of all edgels; `field` is a member of Edgel that begins with numbers of this type.
template <typename Number, typename Field>
py::array_t<Number> Column(const ImageEdges& edges, Field Edgel::*field, size_t cols) {
  const std::vector<Edgel>& all = edges.map->edgels;
  const Number* first = nullptr;
  if (!all.empty()) first = reinterpret_cast<const Number*>(&(all.front().*field));
  return ColumnsOver<Number>(all, first, cols, edges.owner);
}

py::list FragmentsOf(const ImageFragments& image) {
  py::list fragments;
  for (const CurveFragment& fragment : image.curves->fragments) {
    fragments.append(NumbersOver(fragment.edgel_ids, image.owner));
  }
  return fragments;
}

std::vector<bool> ClosedOf(const ImageFragments& image) {
  std::vector<bool> closed;
  for (const CurveFragment& fragment : image.curves->fragments) closed.push_back(fragment.closed);
  return closed;
}

// What Python expects of a mapping from the names of the scene's images.
template <typename Results, typename Class, typename Get>
void AddMapping(Class* bound, const Get& get) {
  bound
      ->def("__getitem__",
            [get](std::shared_ptr<const Results> results, const std::string& name) {
              const auto& views = results->scene->scene.views();
              return get(results, static_cast<size_t>(ViewNamed(views, name)));
            })
      .def(
          "keys",
          [](const Results& results) {
            std::vector<std::string> names;
            for (const View& view : results.scene->scene.views()) names.push_back(view.name);
            return names;
          },
          "Names of the images.")
      .def("__iter__", [](const py::object& self) { return py::iter(self.attr("keys")()); })
      .def("__len__", [](const Results& results) { return results.scene->scene.views().size(); })
      .def_property_readonly(
          "scene",
          [](const Results& results) { return std::const_pointer_cast<OpenScene>(results.scene); },
          "The scene they were found in.")
      .def_property_readonly(
          "stages", [](const Results& results) { return StagesOf(results.made.log); },
          "What was found, as in Drawing.stages.");
}

}  // namespace

void BindImageCurves(py::module_* module) {
  py::class_<ImageEdges>(*module, "ImageEdges",
                         "The edgels (oriented edge points) of an image: M rows. Arrays are "
                         "read-only and not copied.")
      .def_property_readonly(
          "positions", [](const ImageEdges& e) { return Column<float>(e, &Edgel::stored_px, 2); },
          "M x 2 positions (x, y), px of the image as used; the center of the top-left pixel is "
          "(0, 0).")
      .def_property_readonly(
          "directions",
          [](const ImageEdges& e) { return Column<double>(e, &Edgel::tangent_rad, 0); },
          "M directions along the edge, rad, from x to y; the brighter side is on the left on "
          "screen. Of curves (limn.link) in the virtual pinhole image of a camera with a lens.")
      .def_property_readonly(
          "strengths", [](const ImageEdges& e) { return Column<float>(e, &Edgel::strength, 0); },
          "M gradients, gray levels per px.")
      .def_property_readonly(
          "sigmas",
          [](const ImageEdges& e) { return Column<float>(e, &Edgel::position_sigma_px, 0); },
          "M standard deviations across the edge, px.")
      .def_property_readonly(
          "width", [](const ImageEdges& e) { return e.map->width; }, "Width of the image, px.")
      .def_property_readonly(
          "height", [](const ImageEdges& e) { return e.map->height; }, "Height of the image, px.")
      .def("__len__", [](const ImageEdges& e) { return e.map->edgels.size(); });

  py::class_<SceneEdges, std::shared_ptr<SceneEdges>> edges(
      *module, "Edges",
      "The edges of all images, by name of the image; other names raise KeyError. From "
      "limn.extract_edges().");
  AddMapping<SceneEdges>(&edges, [](std::shared_ptr<const SceneEdges> all, size_t view) {
    const EdgeMap* map = &all->edge_maps[view];
    return ImageEdges{std::move(all), map};
  });

  py::class_<ImageFragments>(*module, "ImageCurves",
                             "The curves of an image; its length is their number.")
      .def_property_readonly(
          "edges",
          [](const ImageFragments& image) {
            return ImageEdges{image.owner, &image.curves->edge_map};
          },
          "The edgels that the curves are chains of.")
      .def_property_readonly("fragments", FragmentsOf,
                             "A list of int32 arrays: the indices of the edgels of each curve, in "
                             "order.")
      .def_property_readonly("closed", ClosedOf,
                             "Per curve, whether it returns to its first edgel.")
      .def("__len__", [](const ImageFragments& image) { return image.curves->fragments.size(); });

  py::class_<SceneCurves, std::shared_ptr<SceneCurves>> curves(
      *module, "Curves",
      "The curves of all images, by name of the image; other names raise KeyError. From "
      "limn.link().");
  AddMapping<SceneCurves>(&curves, [](std::shared_ptr<const SceneCurves> all, size_t view) {
    const ImageCurves* of_view = &(*all->curves)[view];
    return ImageFragments{std::move(all), of_view};
  });

  py::class_<SketchCurve>(*module, "SketchCurve",
                          "An unconnected curve in space: N points. Arrays are read-only, not "
                          "copied, and keep the sketch.")
      .def_property_readonly(
          "points",
          [](const SketchCurve& c) { return PointsOver(c.Get().points_in_world, c.sketch); },
          "N x 3 points in the model's coordinates.")
      .def_property_readonly(
          "tangents",
          [](const SketchCurve& c) { return PointsOver(c.Get().tangents_in_world, c.sketch); },
          "N x 3 unit tangents.")
      .def_property_readonly(
          "sigma", [](const SketchCurve& c) { return NumbersOver(c.Get().depth_sigma, c.sketch); },
          "N standard deviations along the viewing rays, in the model's unit; infinity if unknown.")
      .def_property_readonly(
          "closed", [](const SketchCurve& c) { return c.Get().closed; },
          "Whether the curve returns to its first point.")
      .def_property_readonly(
          "view",
          [](const SketchCurve& c) {
            return c.sketch->curves->scene->scene.views()[c.Get().anchor.view].name;
          },
          "Name of the image that it was seen in.")
      .def("__len__", [](const SketchCurve& c) { return c.Get().size(); });

  py::class_<SceneSketch, std::shared_ptr<SceneSketch>>(
      *module, "Sketch",
      "The curve sketch: a sequence of unconnected curves in space. From limn.sketch().")
      .def("__getitem__",
           [](std::shared_ptr<SceneSketch> sketch, py::ssize_t i) {
             const size_t index = IndexOf(i, sketch->in_model->curves.size());
             return SketchCurve{std::move(sketch), index};
           })
      .def("__getitem__",
           [](const std::shared_ptr<SceneSketch>& sketch, const py::slice& slice) {
             return SliceOf(slice, sketch->in_model->curves.size(), [&](size_t i) {
               return SketchCurve{sketch, i};
             });
           })
      .def("__len__", [](const SceneSketch& sketch) { return sketch.in_model->curves.size(); })
      .def("__iter__", IterateSequence)
      .def_property_readonly(
          "scene",
          [](const SceneSketch& sketch) {
            return std::const_pointer_cast<OpenScene>(sketch.curves->scene);
          },
          "The scene it was found in.")
      .def_property_readonly(
          "stages", [](const SceneSketch& sketch) { return StagesOf(sketch.made.log); },
          "What was found, as in Drawing.stages.");
}

}  // namespace limn::colmap_ext
