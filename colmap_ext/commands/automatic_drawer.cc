// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/commands/automatic_drawer.h"

#include <exception>
#include <memory>
#include <string>

#include "colmap_ext/host/ranks.h"
#include "colmap_ext/verbs/draw.h"
#include "colmap_ext/verbs/workspace_watch.h"
#include "limn/files/error_line.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// `watch` may be null.
void Draw(const DrawerOptions& options, const OptionParser& parser, WorkspaceWatch* watch,
          Console* console) {
  SayRetired(parser, console);
  const Project project(options.run, console);
  if (watch) watch->WatchImages(project, options.run.view.mask_path);
  if (DrawProject(project, options, console)) parser.WriteIni(project.CurvesPath("project.ini"));
}

// Draws once, and then whenever the workspace has changed, until it is interrupted. Only errors of
// the first run end it: later ones may come from files that are being written.
void DrawAndWatch(DrawerOptions options, const OptionParser& parser,
                  const ConsoleMaker& make_console) {
  WorkspaceWatch watch(ResolveLayout(options.run.layout).model_dir);
  for (bool is_first = true;; is_first = false) {
    const auto console = make_console(options.run.num_threads, PrintingAt(options.run.log_level));
    watch.Look();
    try {
      Draw(options, parser, &watch, console.get());
      options.run.update = true;
    } catch (const Cancelled&) {
      throw;
    } catch (const std::exception& error) {
      if (is_first) throw;
      PrintErrorLine(std::string("ERROR: ") + error.what());
    }
    console->Say("Waiting for changes of model and images; Ctrl-C ends");
    if (!watch.WaitForChange(console->context())) return;
  }
}

}  // namespace

int RunAutomaticDrawer(const Command& command, int argc, const char* const* argv,
                       const ConsoleMaker& make_console) {
  // The others begin when rank 0 knows that there is work and holds the lock.
  const bool leads = Rank() == 0;
  if (!leads && WaitForRankZero() == RankOrder::kEnd) return 0;
  DrawerOptions options;
  const auto parser = ParseDrawerOptions(command.heading, argc, argv, &options);
  if (!parser) {
    if (leads) TellOtherRanks(RankOrder::kEnd);
    return 0;
  }
  if (options.watch) {
    DrawAndWatch(options, *parser, make_console);
    return 0;
  }
  options.run.is_locked_by_rank_zero = !leads;
  const auto console = make_console(options.run.num_threads,
                                    leads ? PrintingAt(options.run.log_level) : Printing::kOff);
  Draw(options, *parser, nullptr, console.get());
  return 0;
}

}  // namespace limn::colmap_ext
