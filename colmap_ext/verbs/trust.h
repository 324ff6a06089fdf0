// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/model/curve_fragment.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/util/name_list.h"
#include "limn/util/parallel.h"

namespace limn::colmap_ext {

// Images that see a well-seen curve.
constexpr size_t kManyImages = 5;

// What the numbers of a drawing say of it as a whole.
enum class Verdict : uint8_t { kGood, kDoubtful, kNonsense };

// "good", "doubtful", "nonsense".
const char* VerdictName(Verdict verdict);

// How far a drawing can be trusted. Tentative links count only in `right`, `tentative` and
// `unmeasured`; contours in none of them.
struct Trust {
  size_t num_images = 0;
  // Share of the edges of an image that the drawing explains, median over images. Nothing if the
  // edges are not known (a scene in tiles).
  std::optional<double> explained;
  // Images with hardly any edges, and those that agree much less than the others, with the
  // percentage of their edges that are drawn, least first.
  std::vector<NamedNumber> without_edges, agree_less;
  // Images whose cameras do not fit those of the others (limn/evaluation/weak_cut.h), with what
  // they share of what they would share if all fitted. Empty if all do,
  // and with panoramas.
  std::vector<std::string> apart;
  double shared_if_apart = 1;
  // Share of the length that kManyImages or more see.
  std::optional<double> well_seen;
  // Expected error, median and 90 % of the length, px: with that of refined cameras, or if the
  // cameras are right.
  std::optional<double> error_px, error_90_px;
  bool has_share_of_cameras = false;
  // Share of the length found, tentative or not, that is expected to be right: the mean confidence,
  // without outlines of smooth bodies and of rods. Nothing if no link has one.
  std::optional<double> right;
  // Share of the drawn length that is tentative. Wrong cameras raise it, and so do short baselines.
  std::optional<double> tentative;
  // Share whose depth was not measured (LinkDoubt::kDepth); part of `tentative`.
  std::optional<double> unmeasured;
  // Share of the edgels that stand still (limn/belief/still_edgels.h) and that nothing drawn
  // explains, and, of those that are explained, of those that are so at several depths
  // (limn/evaluation/explained_edgels.h). Nothing if the edges are not known.
  std::optional<double> still, at_other_depths;
};

// `views` are those of the set with the cameras that the drawing fits; `curves` belong to them, or
// are empty for a scene in tiles.
Trust MeasureTrust(const ViewSet& set, const std::vector<View>& views,
                   const std::vector<ImageCurves>& curves, const DrawingGraph& graph,
                   const RunContext& context);

// By what is expected to be right, what is explained and what was measured; doubtful if none of
// this is known, or if images are apart.
Verdict VerdictOf(const Trust& trust, bool has_box);

// Reports it. Warns if the drawing explains hardly anything, if images agree with it much less than
// the others, if groups of images do not fit each other, and about images without edges. With a
// box, a drawing may explain little.
void SayTrust(const Trust& trust, bool has_box, Console* console);

// Both, of a drawing whose views are those of the set.
Trust ReportTrust(const ViewSet& set, const DrawingInScene& drawing, Console* console);

}  // namespace limn::colmap_ext
