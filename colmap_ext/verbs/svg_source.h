// SPDX-License-Identifier: BSD-3-Clause
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

// The values of SvgSource::view that make a sheet.
constexpr const char* kSheetViews = "front, back, left, right, top, bottom, axonometric, face:<id>";

// How an SVG picture or a DXF plan views a drawing, and what hides parts of it.
struct SvgSource {
  enum class Hidden {
    kAuto,  // removed, if anything is known to hide them
    kRemoved,
    kDashed,
  };

  // front, back, left, right, top, bottom, axonometric or face:<id>: a sheet to scale; else the
  // name of an image. Empty: axonometric, or top with a section.
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

// A picture of a graph, and the visible part of the graph in its coordinates.
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
  // File units per world unit.
  double scale = 1;
  // Of the file.
  LengthUnit unit = LengthUnit::kNone;
  // SheetOptions::front.
  Eigen::Vector3d front = Eigen::Vector3d::UnitY();
};

// Reports what hides parts of the drawing, and what the section contains. Throws IoError;
// OptionError if the face does not exist or is not flat, or if hidden parts are asked for and
// nothing is known to hide them; and InputError if the sheet would be empty.
SvgScene SceneOnSheet(const SvgSource& source, const SheetInput& input, Console* console);

// The same in an image: graph and faces are in the model's coordinates, as are the workspace's
// dense results. Also throws OptionError for an image that the model does not have.
SvgScene SceneInImage(const SvgSource& source, const LayoutOptions& workspace,
                      const DrawingGraph& graph, const std::vector<DrawingFace>& faces,
                      Console* console);

}  // namespace limn::colmap_ext
