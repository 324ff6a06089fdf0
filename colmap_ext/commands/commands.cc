#include "colmap_ext/commands/commands.h"

#include <algorithm>
#include <iterator>

namespace limn::colmap_ext {
namespace {

constexpr Command kCommands[] = {
    {"automatic_drawer", RunAutomaticDrawer, "the main job: the 3D drawing of a COLMAP project"},
    {"edge_extractor", RunEdgeExtractor, "find the edgels of all images"},
    {"curve_linker", RunCurveLinker, "link them to curve fragments"},
    {"curve_sketcher", RunCurveSketcher, "reconstruct a sketch: unconnected 3D curves"},
    {"curve_drawer", RunCurveDrawer, "make the drawing from a stored sketch"},
    {"drawing_refiner", RunDrawingRefiner, "fit a stored drawing to all images"},
    {"drawing_regularizer", RunDrawingRegularizer,
     "make a stored drawing regular: right angles, planes"},
    {"drawing_surfacer", RunDrawingSurfacer, "find the faces between the curves of a drawing"},
    {"drawing_editor", RunDrawingEditor, "apply edits made by hand to a stored drawing"},
    {"drawing_aligner", RunDrawingAligner, "find up, axes and scale of a stored drawing"},
    {"drawing_fuser", RunDrawingFuser, "compare a drawing with dense results and combine the two"},
    {"drawing_exporter", RunDrawingExporter, "write a drawing for CAD, Blender or as a graph"},
    {"drawing_viewer", RunDrawingViewer, "make a page that shows a drawing in a browser"},
    {"model_importer", RunModelImporter, "make a COLMAP model from cameras in another format"},
    {"drawing_evaluator", RunDrawingEvaluator, "compare curves with ground truth"},
    {"truth_extractor", RunTruthExtractor, "ground truth from a surface or a dense cloud"},
};

}  // namespace

std::span<const Command> Commands() { return kCommands; }

const Command* FindCommand(std::string_view name) {
  const auto found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                  [&](const Command& command) { return name == command.name; });
  return found == std::end(kCommands) ? nullptr : found;
}

}  // namespace limn::colmap_ext
