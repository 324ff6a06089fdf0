#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/edit.h"
#include "limn/pipeline/refit_edited.h"

namespace limn::colmap_ext {

int RunDrawingEditor(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  std::string drawing_path;
  std::string edits_path;
  const auto parser = ParseRunOptions(
      "drawing_editor", "apply edits made by hand to a stored drawing, and fit what they touch",
      {.linking = true, .refit = true, .overwrites = true}, argc, argv, &options,
      [&](OptionParser* more) {
        more->AddOption("edits", &edits_path, BasicOption("edits.json, as made in drawing.html"));
        AddDrawingPath(&drawing_path, more);
      });
  if (!parser) return 0;
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  CheckEditorOptions(options);
  const EditsFile file = ReadEdits(edits_path);
  const Project project(options, console.get());
  CheckDrawingFiles(project, options);
  const auto [given, provenance] = ReadStartingDrawing(
      project, options, drawing_path,
      [&](const RunOptions&, const std::string& before) { return EditProvenance(file, before); });
  EditedDrawing edited =
      ApplyEdits(given.graph, project.views(), Moved(file.edits, -project.origin()),
                 options.pipeline.drawing.topology);
  if (HasTouched(edited)) {
    const CurvesResult curves = ExtractProjectCurves(project, options, console.get());
    console->Report(RefitEdited({project.views(), curves.curves}, project.images().read,
                                options.pipeline, console->context(), &edited));
  }
  SayEdits(file.edits, edited, console.get());
  CheckGraph(edited.graph);
  WriteDrawingResults(project, project.views(), edited.graph, provenance, given.metadata.alignment,
                      console.get());
  console->RepeatWarnings();
  return 0;
}

}  // namespace limn::colmap_ext
