#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/dense_files/products.h"
#include "colmap_ext/host/console.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/verbs/plan_options.h"
#include "colmap_ext/workspace/layout.h"
#include "limn/formats/write_drawing.h"
#include "limn/geometry/similarity3.h"
#include "limn/plans/section.h"

namespace limn::colmap_ext {

// The view of a drawing in an SVG picture or on a DXF plan, and what hides it.
struct SvgSource {
  enum class Hidden {
    kAuto,  // removed, if something is known that hides
    kRemoved,
    kDashed,
  };

  // top, front, side, axonometric or face:<id>: a sheet to scale; else the name of an image. Empty:
  // axonometric, or top with a section.
  std::string view;
  // What hides parts of the drawing: for images as in drawing_fuser, for sheets a mesh or cloud
  // given here. Without it, and if its type is "faces", the faces of the drawing.
  DenseOptionsPaths dense;
  Hidden hidden = Hidden::kAuto;
  bool show_hidden = false;
  bool photo = false;
  SheetOptions sheet;
  PlanOptions plan;
  SvgOptions style;

  void AddOptions(OptionParser* parser);
  bool IsSheet() const;
  // The number of the face in `view`.
  std::optional<int> Face() const;
  // Throws OptionError.
  void Check(const LayoutOptions& workspace) const;
};

// A picture of a graph, and the graph in its coordinates, as far as it is shown.
struct SvgScene {
  SvgPicture picture;
  DrawingGraph graph;
};

// What is on a sheet, in the coordinates of the exported file.
struct SheetInput {
  const DrawingGraph& graph;
  // All faces of the drawing, also those of links that are left out.
  const std::vector<DrawingFace>& faces;
  // From the model, in whose coordinates dense results are.
  Similarity3d file_from_model;
  // Unit vector, if known.
  std::optional<Eigen::Vector3d> up;
  // Units of the file in a unit of the world.
  double scale = 1;
};

// Says what hides, and what the section has. Throws IoError, OptionError for a face that there is
// not or that is not flat, and for hidden parts that nothing is known of, and InputError if there
// is nothing on the sheet.
SvgScene SceneOnSheet(const SvgSource& source, const SheetInput& input, Console* console);

// In an image: the graph and the faces in the model's coordinates, as the workspace has it with its
// dense results. Throws the same, and OptionError for an image that the model does not have.
SvgScene SceneInImage(const SvgSource& source, const LayoutOptions& workspace,
                      const DrawingGraph& graph, const std::vector<DrawingFace>& faces,
                      const std::string& output_path, Console* console);

}  // namespace limn::colmap_ext
