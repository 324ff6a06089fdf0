// SPDX-License-Identifier: BSD-3-Clause
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
// Those of another view agree by so much more than its own: they are exchanged.
constexpr double kOtherIsBetter = 0.1;
// Views, evenly spread, whose places are compared with the depths of all others.
constexpr size_t kMaxTested = 50, kMaxPlacesOfTested = 150;
// If those of more views do not fit, those of the others may by chance.
constexpr double kMaxUnfitShare = 0.5;

bool CanBeDoubted(const DepthAgreement& agreement) { return agreement.num_known >= kEnoughPlaces; }

double UsualAgreement(const std::vector<ViewDepthAgreement>& agreements) {
  std::vector<double> beyond_chance;
  for (const auto& [view, agreement] : agreements) {
    if (CanBeDoubted(agreement)) beyond_chance.push_back(agreement.BeyondChance());
  }
  return Median(beyond_chance);
}

DepthAgreement PooledOf(const std::vector<ViewDepthAgreement>& agreements,
                        const std::vector<ViewId>& without) {
  std::vector<DepthAgreement> pooled;
  for (const auto& [view, agreement] : agreements) {
    if (!std::binary_search(without.begin(), without.end(), view)) pooled.push_back(agreement);
  }
  return Pooled(pooled);
}

bool IsExchanged(const OwnAndOther& test) {
  return test.own && test.best_of >= 0 && test.best_other > *test.own + kOtherIsBetter;
}

}  // namespace

DepthWatch::DepthWatch(const SurelySeen& seen, const std::vector<View>& views, bool are_separate,
                       const DenseOptions& options)
    : seen_(seen), views_(views), are_separate_(are_separate), options_(options) {
  if (!are_separate) return;
  const size_t every = (views.size() + kMaxTested - 1) / kMaxTested;
  for (size_t v = 0; v < views.size(); v += every) {
    std::vector<SeenPlace> places = Thinned(seen.In(static_cast<ViewId>(v)), kMaxPlacesOfTested);
    if (places.size() < kEnoughPlaces) continue;
    tests_.push_back({.view = static_cast<ViewId>(v), .places = std::move(places)});
  }
}

void DepthWatch::Compare(ViewId view, const DepthImage& image) {
  agreements_.push_back({view, Agreement(seen_.In(view), views_[view], image, options_)});
  for (OwnAndOther& test : tests_) {
    const DepthAgreement agreement = Agreement(test.places, views_[test.view], image, options_);
    const double beyond_chance = agreement.BeyondChance();
    if (test.view == view) {
      if (CanBeDoubted(agreement)) test.own = beyond_chance;
    } else if (CanBeDoubted(agreement) && FitsOverall(agreement) &&
               beyond_chance > test.best_other) {
      test.best_other = beyond_chance;
      test.best_of = view;
    }
  }
}

DepthSource DepthWatch::Watched(const DepthSource& depths) {
  return [this, &depths](ViewId view) {
    std::optional<DepthImage> image = depths(view);
    if (image) Compare(view, *image);
    return image;
  };
}

std::vector<ViewId> DepthWatch::UnfitViews() const {
  const double least =
      std::max(kMinBeyondChanceOfView, kMinShareOfUsual * UsualAgreement(agreements_));
  std::vector<ViewId> unfit;
  for (const auto& [view, agreement] : agreements_) {
    const bool fits = !CanBeDoubted(agreement) || agreement.near >= kNearEverywhere ||
                      agreement.BeyondChance() >= least;
    const bool is_exchanged = std::any_of(
        tests_.begin(), tests_.end(),
        [view = view](const OwnAndOther& test) { return test.view == view && IsExchanged(test); });
    if (!fits || is_exchanged) unfit.push_back(view);
  }
  std::sort(unfit.begin(), unfit.end());
  return unfit;
}

DepthTrust DepthWatch::Judge() const {
  DepthTrust trust;
  trust.num_views = agreements_.size();
  if (agreements_.empty()) {
    trust.is_believed = false;
    trust.has_few_depths = true;
    return trust;
  }
  trust.agreement = PooledOf(agreements_, {});
  if (trust.agreement.num_places == 0) return trust;
  trust.has_few_depths = trust.agreement.known < kMinKnownShare;
  if (are_separate_) trust.unfit = UnfitViews();
  const auto exchanged = std::find_if(tests_.begin(), tests_.end(), IsExchanged);
  if (exchanged != tests_.end()) {
    trust.cause = {.kind = DepthCause::Kind::kOtherViews,
                   .depths_of = exchanged->best_of,
                   .fit_view = exchanged->view};
  }
  const bool most_fit = static_cast<double>(trust.unfit.size()) <=
                        kMaxUnfitShare * static_cast<double>(agreements_.size());
  trust.is_believed =
      !trust.has_few_depths && most_fit && FitsOverall(PooledOf(agreements_, trust.unfit));
  if (trust.is_believed) return trust;
  trust.unfit.clear();
  for (const auto& [view, agreement] : agreements_) trust.unfit.push_back(view);
  std::sort(trust.unfit.begin(), trust.unfit.end());
  return trust;
}

DepthSource Without(const std::vector<ViewId>& views, const DepthSource& depths) {
  return [&views, &depths](ViewId view) -> std::optional<DepthImage> {
    if (std::binary_search(views.begin(), views.end(), view)) return std::nullopt;
    return depths(view);
  };
}

void ExplainDoubts(const SurelySeen& seen, const std::vector<View>& views,
                   const DepthSource& depths, const DenseOptions& options, DepthTrust* trust) {
  if (trust->has_few_depths || trust->cause.kind != DepthCause::Kind::kUnknown) return;
  trust->cause = FindDepthCause(trust->unfit, seen, views, depths, options);
}

}  // namespace limn
