#pragma once

#include <string>

#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/run/console.h"
#include "colmap_ext/workspace/layout.h"
#include "limn/formats/write_drawing.h"
#include "limn/geometry/similarity3.h"

namespace limn::colmap_ext {

// The view of a drawing in an SVG picture, and what hides it.
struct SvgSource {
  // top, front, side or axonometric: a sheet to scale; else the name of an image.
  std::string view = "axonometric";
  // What hides parts of the drawing: for images as in drawing_fuser, for sheets a mesh or cloud
  // given here.
  DenseOptionsPaths dense;
  bool show_hidden = false;
  bool photo = false;
  SheetOptions sheet;
  SvgOptions style;

  void AddOptions(OptionParser* parser);
  bool IsSheet() const;
  // Throws OptionError.
  void Check(const LayoutOptions& workspace) const;
};

// A picture of `graph`, and the graph in its coordinates: on sheets the given graph (z up; what
// hides it is in the coordinates of the model), in images the graph in the model's coordinates, as
// the workspace has it with its dense results. Throws IoError, and OptionError for an image that
// the model does not have.
struct SvgScene {
  SvgPicture picture;
  DrawingGraph graph;
};
SvgScene SceneOnSheet(const SvgSource& source, const DrawingGraph& graph,
                      const Similarity3d& graph_from_model);
SvgScene SceneInImage(const SvgSource& source, const LayoutOptions& workspace,
                      const DrawingGraph& graph, const std::string& output_path, Console* console);

}  // namespace limn::colmap_ext
