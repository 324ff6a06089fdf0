#pragma once

#include <set>
#include <string>

#include "colmap_ext/commands/commands.h"

namespace limn::colmap_ext {

struct Command {
  const char* name;
  int (*run)(int argc, const char* const* argv, const ConsoleMaker& make_console);
};

constexpr Command kCommands[] = {
    {"automatic_drawer", RunAutomaticDrawer}, {"curve_drawer", RunCurveDrawer},
    {"curve_linker", RunCurveLinker},         {"curve_sketcher", RunCurveSketcher},
    {"drawing_aligner", RunDrawingAligner},   {"drawing_evaluator", RunDrawingEvaluator},
    {"drawing_exporter", RunDrawingExporter}, {"drawing_fuser", RunDrawingFuser},
    {"drawing_refiner", RunDrawingRefiner},   {"drawing_viewer", RunDrawingViewer},
    {"edge_extractor", RunEdgeExtractor},     {"model_importer", RunModelImporter},
    {"truth_extractor", RunTruthExtractor},
};

// What the command prints with -h or --help_all.
std::string HelpOf(const Command& command, const char* flag);

// The names of the options that a help text lists.
std::set<std::string> OptionsIn(const std::string& help);

}  // namespace limn::colmap_ext
