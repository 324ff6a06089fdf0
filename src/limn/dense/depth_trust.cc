#include "limn/dense/depth_trust.h"

#include <optional>

namespace limn {
namespace {

// Of the cells around the drawing: stereo that finds fewer depths has found nothing.
constexpr double kMinKnownShare = 0.05;
// If those of more views do not fit, those of the others may by chance.
constexpr double kMaxUnfitShare = 0.5;

}  // namespace

DepthJudge::DepthJudge(const SurelySeen& seen, const std::vector<View>& views,
                       const DepthSource& depths, bool are_separate, const DenseOptions& options)
    : seen_(seen),
      views_(views),
      depths_(depths),
      are_separate_(are_separate),
      options_(options) {}

bool DepthJudge::FitsAlone(const DepthAgreement& agreement) const {
  return !are_separate_ || FitsView(agreement);
}

DepthSource DepthJudge::FittingDepths() {
  return [this](ViewId view) -> std::optional<DepthImage> {
    std::optional<DepthImage> image = depths_(view);
    if (!image) return image;
    looked_at_.push_back({view, Agreement(seen_.In(view), views_[view], *image, options_)});
    if (!FitsAlone(looked_at_.back().agreement)) return std::nullopt;
    return image;
  };
}

DepthTrust DepthJudge::Conclude() const {
  DepthTrust trust;
  std::vector<DepthAgreement> all, fitting;
  std::vector<ViewId> with_places;
  for (const OfView& of_view : looked_at_) {
    all.push_back(of_view.agreement);
    if (of_view.agreement.num_known > 0) with_places.push_back(of_view.view);
    if (FitsAlone(of_view.agreement)) {
      fitting.push_back(of_view.agreement);
    } else {
      trust.unfit.push_back(of_view.view);
    }
  }
  trust.num_views = looked_at_.size();
  trust.agreement = Pooled(all);
  if (trust.agreement.num_places == 0) return trust;
  trust.has_few_depths = trust.agreement.known < kMinKnownShare;
  const bool most_fit = static_cast<double>(trust.unfit.size()) <=
                        kMaxUnfitShare * static_cast<double>(with_places.size());
  trust.is_believed = !trust.has_few_depths && most_fit && FitsOverall(Pooled(fitting));
  if (trust.has_few_depths) return trust;
  trust.cause = FindDepthCause(trust.is_believed ? trust.unfit : with_places, seen_, views_,
                               depths_, options_);
  return trust;
}

}  // namespace limn
