// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "limn/alignment/camera_hints.h"
#include "limn/alignment/dominant_directions.h"
#include "limn/alignment/known_lengths.h"
#include "limn/alignment/plan_line.h"
#include "limn/alignment/position_check.h"
#include "limn/alignment/position_fit.h"
#include "limn/model/alignment.h"

namespace limn {

// Whose coordinates those of the world are.
enum class WorldFrame {
  kDrawing,    // the middle of its floor is the origin, its main horizontal direction an axis
  kPositions,  // those of the positions of cameras: x is east, the origin theirs
};

struct AlignmentInput {
  const std::vector<View>& views;  // that the drawing fits
  const DrawingGraph& graph;
  const std::vector<ViewPrior>& priors;  // one per view, or none
  const std::vector<KnownLength>& lengths;
  const std::vector<PlanLine>& plan_lines;
  WorldFrame world = WorldFrame::kDrawing;
};

struct AlignmentResult {
  Alignment alignment;
  // That of the drawing if positions were asked for, but do not tell east and scale.
  WorldFrame world = WorldFrame::kDrawing;
  // Intermediate results, set even where something better was used.
  std::optional<GravityUp> gravity;
  std::optional<PositionFit> positions;
  std::vector<ViewId> positioned;  // the views of its residuals
  // Positions that contradict the cameras or something else determine nothing.
  PositionCheck position_check;
  // Of the photographs with a position, those that were taken upside down by these.
  std::vector<ViewId> upside_down;
  std::optional<DominantDirection> vertical, horizontal;
  std::optional<LengthFit> lengths;
};

// Up, horizontal axes, scale, floor and middle of a drawing (algorithm/alignment.md). Throws
// OptionError for lengths and lines that the drawing does not have or that contradict each other.
// The same input gives the same result.
AlignmentResult AlignDrawing(const AlignmentInput& input);

}  // namespace limn
