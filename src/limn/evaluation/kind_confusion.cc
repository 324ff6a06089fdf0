// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/kind_confusion.h"

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <ostream>

#include "limn/evaluation/curve_samples.h"
#include "limn/model/footprint.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr std::array<LinkKind, kNumLinkKinds> kOrder = {
    LinkKind::kEdge, LinkKind::kPaint,   LinkKind::kShadow, LinkKind::kContour,
    LinkKind::kRod,  LinkKind::kTexture, LinkKind::kUnknown};

class NearestKind {
 public:
  NearestKind(const CurvesByKind& truth, const std::vector<View>& views, double tau) {
    for (const CurveSet& set : truth) {
      samples_.emplace_back(set, [&](const Polyline3d& polyline) {
        return tau / 4 * (views.empty() ? 1 : FootprintOfCurve(views, polyline));
      });
    }
  }

  LinkKind At(const Eigen::Vector3d& place, double reach) const {
    const LinkKind first = NearestOf({LinkKind::kEdge, LinkKind::kPaint, LinkKind::kRod}, place);
    if (Distance(first, place) <= reach) return first;
    const LinkKind second = NearestOf({LinkKind::kShadow, LinkKind::kContour}, place);
    return Distance(second, place) <= reach ? second : LinkKind::kUnknown;
  }

 private:
  LinkKind NearestOf(std::initializer_list<LinkKind> kinds, const Eigen::Vector3d& place) const {
    return *std::ranges::min_element(kinds, {},
                                     [&](LinkKind kind) { return Distance(kind, place); });
  }
  double Distance(LinkKind kind, const Eigen::Vector3d& place) const {
    return samples_[static_cast<int>(kind)].Distance(place);
  }

  std::vector<CurveSamples> samples_;
};

}  // namespace

KindConfusion CompareKinds(const DrawingGraph& drawing, const CurvesByKind& truth,
                           const std::vector<View>& views, const KindConfusionOptions& options) {
  CheckOption(options.tau > 0, "tau", options.tau, "> 0");
  const NearestKind nearest(truth, views, options.tau);
  KindConfusion confusion;
  confusion.tau = options.tau;
  const auto footprint_at = [&](const Eigen::Vector3d& place) {
    return views.empty() ? 1 : PixelFootprint(views, place);
  };
  const CurveSet links = ToCurveSet(drawing);
  const CurveSamples samples(links, [&](const Polyline3d& polyline) {
    return options.tau / 4 * (views.empty() ? 1 : FootprintOfCurve(views, polyline));
  });
  for (int s = 0; s < samples.size(); ++s) {
    const Eigen::Vector3d& place = samples.Position(s);
    if (options.region && !options.region->contains(place)) continue;
    const LinkKind true_kind = nearest.At(place, options.tau * footprint_at(place));
    const LinkKind kind = drawing.links[samples.CurveOf(s)].kind;
    confusion.length[static_cast<int>(true_kind)][static_cast<int>(kind)] += samples.Weight(s);
  }
  return confusion;
}

void PrintKindConfusion(const KindConfusion& confusion, std::ostream& out) {
  char text[80];
  std::snprintf(text, sizeof(text), "drawn length by kind of the true curve within %g\n",
                confusion.tau);
  out << text << "  true \\ drawn";
  for (const LinkKind kind : kOrder) {
    std::snprintf(text, sizeof(text), " %9s", LinkKindName(kind));
    out << text;
  }
  out << '\n';
  for (const LinkKind true_kind : kOrder) {
    const char* name = true_kind == LinkKind::kUnknown ? "none" : LinkKindName(true_kind);
    std::snprintf(text, sizeof(text), "  %-12s", name);
    out << text;
    for (const LinkKind kind : kOrder) {
      std::snprintf(text, sizeof(text), " %9.3f",
                    confusion.length[static_cast<int>(true_kind)][static_cast<int>(kind)]);
      out << text;
    }
    out << '\n';
  }
}

}  // namespace limn
