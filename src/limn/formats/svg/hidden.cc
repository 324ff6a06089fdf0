// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/hidden.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

// Halvings of a step between samples, about a pixel.
constexpr int kHalvings = 6;

struct Run {
  CurveSample begin;
  CurveSample end;
  bool hidden = false;

  double length_px() const { return end.length_px - begin.length_px; }
};

CurveSample Border(const std::function<Eigen::Vector3d(double)>& point_at,
                   const IsHidden& is_hidden, CurveSample first, CurveSample second,
                   bool first_is_hidden) {
  for (int i = 0; i < kHalvings; ++i) {
    const CurveSample middle = {0.5 * (first.t + second.t),
                                0.5 * (first.length_px + second.length_px)};
    (is_hidden(point_at(middle.t)) == first_is_hidden ? first : second) = middle;
  }
  return {0.5 * (first.t + second.t), 0.5 * (first.length_px + second.length_px)};
}

// Neighbors of the same kind become one.
std::vector<Run> Joined(const std::vector<Run>& runs) {
  std::vector<Run> joined;
  for (const Run& run : runs) {
    if (!joined.empty() && joined.back().hidden == run.hidden) {
      joined.back().end = run.end;
    } else {
      joined.push_back(run);
    }
  }
  return joined;
}

std::vector<Run> WithoutShort(std::vector<Run> runs, bool hidden, double min_run_px) {
  if (runs.size() < 2) return runs;
  for (Run& run : runs) {
    if (run.hidden == hidden && run.length_px() < min_run_px) run.hidden = !hidden;
  }
  return Joined(runs);
}

template <typename Behind>
bool BehindAllAround(const Behind& is_behind) {
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    if (!is_behind(Eigen::Vector2d(x, y))) return false;
  }
  return true;
}

}  // namespace

IsHidden HiddenInView(View view, DepthImage depth, double tolerance_px, double margin_px) {
  return [view = std::move(view), depth = std::move(depth), tolerance_px,
          margin_px](const Eigen::Vector3d& point) {
    const auto pixel = view.Project(point);
    if (!pixel) return false;
    const double z = (view.cam_from_world * point).z();
    const double tolerance = tolerance_px * z / view.camera.MeanFocal();
    return BehindAllAround([&](const Eigen::Vector2d& side) {
      return IsBehind(depth, *pixel + margin_px * side, z, tolerance);
    });
  };
}

IsHidden HiddenOnSheet(OrthographicDepth depth, double tolerance_px, double margin_px) {
  const double cell = depth.image.cell_px.x();
  return [depth = std::move(depth), tolerance = tolerance_px * cell,
          margin = margin_px * cell](const Eigen::Vector3d& point) {
    return BehindAllAround([&](const Eigen::Vector2d& side) {
      const Eigen::Vector3d beside = point + margin * depth.axes.topRows<2>().transpose() * side;
      return IsBehind(depth, beside, tolerance);
    });
  };
}

std::vector<ShownRun> FindRuns(const std::function<Eigen::Vector3d(double)>& point_at,
                               const std::vector<CurveSample>& samples, const IsHidden& is_hidden,
                               double min_run_px) {
  if (!is_hidden) return {{samples.front().t, samples.back().t, false}};
  std::vector<Run> runs = {{samples[0], samples[0], is_hidden(point_at(samples[0].t))}};
  for (size_t i = 1; i < samples.size(); ++i) {
    const bool hidden = is_hidden(point_at(samples[i].t));
    if (hidden != runs.back().hidden) {
      const CurveSample border = Border(point_at, is_hidden, samples[i - 1], samples[i], !hidden);
      runs.back().end = border;
      runs.push_back({border, border, hidden});
    }
    runs.back().end = samples[i];
  }
  runs = WithoutShort(std::move(runs), /*hidden=*/true, min_run_px);
  runs = WithoutShort(std::move(runs), /*hidden=*/false, min_run_px);
  std::vector<ShownRun> shown;
  for (const Run& run : runs) shown.push_back({run.begin.t, run.end.t, run.hidden});
  return shown;
}

}  // namespace limn
