// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "colmap_ext/host/job.h"
#include "colmap_ext/verbs/align.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/verb.h"

namespace limn::colmap_ext {

// curve_drawer: the drawing of the stored sketch, before its refinement.
class DrawSketchVerb : public Verb {
 public:
  OptionGroups Groups() const override {
    return {.linking = true, .drawing = true, .overwrites = true};
  }
  void AddOptions(OptionParser* parser) override;
  void AddFileOptions(OptionParser* parser) override;
  void Prepare(RunOptions* options, Console* console) override;
  std::vector<std::string> StartsFrom(const RunOptions& options) const override;
  bool WritesDrawing() const override { return true; }
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 private:
  AlignOptions align_;
  ResultOptions results_;
};

// The provenance of a drawing made with `options` of a sketch with provenance `of_sketch`.
std::string ProvenanceOfDrawing(const RunOptions& options, const std::string& of_sketch);

// The drawing of a sketch, both relative to the scene's origin; prints a summary. `curves`: those
// of the sketch. Throws InputError and Cancelled.
DrawingInScene DrawSketchInScene(const Job& job,
                                 std::shared_ptr<const std::vector<ImageCurves>> curves,
                                 const CurveSketch& sketch, const std::string& provenance);

}  // namespace limn::colmap_ext
