#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/edge_results.h"

namespace limn::colmap_ext {

int RunEdgeExtractor(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  EdgeFormat format = EdgeFormat::kNone;
  const auto add_format = [&](OptionParser* parser) {
    parser->AddOption(
        "format", &format,
        {{"none", EdgeFormat::kNone}, {"edg", EdgeFormat::kEdg}, {"cem", EdgeFormat::kCem}},
        BasicOption("also write edgels (.edg), or link them and write fragments"));
  };
  if (!ParseRunOptions("edge_extractor", "find the edgels of all images, into the cache",
                       {.linking = true, .overwrites = true}, argc, argv, &options, add_format)) {
    return 0;
  }
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const Project project(options, console.get());
  CheckEdgeResults(project, format, options.overwrite);
  const EdgeMapsResult result =
      ExtractEdgeMaps({project.views(), project.images(), project.cache()}, options.pipeline.edges,
                      console->context());
  console->Report(result.summary);
  if (format == EdgeFormat::kEdg) {
    ParallelFor(console->context(), "files of edges", project.views().size(), [&](size_t v) {
      WriteEdgResult(project, static_cast<ViewId>(v), result.edge_maps[v]);
    });
  }
  if (format == EdgeFormat::kCem) {
    ExtractProjectCurves(project, options, console.get(), CemWriter(project));
  }
  SayEdgeResults(project, format, console.get());
  return 0;
}

}  // namespace limn::colmap_ext
