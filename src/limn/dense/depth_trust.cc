#include "limn/dense/depth_trust.h"

#include <algorithm>
#include <optional>

#include "limn/util/median.h"

namespace limn {
namespace {

// Of the cells around the drawing: stereo that finds fewer depths has found nothing.
constexpr double kMinKnownShare = 0.05;
// Depths of a view do not fit if they agree, beyond chance, by less than the first, or than this
// share of what is usual; unless they are near the drawing nearly everywhere.
constexpr double kMinBeyondChanceOfView = 0.25, kMinShareOfUsual = 0.6, kNearEverywhere = 0.8;
// If those of more views do not fit, those of the others may by chance.
constexpr double kMaxUnfitShare = 0.5;

bool CanBeDoubted(const DepthAgreement& agreement) { return agreement.num_known >= kEnoughPlaces; }

double UsualAgreement(const std::vector<ViewAgreement>& agreements) {
  std::vector<double> beyond_chance;
  for (const auto& [view, agreement] : agreements) {
    if (CanBeDoubted(agreement)) beyond_chance.push_back(agreement.BeyondChance());
  }
  return Median(beyond_chance);
}

DepthAgreement PooledOf(const std::vector<ViewAgreement>& agreements,
                        const std::vector<ViewId>& without) {
  std::vector<DepthAgreement> pooled;
  for (const auto& [view, agreement] : agreements) {
    if (!std::binary_search(without.begin(), without.end(), view)) pooled.push_back(agreement);
  }
  return Pooled(pooled);
}

std::vector<ViewId> UnfitViews(const std::vector<ViewAgreement>& agreements) {
  const double least =
      std::max(kMinBeyondChanceOfView, kMinShareOfUsual * UsualAgreement(agreements));
  std::vector<ViewId> unfit;
  for (const auto& [view, agreement] : agreements) {
    const bool fits = !CanBeDoubted(agreement) || agreement.near >= kNearEverywhere ||
                      agreement.BeyondChance() >= least;
    if (!fits) unfit.push_back(view);
  }
  std::sort(unfit.begin(), unfit.end());
  return unfit;
}

}  // namespace

DepthSource Watched(const DepthSource& depths, const SurelySeen& seen,
                    const std::vector<View>& views, const DenseOptions& options,
                    std::vector<ViewAgreement>* agreements) {
  return [&depths, &seen, &views, options, agreements](ViewId view) {
    std::optional<DepthImage> image = depths(view);
    if (image) {
      agreements->push_back({view, Agreement(seen.In(view), views[view], *image, options)});
    }
    return image;
  };
}

DepthSource Without(const std::vector<ViewId>& views, const DepthSource& depths) {
  return [&views, &depths](ViewId view) -> std::optional<DepthImage> {
    if (std::binary_search(views.begin(), views.end(), view)) return std::nullopt;
    return depths(view);
  };
}

DepthTrust JudgeDepths(const std::vector<ViewAgreement>& agreements, bool are_separate) {
  DepthTrust trust;
  trust.num_views = agreements.size();
  trust.agreement = PooledOf(agreements, {});
  if (trust.agreement.num_places == 0) return trust;
  trust.has_few_depths = trust.agreement.known < kMinKnownShare;
  if (are_separate) trust.unfit = UnfitViews(agreements);
  const bool most_fit = static_cast<double>(trust.unfit.size()) <=
                        kMaxUnfitShare * static_cast<double>(agreements.size());
  trust.is_believed =
      !trust.has_few_depths && most_fit && FitsOverall(PooledOf(agreements, trust.unfit));
  if (trust.is_believed) return trust;
  trust.unfit.clear();
  for (const auto& [view, agreement] : agreements) trust.unfit.push_back(view);
  std::sort(trust.unfit.begin(), trust.unfit.end());
  return trust;
}

void ExplainDoubts(const SurelySeen& seen, const std::vector<View>& views,
                   const DepthSource& depths, const DenseOptions& options, DepthTrust* trust) {
  if (trust->has_few_depths) return;
  trust->cause = FindDepthCause(trust->unfit, seen, views, depths, options);
}

}  // namespace limn
