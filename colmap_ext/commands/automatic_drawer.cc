#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/drawer_run.h"
#include "colmap_ext/run/ranks.h"

namespace limn::colmap_ext {

int RunAutomaticDrawer(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  // The others begin when rank 0 knows that there is work and holds the lock.
  const bool leads = Rank() == 0;
  if (!leads && !AsRankZero(true)) return 0;
  DrawerOptions options;
  const auto parser = ParseDrawerOptions(argc, argv, &options);
  if (!parser) {
    AsRankZero(false);
    return 0;
  }
  options.run.is_led = !leads;
  const auto console = make_console(options.run.num_threads, leads);
  const Project project(options.run, console.get());
  if (DrawProject(project, options, console.get())) {
    parser->WriteIni(project.CurvesPath("project.ini"));
  }
  return 0;
}

}  // namespace limn::colmap_ext
