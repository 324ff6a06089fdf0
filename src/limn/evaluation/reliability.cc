// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/reliability.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ostream>

#include "limn/evaluation/curve_samples.h"
#include "limn/model/footprint.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Whether a drawn place counts, and is near the truth.
enum class Place : uint8_t { kIgnored, kWrong, kRight };

struct JudgedLinks {
  CurveSet curves;
  std::vector<double> confidence;  // per curve
};

JudgedLinks LinksWithConfidence(const DrawingGraph& drawing) {
  JudgedLinks links;
  for (const DrawingLink& link : drawing.links) {
    const bool is_outline = !link.IsAlongEdgels() || link.doubt == LinkDoubt::kRodOutline;
    if (link.confidence < 0 || is_outline) continue;
    links.curves.polylines.push_back(link.points_in_world);
    links.confidence.push_back(link.confidence);
  }
  return links;
}

ReliabilityBin& BinOf(double confidence, Reliability* reliability) {
  const int bin = static_cast<int>(confidence * kNumReliabilityBins);
  return reliability->bins[std::min(bin, kNumReliabilityBins - 1)];
}

}  // namespace

double Reliability::Length() const {
  double length = 0;
  for (const ReliabilityBin& bin : bins) length += bin.length;
  return length;
}

double Reliability::CalibrationError() const {
  double off = 0;
  for (const ReliabilityBin& bin : bins) off += std::abs(bin.told - bin.right);
  return off > 0 ? off / Length() : 0;
}

Reliability CompareConfidences(const DrawingGraph& drawing, const CurveSet& truth,
                               const CurveSet& dont_care, const std::vector<View>& views,
                               const ReliabilityOptions& options, const RunContext& context) {
  CheckOption(options.tau > 0, "tau", options.tau, "> 0");
  CheckOption(options.dont_care_taus >= 0, "dont_care_taus", options.dont_care_taus, ">= 0");
  const auto step_of = [&](const Polyline3d& polyline) {
    return options.tau / 4 * (views.empty() ? 1 : FootprintOfCurve(views, polyline));
  };
  const JudgedLinks links = LinksWithConfidence(drawing);
  const CurveSamples drawn(links.curves, step_of);
  Reliability reliability;
  reliability.tau = options.tau;
  if (drawn.size() == 0) return reliability;
  const CurveSamples true_places(truth, step_of);
  const CurveSamples forgiven(dont_care, step_of);
  std::vector<Place> places(drawn.size(), Place::kIgnored);
  ParallelFor(context, "confidences", places.size(), [&](size_t s) {
    const Eigen::Vector3d& place = drawn.Position(static_cast<int>(s));
    if (options.region && !options.region->contains(place)) return;
    const double reach = options.tau * (views.empty() ? 1 : PixelFootprint(views, place));
    if (forgiven.Distance(place) < options.dont_care_taus * reach) return;
    places[s] = true_places.Distance(place) <= reach ? Place::kRight : Place::kWrong;
  });
  for (int s = 0; s < drawn.size(); ++s) {
    if (places[s] == Place::kIgnored) continue;
    const double confidence = links.confidence[drawn.CurveOf(s)];
    ReliabilityBin& bin = BinOf(confidence, &reliability);
    const double length = drawn.Weight(s);
    bin.length += length;
    bin.told += length * confidence;
    if (places[s] == Place::kRight) bin.right += length;
  }
  return reliability;
}

void PrintReliability(const Reliability& reliability, std::ostream& out) {
  const double whole = reliability.Length();
  if (!(whole > 0)) return;
  char text[120];
  std::snprintf(text, sizeof(text),
                "confidences, right within %g: calibration error %.3f\n"
                "  confidence      told   right   share of the length\n",
                reliability.tau, reliability.CalibrationError());
  out << text;
  for (int b = 0; b < kNumReliabilityBins; ++b) {
    const ReliabilityBin& bin = reliability.bins[b];
    if (!(bin.length > 0)) continue;
    std::snprintf(text, sizeof(text), "  %.1f to %.1f   %7.3f %7.3f %7.3f\n",
                  static_cast<double>(b) / kNumReliabilityBins,
                  static_cast<double>(b + 1) / kNumReliabilityBins, bin.told / bin.length,
                  bin.right / bin.length, bin.length / whole);
    out << text;
  }
}

}  // namespace limn
