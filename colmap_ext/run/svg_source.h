#pragma once

#include <string>

#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/workspace/layout.h"
#include "limn/formats/write_drawing.h"

namespace limn::colmap_ext {

// What a drawing is seen from in an SVG picture, and what hides it.
struct SvgSource {
  // top, front, side or axonometric: a sheet to scale; else the name of an image.
  std::string view = "axonometric";
  // Of the image, and of its dense results.
  LayoutOptions layout;
  // What hides parts: for images as in drawing_fuser, for sheets a mesh or cloud named here.
  DenseOptionsPaths dense;
  bool show_hidden = false;
  bool photo = false;
  SheetOptions sheet;
  SvgOptions style;

  void AddOptions(OptionParser* parser);
  bool IsSheet() const;
  // Throws OptionError.
  void Check() const;
};

// A picture of `graph`, and the graph as it shows it: on sheets the given one (z up; what hides it
// is turned by `model_to_sheet` and `scale`, as the graph was), in images that of the model's
// coordinates. Throws IoError, and OptionError for an image that the model does not have.
struct SvgScene {
  SvgPicture picture;
  DrawingGraph graph;
};
SvgScene SceneOnSheet(const SvgSource& source, const DrawingGraph& graph,
                      const Eigen::Matrix3d& z_up_from_model, double scale);
SvgScene SceneInImage(const SvgSource& source, const DrawingGraph& graph,
                      const std::string& output_path);

}  // namespace limn::colmap_ext
