#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/console.h"
#include "colmap_ext/run/project.h"
#include "colmap_ext/run/run_options.h"

namespace limn::colmap_ext {

int RunCurveLinker(int argc, const char* const* argv) {
  RunOptions options;
  if (!ParseRunOptions("curve_linker", "find the curve fragments of all images, into the cache",
                       {.linking = true}, argc, argv, &options)) {
    return 0;
  }
  Console console(options.num_threads);
  const Project project(options, &console);
  ExtractProjectCurves(project, options, &console);
  return 0;
}

}  // namespace limn::colmap_ext
