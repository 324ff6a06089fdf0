#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/console.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/run_options.h"

namespace limn::colmap_ext {

int RunEdgeExtractor(int argc, const char* const* argv) {
  RunOptions options;
  if (!ParseRunOptions("edge_extractor", "find the edgels of all images, into the cache", {}, argc,
                       argv, &options)) {
    return 0;
  }
  Console console(options.num_threads);
  const Project project(options, &console);
  const EdgeMapsResult result =
      ExtractEdgeMaps({project.views(), project.images(), project.cache()}, options.pipeline.edges,
                      console.context());
  console.Report(result.summary);
  return 0;
}

}  // namespace limn::colmap_ext
