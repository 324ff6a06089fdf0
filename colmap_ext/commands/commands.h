#pragma once

namespace limn::colmap_ext {

// One function per command: declare options, parse, read, call, write. `argv` begins with the name
// of the command. Returns the exit code. Exceptions are turned into one line and exit code 1 by
// main.cc.
int RunAutomaticDrawer(int argc, const char* const* argv);
int RunCurveDrawer(int argc, const char* const* argv);
int RunCurveLinker(int argc, const char* const* argv);
int RunCurveSketcher(int argc, const char* const* argv);
int RunDrawingAligner(int argc, const char* const* argv);
int RunDrawingEvaluator(int argc, const char* const* argv);
int RunDrawingExporter(int argc, const char* const* argv);
int RunDrawingRefiner(int argc, const char* const* argv);
int RunDrawingFuser(int argc, const char* const* argv);
int RunDrawingViewer(int argc, const char* const* argv);
int RunEdgeExtractor(int argc, const char* const* argv);
int RunModelImporter(int argc, const char* const* argv);
int RunTruthExtractor(int argc, const char* const* argv);

}  // namespace limn::colmap_ext
