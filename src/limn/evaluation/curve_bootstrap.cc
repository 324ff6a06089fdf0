// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/curve_bootstrap.h"

#include <algorithm>
#include <cstdint>
#include <random>

#include "limn/util/random_index.h"

namespace limn {
namespace {

constexpr int kNumResamples = 500;
constexpr double kTail = 0.025;
constexpr uint64_t kSeed = 1;

std::vector<CurveShare> OfPositiveTotal(std::vector<CurveShare> curves) {
  std::erase_if(curves, [](const CurveShare& curve) { return !(curve.total > 0); });
  return curves;
}

// The share of each resample; empty if there are too few curves.
std::vector<double> Resample(std::vector<CurveShare> all, std::mt19937_64* random) {
  const std::vector<CurveShare> curves = OfPositiveTotal(std::move(all));
  if (curves.size() < 2) return {};
  std::vector<double> shares;
  for (int i = 0; i < kNumResamples; ++i) {
    CurveShare sum;
    for (size_t k = 0; k < curves.size(); ++k) {
      const CurveShare& curve =
          curves[RandomIndex(static_cast<uint32_t>((*random)() >> 32), curves.size())];
      sum.right += curve.right;
      sum.total += curve.total;
    }
    shares.push_back(sum.right / sum.total);
  }
  return shares;
}

std::optional<Interval> MiddleOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const size_t num_tail = static_cast<size_t>(kTail * values.size());
  return Interval{values[num_tail], values[values.size() - 1 - num_tail]};
}

}  // namespace

ShareIntervals BootstrapShares(const std::vector<CurveShare>& links,
                               const std::vector<CurveShare>& true_curves) {
  std::mt19937_64 random(kSeed);
  const std::vector<double> precisions = Resample(links, &random);
  const std::vector<double> recalls = Resample(true_curves, &random);
  std::vector<double> fs;
  if (!precisions.empty() && !recalls.empty()) {
    for (int i = 0; i < kNumResamples; ++i) {
      const double sum = precisions[i] + recalls[i];
      fs.push_back(sum > 0 ? 2 * precisions[i] * recalls[i] / sum : 0.0);
    }
  }
  return {MiddleOf(precisions), MiddleOf(recalls), MiddleOf(std::move(fs))};
}

}  // namespace limn
