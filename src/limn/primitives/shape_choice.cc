// SPDX-License-Identifier: BSD-3-Clause
#include "limn/primitives/shape_choice.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr int kMaxSpans = 64;
// A span of a spline needs this many samples.
constexpr double kMinSamplesPerSpan = 3;
// A closed spline needs some control points that are not of its joint.
constexpr int kFirstClosedSpans = 4;

std::vector<double> UniformKnots(int num_spans) {
  std::vector<double> knots(4, 0.0);
  for (int k = 1; k < num_spans; ++k) knots.push_back(static_cast<double>(k) / num_spans);
  knots.insert(knots.end(), 4, 1.0);
  return knots;
}

// Spans that deviate too much are halved; if none does, the one that deviates most in all. Nothing
// if no such span has enough samples.
std::vector<double> MoreKnots(const std::vector<double>& knots,
                              const std::vector<double>& deviation, const LinkSamples& link,
                              double tolerance) {
  struct Span {
    double begin, end, sum, max;
    int count;
  };
  std::vector<Span> spans;
  for (size_t k = 3; k + 4 < knots.size(); ++k) {
    Span span = {knots[k], knots[k + 1], 0, 0, 0};
    for (size_t s = 0; s < deviation.size(); ++s) {
      const double t = link.samples[s].t;
      if (t < span.begin || t > span.end) continue;
      span.sum += link.samples[s].weight * deviation[s] * deviation[s];
      if (link.samples[s].weight == 1) span.max = std::max(span.max, deviation[s]);
      ++span.count;
    }
    if (span.count >= 2 * kMinSamplesPerSpan) spans.push_back(span);
  }
  if (spans.empty()) return {};
  const auto worst = std::max_element(spans.begin(), spans.end(),
                                      [](const Span& a, const Span& b) { return a.sum < b.sum; });
  std::vector<double> more = knots;
  for (const Span& span : spans) {
    if (span.max > tolerance || &span == &*worst) more.push_back((span.begin + span.end) / 2);
  }
  std::sort(more.begin(), more.end());
  return more;
}

double NumIndependent(const LinkSamples& link) {
  return std::max(link.length_px / kCurveCorrelationPx, 2.0);
}

// Fewer parameters first: a later one must be better.
bool IsBetter(const FittedShape& a, const FittedShape& b, double tolerance) {
  const bool a_explains = a.max_px <= tolerance;
  const bool b_explains = b.max_px <= tolerance;
  if (a_explains != b_explains) return a_explains;
  return a_explains ? a.criterion < b.criterion : a.max_px < b.max_px;
}

// The best shape so far.
class ShapeContest {
 public:
  ShapeContest(const LinkSamples& link, const PrimitiveOptions& options)
      : link_(link), options_(options) {}

  // Whether a shape with so many parameters could be the best, if it fitted exactly. One with more
  // could not if this one cannot.
  bool CanWin(int num_parameters) const {
    return !best_ || best_->max_px > options_.max_residual_px ||
           num_parameters * std::log(NumIndependent(link_)) < best_->criterion;
  }

  void Enter(const CurveShape& shape, int num_parameters) {
    Enter(Judge(shape, num_parameters, link_, options_));
  }

  // Returns whether it is the best.
  bool Enter(FittedShape fitted) {
    if (best_ && !IsBetter(fitted, *best_, options_.max_residual_px)) return false;
    best_ = std::move(fitted);
    return true;
  }

  const FittedShape& best() const { return *best_; }

 private:
  const LinkSamples& link_;
  const PrimitiveOptions& options_;
  std::optional<FittedShape> best_;
};

void EnterSplines(const LinkSamples& link, const EndConditions& ends, bool closed,
                  const PrimitiveOptions& options, ShapeContest* contest) {
  // Stop after this many steps without improvement.
  constexpr int kPatience = 2;
  std::vector<double> knots = UniformKnots(closed ? kFirstClosedSpans : 1);
  ShapeContest splines(link, options);
  for (int worse = 0; !knots.empty() && worse < kPatience;) {
    const int num_parameters = NumParameters(static_cast<int>(knots.size()) - 4, ends, closed);
    if (!contest->CanWin(num_parameters)) return;
    const CubicBSpline spline = FitSpline(link, ends, closed, knots);
    FittedShape fitted = Judge(spline, num_parameters, link, options);
    contest->Enter(fitted);
    worse = splines.Enter(std::move(fitted)) ? 0 : worse + 1;
    if (knots.size() > kMaxSpans + 7) return;
    knots = MoreKnots(knots, DeviationsPx(spline, link), link, options.max_residual_px);
  }
}

}  // namespace

FittedShape Judge(const CurveShape& shape, int num_parameters, const LinkSamples& link,
                  const PrimitiveOptions& options) {
  const ShapeResidual residual = ResidualOf(shape, link);
  FittedShape fitted = {shape, residual.RmsPx(), residual.max_px};
  const double num_independent = NumIndependent(link);
  fitted.criterion =
      num_independent * residual.mean_square / (options.noise_px * options.noise_px) +
      num_parameters * std::log(num_independent);
  return fitted;
}

int NumParameters(int num_points, const EndConditions& ends, bool closed) {
  int count = 3 * num_points + (num_points - 4) - (closed ? 3 : 0);
  for (const int end : {0, 1}) {
    // Both ends of a closed one are the same.
    if (ends[end].held && !(closed && end == 1)) count -= 3;
    if (ends[end].direction) count -= 2;
  }
  return count;
}

FittedShape ChooseShape(const LinkSamples& link, const EndConditions& ends, bool closed,
                        const PrimitiveOptions& options) {
  ShapeContest contest(link, options);
  if (closed) {
    const bool held = ends[0].held;
    if (const auto circle = FitCircle(link, held)) contest.Enter(*circle, held ? 4 : 6);
  } else {
    const int num_free = 3 * (!ends[0].held + !ends[1].held);
    const LineSegment line = FitLine(link, ends);
    if (ValidateShape(line).empty()) contest.Enter(line, num_free);
    if (contest.CanWin(num_free + 2)) {
      if (const auto arc = FitArc(link, ends)) contest.Enter(*arc, num_free + 2);
    }
  }
  EnterSplines(link, ends, closed, options, &contest);
  return contest.best();
}

}  // namespace limn
