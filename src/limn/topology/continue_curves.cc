// SPDX-License-Identifier: BSD-3-Clause
#include "limn/topology/continue_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "limn/geometry/angle_between.h"
#include "limn/geometry/parabola.h"
#include "limn/geometry/spatial_index.h"
#include "limn/support/point_fit.h"
#include "limn/support/segment_support.h"
#include "limn/topology/edgel_claims.h"
#include "limn/topology/joints.h"
#include "limn/topology/meetings.h"
#include "limn/util/angles.h"

namespace limn {
namespace {

// A step finds edgels within this gate. How the constants were chosen:
// algorithm/topology.md#what-was-measured.
constexpr SupportGate kStepGate = {1.5, 1.0, 20 * kDeg};
// Longest continuation, steps of one px.
constexpr int kMaxSteps = 400;
// Length of the stretch whose parabola is followed, px, the noise of its points, px, and the
// standard deviation of its bend, 1 / px.
constexpr double kFollowedPx = 12;
constexpr double kPointSigmaPx = 0.3;
constexpr double kBendSigma = 0.02;
// Standard deviation of a step across that line, px, and the residual beyond which edgels count
// linearly.
constexpr double kStepSigmaPx = 0.3;
constexpr double kRobustPx = 0.6;
// Views that supported this length of the link take part, px.
constexpr double kKnownPx = 12;
// Share of the views taking part, and their number, that must support a step.
constexpr double kMinShare = 0.25;
constexpr size_t kMinStepViews = 3;
// Stretches of this many steps must be shown beyond chance.
constexpr int kStretchSteps = 16;
constexpr double kMaxStretchChance = 1e-2;
// A view shows a stretch if this share of its steps has an edgel.
constexpr double kMinCoveredShare = 0.7;
// Views that must show it by edgels which no link has.
constexpr int kMinOwnViews = 2;
// A link runs along a walk if it is this near, px, and within this angle.
constexpr double kAlongsidePx = 1;
constexpr double kAlongsideRad = 30 * kDeg;
// A walk may meet its own link only after this many steps, and this many points from its end.
constexpr int kOwnSteps = 10;
constexpr int kOwnPoints = 20;

struct Step {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // unit
  double footprint = 0;
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  // across the curve
  std::vector<EdgelRef> support;
  std::vector<ViewId> views;  // that take part
  bool is_supported = false;
};

// Drops steps at the end that views do not support.
void TrimGap(std::vector<Step>* steps) {
  while (!steps->empty() && !steps->back().is_supported) steps->pop_back();
}

// The continuation of a curve through some points, the latest one last, by arc length in px. A bend
// has a prior, so that noise does not bend straight lines.
Parabola GoOn(std::span<const Eigen::Vector3d> points, double footprint) {
  std::vector<double> arcs_px(points.size(), 0);
  for (size_t k = points.size() - 1; k-- > 0;) {
    arcs_px[k] = arcs_px[k + 1] - (points[k + 1] - points[k]).norm() / footprint;
  }
  return FitParabola(points, arcs_px, std::pow(kPointSigmaPx / (0.5 * kBendSigma), 2));
}

class Walker {
 public:
  Walker(const TopologyInput& input, const TopologyOptions& options, const DrawingGraph& graph,
         const RunContext& context)
      : input_(input),
        options_(options),
        graph_(graph),
        places_(CollectPlaces(graph)),
        index_(places_.position),
        unclaimed_(UnclaimedEdgels(input, graph, context)) {}

  std::vector<Step> Walk(const LinkEnd& end) const {
    State state = Begin(end);
    std::vector<Step> steps;
    if (state.recent.size() < 2) return steps;
    for (int i = 0; i < kMaxSteps; ++i) {
      Step step = Predict(state, i);
      if (input_.box && !input_.box->contains(step.position)) break;
      if (step.views.size() < kMinStepViews) break;
      MoveToEdgels(&step);
      step.is_supported = static_cast<double>(step.support.size()) >=
                          std::max(static_cast<double>(kMinStepViews),
                                   kMinShare * static_cast<double>(step.views.size()));
      if (step.is_supported) state.last_supported = i;
      for (const EdgelRef& ref : step.support) state.last_seen[ref.view] = i;
      Remember(step, &state);
      const bool arrived = RunsAlongLink(step, end, i);
      steps.push_back(std::move(step));
      if (arrived || i - state.last_supported > options_.max_continuation_gap_px) break;
    }
    TrimGap(&steps);
    KeepShown(&steps);
    return steps;
  }

 private:
  struct State {
    double footprint = 0;
    std::vector<Eigen::Vector3d> recent;  // points of the last stretch, the latest one last
    std::vector<double> last_seen;        // per view: the step with an edgel; before 0: on the link
    int last_supported = -1;
  };

  State Begin(const LinkEnd& end) const {
    const DrawingLink& link = graph_.links[end.link];
    const int size = link.size();
    const auto at = [&](int k) { return end.end == 0 ? k : size - 1 - k; };
    State state;
    state.footprint = link.vertices[at(0)].footprint;
    state.last_seen.assign(input_.views.size(), -2 * kMaxSteps);
    double arc_px = 0;
    for (int k = 0; k < size && arc_px < kKnownPx; ++k) {
      const Eigen::Vector3d& point = link.points_in_world[at(k)];
      if (k > 0) arc_px += (point - link.points_in_world[at(k - 1)]).norm() / state.footprint;
      if (arc_px <= kFollowedPx) state.recent.push_back(point);
      // Views in which the end of the link is hidden get half as many steps to show it again.
      const double seen_at = -0.5 * options_.max_continuation_gap_px * arc_px / kKnownPx;
      for (const EdgelRef& ref : link.vertices[at(k)].support) {
        state.last_seen[ref.view] = std::max(state.last_seen[ref.view], seen_at);
      }
    }
    std::ranges::reverse(state.recent);
    return state;
  }

  Step Predict(const State& state, int i) const {
    Step step;
    step.footprint = state.footprint;
    const Parabola curve = GoOn(state.recent, state.footprint);
    step.direction = curve.SlopeAt(1).normalized();
    step.position = curve.At(1);
    for (size_t v = 0; v < state.last_seen.size(); ++v) {
      if (i - state.last_seen[v] > options_.max_continuation_gap_px + 1) continue;
      step.views.push_back(static_cast<ViewId>(v));
    }
    return step;
  }

  static void Remember(const Step& step, State* state) {
    std::vector<Eigen::Vector3d>& recent = state->recent;
    recent.push_back(step.position);
    const auto is_far = [&](const Eigen::Vector3d& point) {
      return (point - step.position).norm() > kFollowedPx * step.footprint;
    };
    while (recent.size() > 3 && is_far(recent.front())) recent.erase(recent.begin());
  }

  void MoveToEdgels(Step* step) const {
    constexpr int kMoves = 2;
    PointFit fit(step->position, step->direction, kStepSigmaPx * step->footprint, kRobustPx);
    for (int i = 0; i < kMoves; ++i) {
      std::vector<EdgelTarget> targets;
      for (const EdgelRef& ref :
           SupportAt(input_, fit.position(), step->direction, step->views, kStepGate)) {
        targets.push_back(input_.TargetOf(ref));
      }
      fit.StepTo(targets);
    }
    step->position = fit.position();
    step->information = fit.Information();
    step->support = SupportAt(input_, step->position, step->direction, step->views, input_.gate);
  }

  bool RunsAlongLink(const Step& step, const LinkEnd& own, int i) const {
    std::vector<SpatialIndex::Neighbor> near;
    index_.FindWithin(step.position, kAlongsidePx * step.footprint, &near);
    return std::ranges::any_of(near, [&](const SpatialIndex::Neighbor& neighbor) {
      const auto& [id, k] = places_.point[neighbor.index];
      const DrawingLink& link = graph_.links[id];
      const int from_end = own.end == 0 ? k : link.size() - 1 - k;
      if (id == own.link && (i < kOwnSteps || from_end < kOwnPoints)) return false;
      return LineAngleBetween(TangentAt(link, k), step.direction) < kAlongsideRad;
    });
  }

  // Keeps the stretches before the first one that the images do not show.
  void KeepShown(std::vector<Step>* steps) const {
    std::span<const Step> rest = *steps;
    while (!rest.empty()) {
      // A short rest is judged with the stretch before it.
      const size_t count =
          rest.size() < 3 * kStretchSteps / 2 ? rest.size() : static_cast<size_t>(kStretchSteps);
      if (!IsShown(rest.first(count))) break;
      rest = rest.subspan(count);
    }
    steps->resize(steps->size() - rest.size());
    TrimGap(steps);
  }

  // What a view shows along a stretch: of its steps, of those with edgels of their own, and of
  // each copy, whether enough have edgels.
  struct Showing {
    bool is_visible = false;
    bool shows = false;
    bool shows_own = false;
    int num_copies = 0;
  };

  Showing LookAt(ViewId v, std::span<const Step> steps) const {
    const EdgelIndex& edgels = input_.edgels[v]->edgels;
    int num_visible = 0;
    int num_covered = 0;
    int num_own = 0;
    std::array<int, kChanceShiftsPx.size()> num_of_copy = {};
    for (const Step& step : steps) {
      const auto sight = See(input_.views[v], step.position, step.direction);
      if (!sight) continue;
      const auto& [pixel, direction] = *sight;
      ++num_visible;
      num_covered += edgels.Best(pixel, direction, input_.gate).has_value();
      num_own += unclaimed_[v].Best(pixel, direction, input_.gate).has_value();
      for (size_t c = 0; c < kChanceShiftsPx.size(); ++c) {
        const Eigen::Vector2d shifted = pixel + kChanceShiftsPx[c] * sight->Across();
        num_of_copy[c] += edgels.Best(shifted, direction, input_.gate).has_value();
      }
    }
    const auto is_enough = [&](int count) {
      return count >= kMinCoveredShare * static_cast<double>(steps.size());
    };
    return {is_enough(num_visible), is_enough(num_covered), is_enough(num_own),
            static_cast<int>(std::ranges::count_if(num_of_copy, is_enough))};
  }

  // The views that take part at the beginning are asked.
  bool IsShown(std::span<const Step> steps) const {
    int num_views = 0;
    int num_showing = 0;
    int num_own = 0;
    int num_copies = 0;
    for (const ViewId v : steps.front().views) {
      const Showing showing = LookAt(v, steps);
      if (!showing.is_visible) continue;
      ++num_views;
      num_showing += showing.shows;
      num_own += showing.shows_own;
      num_copies += showing.num_copies;
    }
    if (num_own < kMinOwnViews || num_showing < static_cast<int>(kMinStepViews)) return false;
    const double background =
        std::max(kMinChance, num_copies / static_cast<double>(kChanceShiftsPx.size() * num_views));
    return LogChance(num_showing, num_views, background) <= std::log(kMaxStretchChance);
  }

  const TopologyInput& input_;
  const TopologyOptions& options_;
  const DrawingGraph& graph_;
  Places places_;
  SpatialIndex index_;
  std::vector<EdgelIndex> unclaimed_;
};

// Cuts every walk where an earlier one, as far as it goes, runs along it.
void CutAtEarlier(std::vector<std::vector<Step>>* walks) {
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::pair<size_t, size_t>> names;  // walk, step
  for (size_t w = 0; w < walks->size(); ++w) {
    for (size_t i = 0; i < (*walks)[w].size(); ++i) {
      positions.push_back((*walks)[w][i].position);
      names.push_back({w, i});
    }
  }
  const SpatialIndex index(positions);
  std::vector<SpatialIndex::Neighbor> near;
  for (size_t w = 0; w < walks->size(); ++w) {
    std::vector<Step>& steps = (*walks)[w];
    const auto meets = [&](const Step& step) {
      index.FindWithin(step.position, kAlongsidePx * step.footprint, &near);
      return std::ranges::any_of(near, [&](const SpatialIndex::Neighbor& neighbor) {
        const auto& [other, i] = names[neighbor.index];
        return other < w && i < (*walks)[other].size() &&
               LineAngleBetween((*walks)[other][i].direction, step.direction) < kAlongsideRad;
      });
    };
    steps.erase(std::ranges::find_if(steps, meets), steps.end());
    TrimGap(&steps);
  }
}

DrawingLink LinkOf(std::vector<Step> steps) {
  DrawingLink link;
  for (Step& step : steps) {
    link.points_in_world.push_back(step.position);
    link.sigma.push_back(SigmaAcross(step.information, step.footprint));
    link.vertices.push_back({step.information, step.footprint, 0, std::move(step.support), {}});
  }
  return link;
}

}  // namespace

ContinuationCounts ContinueCurves(const TopologyInput& input, const TopologyOptions& options,
                                  const RunContext& context, GraphEditor* editor) {
  ContinuationCounts counts;
  std::vector<LinkEnd> ends = editor->FreeEnds();
  std::erase_if(ends, [&](const LinkEnd& end) { return editor->link(end.link).vertices.empty(); });
  if (ends.empty()) return counts;
  std::vector<std::vector<Step>> walks(ends.size());
  const Walker walker(input, options, editor->graph(), context);
  ParallelFor(context, "continuation", ends.size(),
              [&](size_t i) { walks[i] = walker.Walk(ends[i]); });
  CutAtEarlier(&walks);
  for (size_t i = 0; i < ends.size(); ++i) {
    const auto length = std::ssize(walks[i]);
    if (length < 2) continue;
    ++counts.ends;
    counts.length_px += length;
    const LinkId added = editor->Add(LinkOf(std::move(walks[i])));
    editor->Join(editor->CurrentEnd(ends[i]), {added, 0});
  }
  editor->Compact();
  return counts;
}

}  // namespace limn
