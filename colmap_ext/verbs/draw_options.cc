// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/draw_options.h"

#include <string>

#include "colmap_ext/host/ranks.h"
#include "limn/pipeline/update_scene.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

// For an option that brings drawings up to date.
void CheckUpdate(const std::string& option, const DrawerOptions& options) {
  CheckUpdatable(options.run.pipeline);
  if (!options.run.shard.empty() || NumRanks() > 1) {
    throw OptionError(option + " = 1: is done by one process, without shards");
  }
  if (options.account) {
    throw OptionError("account = 1: a drawing that is brought up to date (" + option +
                      " = 1) keeps no account");
  }
}

}  // namespace

void DrawerOptions::Check() const {
  if (!run.shard.empty() && NumRanks() > 1) {
    throw OptionError("shard = " + run.shard + ": MPI processes make their own shards");
  }
  if (account && run.pipeline.mode == SketchMode::kOriginal) {
    throw OptionError("account = 1: the original sketch judges whole curves, not edgels");
  }
  if (account && run.pipeline.output_cameras == OutputCameras::kGiven) {
    throw OptionError(
        "account = 1: tells what became of edgels with the cameras that curves were drawn with: "
        "needs output_cameras = refined");
  }
  if (run.update) CheckUpdate("update", *this);
  if (watch) CheckUpdate("watch", *this);
  if (truth.IsGiven()) truth.Check();
  align.Check();
}

void DrawerOptions::SetDerived() {
  run.SetDerived();
  truth.evaluation.region = BoxFromNumbers(run.box);
}

std::optional<OptionParser> ParseDrawerOptions(const char* heading, int argc,
                                               const char* const* argv, DrawerOptions* options) {
  const OptionGroups groups = {.linking = true,
                               .sketch = true,
                               .drawing = true,
                               .refinement = true,
                               .tiles = true,
                               .output_cameras = true,
                               .shards = true,
                               .overwrites = true};
  auto parser = ParseRunOptions(
      "automatic_drawer", heading, groups, argc, argv, &options->run, [&](OptionParser* more) {
        more->AddOption("update", &options->run.update,
                        BasicOption("bring the drawing of an earlier run up to date: "
                                    "draw only what new, changed and missing images "
                                    "touch"));
        more->AddOption("watch", &options->watch,
                        "keep running: bring the drawing up to date whenever the model or an image "
                        "changes");
        more->AddOption("account", &options->account,
                        BasicOption("report what became of every edgel"));
        more->AddOption("page", &options->page, "write drawing.html, with a report");
        options->results.AddOptions(more);
        options->truth.AddOptions(/*are_basic=*/false, more);
        options->align.AddOptions(/*of_drawing=*/false, more);
      });
  if (!parser) return std::nullopt;
  options->Check();
  options->SetDerived();
  return parser;
}

}  // namespace limn::colmap_ext
