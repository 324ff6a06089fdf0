// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/host/scene.h"
#include "limn/model/curves_scene.h"
#include "limn/pipeline/pipeline.h"

namespace limn::colmap_ext {

// What the work on a scene needs, whether a command does it in a project or a program in memory.
struct Job {
  const Scene& scene;
  const RunOptions& options;
  Console* console;
  // Where image curves and sketches are kept. That of a scene in memory keeps nothing.
  ResultCache* cache;

  const std::vector<View>& views() const { return scene.views(); }
  const RunContext& context() const { return console->context(); }
  StageObserver reporter() const;
  // The scene, with its box, as the stages after the edges see it.
  CurvesScene WithCurves(const std::vector<ImageCurves>& curves) const;
};

Job JobOf(const Project& project, const RunOptions& options, Console* console);

// The image curves of all views, from the cache where possible; prints a summary.
CurvesResult ExtractImageCurves(const Job& job, const FragmentsObserver& on_fragments = {});

// The curves alone, for several drawings to share.
std::shared_ptr<const std::vector<ImageCurves>> SharedImageCurves(const Job& job);

}  // namespace limn::colmap_ext
