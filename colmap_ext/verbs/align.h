// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/scene.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/verbs/drawing_verb.h"
#include "limn/alignment/align_drawing.h"

namespace limn::colmap_ext {

// The options of commands that align a drawing.
struct AlignOptions {
  enum class Mode { kNone, kAuto };
  Mode mode = Mode::kNone;
  // Empty: the one found near the model.
  std::string database_path;
  // See ParseKnownLengths.
  std::vector<std::string> known_lengths;
  // See ParsePlanLines.
  std::vector<std::string> plan_lines;
  bool use_positions = true;
  WorldFrame world = WorldFrame::kDrawing;
  // Positions that contradict the cameras: an error, or else a warning. No option.
  bool contradictions_fail = false;

  // Known lengths and lines of a plan name links, so only commands that start from a drawing have
  // them; these commands align in any case, and choose the world.
  void AddOptions(bool of_drawing, OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

// Up, axes and scale of the drawings of a scene.
class SceneAligner {
 public:
  // Before work starts: reads the priors of the views if there is to be an alignment, and says
  // which. Throws IoError for a given database that cannot be read, and OptionError; of a database
  // that was found it only warns. The scene must outlive the aligner.
  SceneAligner(const Scene& scene, const LayoutOptions& layout, const AlignOptions& options,
               Console* console);

  // Says how it was found. `views`, which the drawing fits, and the graph are relative to the
  // scene's origin; the alignment is of the model's coordinates. Nothing if none is asked for.
  // Throws OptionError for known lengths that the graph does not have or that contradict each
  // other, and IoError for positions that contradict the cameras, gravity or known lengths, if
  // these fail.
  std::optional<Alignment> Align(const std::vector<View>& views, const DrawingGraph& graph,
                                 Console* console) const;

 private:
  void CheckPositions(const AlignmentResult& result, Console* console) const;
  void CheckWorld(const AlignmentResult& result) const;

  const Scene& scene_;
  bool is_asked_ = false;
  bool contradictions_fail_ = false;
  WorldFrame world_ = WorldFrame::kDrawing;
  std::filesystem::path database_;  // of the priors
  std::vector<KnownLength> lengths_;
  std::vector<PlanLine> plan_lines_;
  std::vector<ViewPrior> priors_;
};

// drawing_aligner: where the drawing is in the world. Stores that in drawings whose graphs stay as
// they are: that of --drawing_path, or those of the output folder. If it is to be applied, writes
// the whole project in world coordinates (aligned_project.h).
class AlignVerb : public DrawingVerb {
 public:
  enum class AppliesTo { kDrawing, kProject };

  OptionGroups Groups() const override { return {.overwrites = true}; }
  bool HasOwnOptions() const override { return true; }
  bool KeepsGraph() const override { return true; }
  // A named drawing may be anywhere.
  bool WritesDrawing() const override { return drawing_path().empty(); }
  void AddOptions(OptionParser* parser) override;
  void AddFileOptions(OptionParser* parser) override;
  void Prepare(RunOptions* options, Console* console) override;
  DrawingInScene Apply(const Job& job, const DrawingInScene& given) override;
  std::vector<std::string> StartsFrom(const RunOptions& options) const override;
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 private:
  AlignOptions align_;
  AppliesTo apply_to_ = AppliesTo::kDrawing;
};

}  // namespace limn::colmap_ext
