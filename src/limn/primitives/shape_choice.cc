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

// Fewer parameters first: a later one must be better.
bool IsBetter(const FittedShape& a, const FittedShape& b, double tolerance) {
  const bool a_explains = a.max_px <= tolerance;
  const bool b_explains = b.max_px <= tolerance;
  if (a_explains != b_explains) return a_explains;
  return a_explains ? a.criterion < b.criterion : a.max_px < b.max_px;
}

FittedShape BestSpline(const LinkSamples& link, const EndConditions& ends, bool closed,
                       const PrimitiveOptions& options) {
  // Stop after this many steps without improvement.
  constexpr int kPatience = 2;
  std::vector<double> knots = UniformKnots(closed ? kFirstClosedSpans : 1);
  std::optional<FittedShape> best;
  for (int worse = 0; !knots.empty() && worse < kPatience;) {
    const CubicBSpline spline = FitSpline(link, ends, closed, knots);
    FittedShape fitted = Judge(spline, NumParameters(spline, ends, closed), link, options);
    if (!best || IsBetter(fitted, *best, options.max_residual_px)) {
      best = std::move(fitted);
      worse = 0;
    } else {
      ++worse;
    }
    if (knots.size() > kMaxSpans + 7) break;
    knots = MoreKnots(knots, DeviationsPx(spline, link), link, options.max_residual_px);
  }
  return *best;
}

}  // namespace

FittedShape Judge(const CurveShape& shape, int num_parameters, const LinkSamples& link,
                  const PrimitiveOptions& options) {
  const ShapeResidual residual = ResidualOf(shape, link);
  FittedShape fitted = {shape, residual.RmsPx(), residual.max_px};
  const double num_independent = std::max(link.length_px / kCurveCorrelationPx, 2.0);
  fitted.criterion =
      num_independent * residual.mean_square / (options.noise_px * options.noise_px) +
      num_parameters * std::log(num_independent);
  return fitted;
}

int NumParameters(const CubicBSpline& spline, const EndConditions& ends, bool closed) {
  const int num_points = static_cast<int>(spline.control_points.size());
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
  std::vector<FittedShape> candidates;
  if (closed) {
    const bool held = ends[0].held;
    if (const auto circle = FitCircle(link, held)) {
      candidates.push_back(Judge(*circle, held ? 4 : 6, link, options));
    }
  } else {
    const int num_free = 3 * (!ends[0].held + !ends[1].held);
    const LineSegment line = FitLine(link, ends);
    if (ValidateShape(line).empty()) candidates.push_back(Judge(line, num_free, link, options));
    if (const auto arc = FitArc(link, ends)) {
      candidates.push_back(Judge(*arc, num_free + 2, link, options));
    }
  }
  candidates.push_back(BestSpline(link, ends, closed, options));
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](const FittedShape& a, const FittedShape& b) {
                             return IsBetter(a, b, options.max_residual_px);
                           });
}

}  // namespace limn
