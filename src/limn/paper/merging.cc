// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/merging.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "limn/paper/sample_homes.h"
#include "limn/util/runs.h"

namespace limn {
namespace {

// Shorter free runs between absorbed samples are noise in the overlap, px.
constexpr double kMinRunPx = 4;

// Where a curve leaves or rejoins links: its last sample there, and that sample's home.
struct Touch {
  int sample = -1;
  int home = -1;

  explicit operator bool() const { return home >= 0; }
};

class CurveMerger {
 public:
  CurveMerger(const SampleSet& samples, const CurveConsistency& network,
              const std::vector<View>& views, const PaperOptions& options)
      : samples_(samples),
        options_(options),
        primitives_(samples, options, &graph_),
        homes_(samples, network, views, options, primitives_) {}

  DrawingGraph Run(const RunContext& context, MergingCounts* counts) {
    for (const int curve : LongestFirst()) {
      ThrowIfCancelled(context);
      MergeCurve(curve);
    }
    primitives_.ListSamples();
    *counts = primitives_.counts();
    return std::move(graph_);
  }

 private:
  std::vector<int> LongestFirst() const {
    std::vector<double> length;
    for (int c = 0; c < samples_.NumCurves(); ++c) length.push_back(ArcPx(samples_, c).back());
    std::vector<int> curves(length.size());
    std::iota(curves.begin(), curves.end(), 0);
    std::ranges::stable_sort(curves, std::greater(), [&](int c) { return length[c]; });
    return curves;
  }

  void MergeCurve(int curve) {
    std::vector<int> order(samples_.Size(curve));
    std::iota(order.begin(), order.end(), samples_.curve_begin[curve]);
    std::vector<int> home;
    for (const int sample : order) home.push_back(homes_.Find(sample));
    const bool closed = samples_.origins[curve].closed;
    if (closed) {
      BeginAtAHome(&order, &home);
    } else {
      homes_.FindOwn(curve, &home);
    }
    const int size = static_cast<int>(order.size());
    for (int k = 0; k < size; ++k) primitives_.SetHome(order[k], home[k]);
    const auto touch = [&](int k) {
      return k < 0 || k >= size ? Touch() : Touch{order[k], home[k]};
    };
    const auto is_free = [&](int k) { return home[k] < 0; };
    ForEachRun(size, is_free, [&](int begin, int end) {
      const std::vector<int> run(order.begin() + begin, order.begin() + end);
      MergeRun(run, closed, touch(begin - 1), touch(end));
    });
    if (closed) return;
    AttachToOwnInterior(order.front());
    AttachToOwnInterior(order.back());
  }

  // Rotates a closed curve that has homes so that it begins and ends at one of them.
  static void BeginAtAHome(std::vector<int>* order, std::vector<int>* home) {
    const auto found = std::ranges::find_if(*home, [](int vertex) { return vertex >= 0; });
    if (found == home->end()) return;
    std::rotate(order->begin(), order->begin() + (found - home->begin()), order->end());
    std::rotate(home->begin(), found, home->end());
    order->push_back(order->front());
    home->push_back(home->front());
  }

  // A run of a curve without homes, between the places where the curve leaves and rejoins existing
  // links, or itself, if it does.
  void MergeRun(const std::vector<int>& run, bool closed, const Touch& before, const Touch& after) {
    MergingCounts& counts = primitives_.counts();
    if (!before && !after) {
      ++counts.released;
      primitives_.AddRun(run, closed);
      return;
    }
    const bool meets_itself = std::ranges::count(run, after.home) > 0;
    if (!meets_itself && IsNoise(run, before, after)) {
      Absorb(run, before, after);
      return;
    }
    const bool is_between = before && after && !meets_itself;
    if (meets_itself ||
        (is_between && primitives_.LinkOf(before.home) == primitives_.LinkOf(after.home))) {
      ++counts.rejoined;
    } else if (is_between) {
      ++counts.bridged;
    }
    const std::vector<int> front = Touched(before);
    const std::vector<int> back = Touched(after);
    primitives_.AddRun(run, false);
    primitives_.Attach(run.front(), front, after.home);
    primitives_.Attach(run.back(), back, before.home);
  }

  std::vector<int> Touched(const Touch& touch) const {
    return touch ? homes_.FindTouched(touch.sample, touch.home) : std::vector<int>();
  }

  bool IsNoise(const std::vector<int>& run, const Touch& before, const Touch& after) const {
    double length_px = 0;
    for (size_t i = 1; i < run.size(); ++i) {
      length_px += (samples_.position[run[i]] - samples_.position[run[i - 1]]).norm() /
                   samples_.footprint[run[i]];
    }
    return length_px < kMinRunPx || (before && after && length_px < options_.min_branch_length_px &&
                                     Near(before.home, after.home));
  }

  void Absorb(const std::vector<int>& run, const Touch& before, const Touch& after) {
    const size_t to_before = !after ? run.size() : !before ? 0 : (run.size() + 1) / 2;
    for (size_t i = 0; i < run.size(); ++i) {
      primitives_.SetHome(run[i], i < to_before ? before.home : after.home);
    }
  }

  bool Near(int vertex_a, int vertex_b) const {
    const int a = primitives_.HomeOf(vertex_a);
    const int b = primitives_.HomeOf(vertex_b);
    return (samples_.position[a] - samples_.position[b]).norm() <=
           options_.min_branch_length_px * samples_.footprint[a];
  }

  void AttachToOwnInterior(int tip) {
    if (!primitives_.IsFreeEnd(tip)) return;
    const int ahead = homes_.FindAhead(tip);
    if (ahead < 0) return;
    if (primitives_.Attach(tip, {ahead}, -1)) ++primitives_.counts().rejoined;
  }

  const SampleSet& samples_;
  const PaperOptions& options_;
  DrawingGraph graph_;
  MergingPrimitives primitives_;
  SampleHomes homes_;
};

}  // namespace

DrawingGraph MergeCurves(const SampleSet& samples, const CurveConsistency& network,
                         const std::vector<View>& views, const PaperOptions& options,
                         const RunContext& context, MergingCounts* counts) {
  return CurveMerger(samples, network, views, options).Run(context, counts);
}

}  // namespace limn
