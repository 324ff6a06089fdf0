#include "limn/belief/confidence.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Weights of the regression; for how they were found see algorithm/belief.md#what-was-measured.
constexpr double kBase = -0.37;
constexpr double kPerEvidence = 0.075;
constexpr double kPerFreeEnd = -0.70;
constexpr double kPerLogViews = 1.16;
constexpr double kPerLogSure = 1.21;
// More evidence than this makes nothing surer.
constexpr double kMaxEvidence = 20;
// Keeps the logarithm of the sure share finite.
constexpr double kLeastSureShare = 0.02;

}  // namespace

double ConfidenceOf(const LinkFacts& facts, double sure_share) {
  const double log_odds = kBase + kPerEvidence * std::min(facts.evidence, kMaxEvidence) +
                          kPerFreeEnd * facts.num_free +
                          kPerLogViews * std::log1p(facts.showing_views) +
                          kPerLogSure * std::log(sure_share + kLeastSureShare);
  return 1 / (1 + std::exp(-log_odds));
}

}  // namespace limn
