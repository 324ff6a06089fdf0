#pragma once

#include <span>
#include <string_view>

#include "colmap_ext/host/console.h"

namespace limn::colmap_ext {

// One function per command: declare options, parse, read, call, write. `argv` begins with the name
// of the command; output goes to the console that it makes. Returns the exit code. Exceptions are
// turned into one line and exit code 1 by main.cc.
int RunAutomaticDrawer(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunCurveDrawer(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunCurveLinker(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunCurveSketcher(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingAligner(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingEditor(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingEvaluator(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingExporter(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingRefiner(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingRegularizer(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingSurfacer(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingFuser(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunDrawingViewer(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunEdgeExtractor(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunModelImporter(int argc, const char* const* argv, const ConsoleMaker& make_console);
int RunTruthExtractor(int argc, const char* const* argv, const ConsoleMaker& make_console);

struct Command {
  const char* name;
  int (*run)(int argc, const char* const* argv, const ConsoleMaker& make_console);
  const char* summary;
};

// In the order in which a project needs them, the main job first.
std::span<const Command> Commands();

// Null if no command has this name.
const Command* FindCommand(std::string_view name);

}  // namespace limn::colmap_ext
