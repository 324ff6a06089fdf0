#include "colmap_ext/verbs/drawing_verb.h"

namespace limn::colmap_ext {

std::string DrawingVerb::Provenance(const RunOptions& options, const std::string& before) const {
  return ProvenanceAfter(before, ProvenanceRow(), options);
}

void DrawingVerb::Conclude(const Job& job, const DrawingInScene&, const DrawingInScene&) {
  job.console->RepeatWarnings();
}

void DrawingVerb::AddFileOptions(OptionParser* parser) {
  AddDrawingPath("drawing.json to start from, instead of the one in the output folder", parser);
  results_.AddOptions(parser);
}

void DrawingVerb::AddDrawingPath(const char* help, OptionParser* parser) {
  parser->AddOption("drawing_path", &drawing_path_, BasicOption(help));
}

void DrawingVerb::CheckFiles(const Project& project, const RunOptions& options) const {
  CheckDrawingFiles(project, options);
}

void DrawingVerb::CheckReplaces(const Project& project, const RunOptions& options,
                                const std::string& provenance) const {
  if (!drawing_path_.empty()) CheckReplaceable(project, options, "drawing.json", provenance);
}

void DrawingVerb::Write(const Job& job, const Project& project, const DrawingInScene& made) {
  WriteDrawingResults(project, made, results_, job.console);
}

std::vector<std::string> DrawingVerb::StartsFrom(const RunOptions&) const {
  return DrawingsToStartFrom(Start(), drawing_path_);
}

void DrawingVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckFiles(project, options);
  const bool is_named = !drawing_path_.empty();
  const std::string path =
      is_named ? drawing_path_
               : FindDrawing(project.layout().output.drawing_dir, Start(), "drawing_path");
  if (!is_named && Start() == DrawingChoice::kNewest) console->Say("drawing: " + path);
  const DrawingInScene given = ReadDrawingInScene(project, path);
  const std::string provenance = Provenance(options, given.metadata.options_json);
  CheckReplaces(project, options, provenance);
  const Job job = JobOf(project, options, console);
  DrawingInScene made = Apply(job, given);
  made.metadata.options_json = provenance;
  Write(job, project, made);
  Conclude(job, given, made);
}

std::shared_ptr<const std::vector<ImageCurves>> CurvesOf(const Job& job,
                                                         const DrawingInScene& drawing) {
  if (drawing.curves) return drawing.curves;
  return SharedImageCurves(job);
}

}  // namespace limn::colmap_ext
