#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/edge_results.h"

namespace limn::colmap_ext {

int RunCurveLinker(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  EdgeFormat format = EdgeFormat::kNone;
  const auto add_format = [&](OptionParser* parser) {
    parser->AddOption("format", &format, {{"none", EdgeFormat::kNone}, {"cem", EdgeFormat::kCem}},
                      BasicOption("also write fragments as curves/fragments/<image name>.cem"));
  };
  if (!ParseRunOptions("curve_linker", "find the curve fragments of all images, into the cache",
                       {.linking = true, .overwrites = true}, argc, argv, &options, add_format)) {
    return 0;
  }
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckEdgeResults(project, format, options.overwrite);
  ExtractProjectCurves(project, options, console.get(),
                       format == EdgeFormat::kCem ? CemWriter(project) : FragmentsObserver());
  SayEdgeResults(project, format, console.get());
  return 0;
}

}  // namespace limn::colmap_ext
