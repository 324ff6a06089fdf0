// SPDX-License-Identifier: BSD-3-Clause
#include "limn/sketch/sketch_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

// A jump between neighbors beyond this, in px of the confirmation views and after allowing for the
// slope of the curve, ends a piece.
constexpr double kMaxJumpPx = 3;
// Half width of the stretch that the slope of depth is fitted to, px.
constexpr double kSlopeWindowPx = 6;
// Standard deviation of an edgel across the edge that depth errors are derived from, px.
constexpr double kEdgelSigmaPx = 0.2;
// Longest gap in support that does not break a curve: single edgels are missing everywhere.
constexpr double kMaxUnsupportedGapPx = 2.5;
// Longest epipolar-tangent stretch: beyond, its ends do not tell its depth.
constexpr double kMaxInterpolatedGapPx = 30;
// Shorter pieces are mostly accidents.
constexpr double kMinPieceLengthPx = 8;

void FillBetween(const FragmentRays& fragment, int from, int to, std::vector<FusedDepth>* depths) {
  const FusedDepth first = (*depths)[from];
  const FusedDepth last = (*depths)[to];
  const double length = fragment.arc_px[to] - fragment.arc_px[from];
  for (int i = from + 1; i < to; ++i) {
    const double t = length > 0 ? (fragment.arc_px[i] - fragment.arc_px[from]) / length : 0.5;
    FusedDepth& depth = (*depths)[i];
    depth.has_depth = true;
    depth.certain = false;
    depth.weight = 0;
    depth.inverse_depth = (1 - t) * first.inverse_depth + t * last.inverse_depth;
    depth.px_per_inverse_depth = first.px_per_inverse_depth;
  }
}

// Whether `from` and `to`, neighbors in the fragment, may belong to one 3D curve. The second
// differences on both sides tell slope from jump.
bool Connected(const std::vector<FusedDepth>& depths, int from, int to) {
  const int count = static_cast<int>(depths.size());
  const FusedDepth& a = depths[from];
  const FusedDepth& b = depths[to];
  if (!a.has_depth || !b.has_depth) return false;
  const double step = b.inverse_depth - a.inverse_depth;
  double unexplained = std::abs(step);
  const auto explain = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= count || j >= count) return;
    if (!depths[i].has_depth || !depths[j].has_depth) return;
    const double neighbor_step = depths[j].inverse_depth - depths[i].inverse_depth;
    unexplained = std::min(unexplained, std::abs(step - neighbor_step));
  };
  explain(from - 1, from);
  explain(to, to + 1);
  return unexplained * std::max(a.px_per_inverse_depth, b.px_per_inverse_depth) <= kMaxJumpPx;
}

// Weighted least squares line through points (s, q).
class LineFit {
 public:
  void Add(double s, double q, double weight) {
    sum_ += weight;
    sum_s_ += weight * s;
    sum_ss_ += weight * s * s;
    sum_q_ += weight * q;
    sum_sq_ += weight * s * q;
  }
  bool IsDetermined() const { return Determinant() > 1e-12 * sum_ * sum_ss_; }
  double Slope() const { return (sum_ * sum_sq_ - sum_s_ * sum_q_) / Determinant(); }
  double AtZero() const { return (sum_ss_ * sum_q_ - sum_s_ * sum_sq_) / Determinant(); }

 private:
  double Determinant() const { return sum_ * sum_ss_ - sum_s_ * sum_s_; }

  double sum_ = 0, sum_s_ = 0, sum_ss_ = 0, sum_q_ = 0, sum_sq_ = 0;
};

// Slope of inverse depth per px at position j of a run, fitted to its neighborhood.
double FitSlope(const std::vector<double>& arc, const std::vector<double>& inverse_depth,
                const std::vector<double>& weight, size_t j) {
  LineFit fit;
  const auto add = [&](size_t k) { fit.Add(arc[k] - arc[j], inverse_depth[k], weight[k]); };
  for (size_t k = j; k < arc.size() && arc[k] - arc[j] <= kSlopeWindowPx; ++k) add(k);
  for (size_t k = j; k-- > 0 && arc[j] - arc[k] <= kSlopeWindowPx;) add(k);
  return fit.IsDetermined() ? fit.Slope() : 0;
}

}  // namespace

std::vector<FusedDepth> ExpandDepths(const FragmentRays& fragment, const std::vector<int>& vertices,
                                     const std::vector<FusedDepth>& depths) {
  std::vector<FusedDepth> all(fragment.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    const FusedDepth& a = depths[i];
    all[vertices[i]] = a;
    if (i + 1 == vertices.size() || !a.has_depth || !depths[i + 1].has_depth) continue;
    const FusedDepth& b = depths[i + 1];
    const double length = fragment.arc_px[vertices[i + 1]] - fragment.arc_px[vertices[i]];
    for (int k = vertices[i] + 1; k < vertices[i + 1]; ++k) {
      const double t =
          length > 0 ? (fragment.arc_px[k] - fragment.arc_px[vertices[i]]) / length : 0;
      FusedDepth& depth = all[k];
      depth = t < 0.5 ? a : b;
      depth.certain = a.certain && b.certain;
      depth.inverse_depth = (1 - t) * a.inverse_depth + t * b.inverse_depth;
      depth.weight = (1 - t) * a.weight + t * b.weight;
    }
  }
  return all;
}

void InterpolateGaps(const FragmentRays& fragment, std::vector<FusedDepth>* depths) {
  const int count = static_cast<int>(depths->size());
  const auto interpolate_between = [&](auto is_anchor, double max_length_px) {
    int last = -1;
    for (int i = 0; i < count; ++i) {
      if (!is_anchor((*depths)[i])) continue;
      const bool gap = last >= 0 && i > last + 1;
      if (gap && fragment.arc_px[i] - fragment.arc_px[last] <= max_length_px) {
        const double jump = std::abs((*depths)[i].inverse_depth - (*depths)[last].inverse_depth) *
                            (*depths)[i].px_per_inverse_depth;
        if (jump <= kMaxJumpPx + fragment.arc_px[i] - fragment.arc_px[last]) {
          FillBetween(fragment, last, i, depths);
        }
      }
      last = i;
    }
  };
  interpolate_between([](const FusedDepth& depth) { return depth.has_depth; },
                      kMaxUnsupportedGapPx + 1);
  // Only stretches that are supported throughout, if at uncertain depth, are re-interpolated.
  int last_certain = -1;
  bool all_have_depth = true;
  for (int i = 0; i < count; ++i) {
    if (!(*depths)[i].has_depth) all_have_depth = false;
    if (!(*depths)[i].has_depth || !(*depths)[i].certain) continue;
    if (last_certain >= 0 && i > last_certain + 1 && all_have_depth &&
        fragment.arc_px[i] - fragment.arc_px[last_certain] <= kMaxInterpolatedGapPx) {
      FillBetween(fragment, last_certain, i, depths);
    }
    last_certain = i;
    all_have_depth = true;
  }
}

void SmoothDepths(const FragmentRays& fragment, double half_window_px,
                  std::vector<FusedDepth>* depths) {
  const std::vector<FusedDepth> raw = *depths;
  const int count = static_cast<int>(raw.size());
  for (int j = 0; j < count; ++j) {
    if (!raw[j].has_depth) continue;
    LineFit fit;
    const auto add = [&](int k) {
      fit.Add(fragment.arc_px[k] - fragment.arc_px[j], raw[k].inverse_depth, raw[k].weight + 1e-9);
    };
    add(j);
    for (int k = j + 1; k < count && Connected(raw, k - 1, k) &&
                        fragment.arc_px[k] - fragment.arc_px[j] <= half_window_px;
         ++k) {
      add(k);
    }
    for (int k = j - 1; k >= 0 && Connected(raw, k, k + 1) &&
                        fragment.arc_px[j] - fragment.arc_px[k] <= half_window_px;
         --k) {
      add(k);
    }
    if (!fit.IsDetermined()) continue;
    (*depths)[j].slope_per_px = fit.Slope();
    (*depths)[j].inverse_depth = fit.AtZero();
  }
}

std::vector<VertexRun> FindRuns(const FragmentRays& fragment,
                                const std::vector<FusedDepth>& depths) {
  const int count = static_cast<int>(depths.size());
  std::vector<VertexRun> runs;
  if (count == 0) return runs;
  int start = 0;
  bool wraps = false;
  if (fragment.closed) {
    // Begin right after a break, so that no run is cut at the arbitrary first vertex.
    wraps = true;
    start = -1;
    for (int i = 0; i < count && start < 0; ++i) {
      if (!Connected(depths, i, (i + 1) % count)) start = (i + 1) % count;
    }
    if (start < 0) return {{0, count, true}};
  }
  int begin = -1;
  for (int k = 0; k < count; ++k) {
    const int i = wraps ? (start + k) % count : k;
    if (!depths[i].has_depth) {
      begin = -1;
      continue;
    }
    if (begin < 0) begin = k;
    const bool continues = k + 1 < count && Connected(depths, i, (i + 1) % count);
    if (continues) continue;
    const int first = wraps ? (start + begin) % count : begin;
    const int size = k - begin + 1;
    if (fragment.ArcTo(first + size - 1) - fragment.ArcTo(first) >= kMinPieceLengthPx) {
      runs.push_back({first, size, false});
    }
    begin = -1;
  }
  return runs;
}

Eigen::Vector3d TangentInCam(const PinholeCamera& camera, const FragmentRays& fragment, int vertex,
                             double inverse_depth, double slope_per_px) {
  const Eigen::Vector3d ray_tangent(fragment.tangents_px[vertex].x() / camera.fx,
                                    fragment.tangents_px[vertex].y() / camera.fy, 0);
  const double q = inverse_depth;
  return (ray_tangent / q - fragment.rays[vertex] * (slope_per_px / (q * q))).normalized();
}

Curve3D MakeCurve(const View& view, const FragmentRays& fragment,
                  const std::vector<FusedDepth>& depths, const VertexRun& run, int step) {
  Curve3D curve;
  curve.closed = run.closed;
  curve.anchor.begin = run.begin;
  curve.anchor.step = step;
  const int count = static_cast<int>(fragment.size());
  const Rigid3d world_from_cam = Inverse(view.cam_from_world);
  std::vector<double> arc, inverse_depth, weight;
  for (int k = 0; k < run.size; ++k) {
    const int i = (run.begin + k) % count;
    arc.push_back(fragment.ArcTo(run.begin + k) - fragment.ArcTo(run.begin));
    inverse_depth.push_back(depths[i].inverse_depth);
    weight.push_back(depths[i].weight + 1e-9);
  }
  const int num_samples = (run.size + step - 1) / step;
  curve.points_in_world.reserve(num_samples);
  curve.tangents_in_world.reserve(num_samples);
  curve.depth_sigma.reserve(num_samples);
  curve.certain.reserve(num_samples);
  const double focal = view.camera.MeanFocal();
  for (int k = 0; k < run.size; k += step) {
    const int i = (run.begin + k) % count;
    const double q = inverse_depth[k];
    const Eigen::Vector3d point = fragment.rays[i] / q;
    const Eigen::Vector3d tangent =
        TangentInCam(view.camera, fragment, i, q, FitSlope(arc, inverse_depth, weight, k));
    curve.points_in_world.push_back(world_from_cam * point);
    curve.tangents_in_world.push_back(world_from_cam.rotation * tangent);
    const double depth_weight = depths[i].weight;
    curve.depth_sigma.push_back(depth_weight > 0
                                    ? kEdgelSigmaPx / (q * focal * std::sqrt(depth_weight))
                                    : std::numeric_limits<double>::infinity());
    curve.certain.push_back(depths[i].certain);
  }
  return curve;
}

void CollectSupport(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                    const std::vector<std::unique_ptr<EdgelIndex>>& edgels,
                    const std::vector<ViewId>& candidate_views, const SupportGate& gate,
                    Curve3D* curve) {
  const CurveFragment& fragment = curves[curve->anchor.view].fragments[curve->anchor.fragment];
  std::vector<EdgelRef> of_sample;
  curve->support.offsets.reserve(curve->size() + 1);
  for (size_t s = 0; s < curve->size(); ++s) {
    of_sample.clear();
    const EdgelId own = fragment.edgel_ids[curve->anchor.VertexOf(s, fragment.edgel_ids.size())];
    of_sample.push_back({curve->anchor.view, own});
    for (const ViewId v : candidate_views) {
      const auto sight = See(views[v], curve->points_in_world[s], curve->tangents_in_world[s]);
      if (!sight) continue;
      const auto match = edgels[v]->Best(sight->position_px, sight->direction, gate);
      if (match) of_sample.push_back({v, match->edgel});
    }
    std::sort(of_sample.begin(), of_sample.end());
    curve->support.Append(of_sample);
  }
  curve->support.edgels.shrink_to_fit();
}

}  // namespace limn
