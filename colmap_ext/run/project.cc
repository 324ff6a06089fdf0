#include "colmap_ext/run/project.h"

namespace limn::colmap_ext {

WorkspaceLayout ChooseLayout(const RunOptions& options, Console* console) {
  WorkspaceLayout layout = ResolveLayout(options.layout);
  console->Say(layout.description);
  return layout;
}

Project::Project(const RunOptions& options, Console* console)
    : Project(ChooseLayout(options, console), options, console) {}

Project::Project(const WorkspaceLayout& layout, const RunOptions& options, Console* console)
    : OutputFolder(layout.output, options, console), Scene(layout, options, console) {}

CurvesResult ExtractProjectCurves(const Project& project, const RunOptions& options,
                                  Console* console, const FragmentsObserver& on_fragments) {
  CurvesResult result = ExtractCurves(
      {project.views(), project.images(), project.cache(), std::nullopt, on_fragments},
      options.pipeline.edges, options.pipeline.linking, console->context());
  console->Report(result.summary);
  return result;
}

}  // namespace limn::colmap_ext
