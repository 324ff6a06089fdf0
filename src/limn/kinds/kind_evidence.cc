// SPDX-License-Identifier: BSD-3-Clause
#include "limn/kinds/kind_evidence.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace limn {
namespace {

// Width of a sharp step in a photograph: pixels, demosaicing and sampling. Used where a view has
// too few profiles to tell.
constexpr float kSharpWidthPx = 0.68F;
constexpr size_t kMinProfilesForReference = 20;
constexpr size_t kNumDepths = 3;
// Share of the profiles of a view that are sharper than its reference.
constexpr double kSharpShare = 0.25;
// Added to linear intensities, which are 0 to 1, before the logarithm: noise of dark sides.
constexpr float kDark = 2e-3F;

// Fewer places do not tell how even a link is.
constexpr size_t kMinPlacesForUnevenness = 4;

using LogColor = std::array<float, 3>;

float Quantile(std::vector<float>* values, double share) {
  const auto at = values->begin() +
                  static_cast<std::ptrdiff_t>(share * static_cast<double>(values->size() - 1));
  std::nth_element(values->begin(), at, values->end());
  return *at;
}

LogColor LogOf(const SideColor& color) {
  LogColor result;
  for (int c = 0; c < 3; ++c) {
    const float value = std::clamp(color[c] / 255, 0.0F, 1.0F);  // sRGB
    const float linear =
        value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
    result[c] = std::log(linear + kDark);
  }
  return result;
}

LogColor MedianOf(const std::vector<LogColor>& colors) {
  LogColor median;
  std::vector<float> values(colors.size());
  for (int c = 0; c < 3; ++c) {
    std::transform(colors.begin(), colors.end(), values.begin(),
                   [c](const LogColor& color) { return color[c]; });
    median[c] = Quantile(&values, 0.5);
  }
  return median;
}

// How much colors differ, one per view.
double SpreadOf(const std::vector<LogColor>& colors) {
  const LogColor middle = MedianOf(colors);
  std::vector<float> deviations;
  for (const LogColor& color : colors) {
    float largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(color[c] - middle[c]));
    deviations.push_back(largest);
  }
  return Quantile(&deviations, 0.5);
}

// Median difference of neighbors in the list of medians per place; places without values are
// skipped.
double UnevennessOf(std::vector<std::vector<float>>* values_of_place) {
  std::vector<float> medians;
  for (std::vector<float>& values : *values_of_place) {
    if (!values.empty()) medians.push_back(Quantile(&values, 0.5));
  }
  if (medians.size() < kMinPlacesForUnevenness) return std::numeric_limits<double>::infinity();
  std::vector<float> differences;
  for (size_t k = 1; k < medians.size(); ++k) {
    differences.push_back(std::abs(medians[k] - medians[k - 1]));
  }
  return Quantile(&differences, 0.5);
}

// Widths of sharp edges in a view, by depth.
class SharpWidths {
 public:
  explicit SharpWidths(const std::vector<LinkProfile>& profiles) {
    std::vector<float> depths;
    for (const LinkProfile& profile : profiles) depths.push_back(profile.depth);
    if (depths.empty()) return;
    for (size_t k = 1; k < kNumDepths; ++k) {
      limits_.push_back(Quantile(&depths, static_cast<double>(k) / kNumDepths));
    }
    std::vector<float> all;
    std::vector<std::vector<float>> at_depth(kNumDepths);
    for (const LinkProfile& profile : profiles) {
      all.push_back(profile.profile.width_px);
      at_depth[IndexOf(profile.depth)].push_back(profile.profile.width_px);
    }
    const float of_view = WidthOf(&all, kSharpWidthPx);
    for (std::vector<float>& widths : at_depth) widths_.push_back(WidthOf(&widths, of_view));
  }

  float At(float depth) const { return widths_[IndexOf(depth)]; }

 private:
  static float WidthOf(std::vector<float>* widths, float otherwise) {
    return widths->size() < kMinProfilesForReference ? otherwise : Quantile(widths, kSharpShare);
  }
  size_t IndexOf(float depth) const {
    return std::upper_bound(limits_.begin(), limits_.end(), depth) - limits_.begin();
  }

  std::vector<float> limits_;
  std::vector<float> widths_;
};

LogColor Combined(const LogColor& a, const LogColor& b, float weight_a, float weight_b) {
  LogColor sum;
  for (int c = 0; c < 3; ++c) sum[c] = weight_a * a[c] + weight_b * b[c];
  return sum;
}

// Calls `visit` with the profiles of each link; those of one link are together.
template <typename Visit>
void ForEachLink(const std::vector<LinkProfile>& profiles, const Visit& visit) {
  for (size_t begin = 0, end = 0; begin < profiles.size(); begin = end) {
    for (end = begin + 1; end < profiles.size() && profiles[end].link == profiles[begin].link;)
      ++end;
    visit(std::span(profiles).subspan(begin, end - begin));
  }
}

// Exposure and white balance of each view, as logarithms: how much brighter it shows what other
// views show, too, the median over the links.
std::vector<LogColor> ExposuresOf(size_t num_links,
                                  const std::vector<std::vector<LinkProfile>>& profiles_of_view) {
  struct Shown {
    size_t view = 0;
    LogColor color = {};  // mean of both sides
  };
  std::vector<std::vector<Shown>> shown(num_links);
  for (size_t v = 0; v < profiles_of_view.size(); ++v) {
    std::vector<LogColor> colors;
    ForEachLink(profiles_of_view[v], [&](std::span<const LinkProfile> profiles) {
      colors.clear();
      for (const LinkProfile& profile : profiles) {
        const LogColor left = LogOf(profile.profile.left);
        const LogColor right = LogOf(profile.profile.right);
        colors.push_back(Combined(left, right, 0.5F, 0.5F));
      }
      shown[profiles.front().link].push_back({v, MedianOf(colors)});
    });
  }
  std::vector<std::vector<LogColor>> brighter(profiles_of_view.size());
  for (const std::vector<Shown>& link : shown) {
    if (link.size() < 2) continue;
    std::vector<LogColor> colors;
    for (const Shown& one : link) colors.push_back(one.color);
    const LogColor middle = MedianOf(colors);
    for (const Shown& one : link) brighter[one.view].push_back(Combined(one.color, middle, 1, -1));
  }
  std::vector<LogColor> exposures(profiles_of_view.size(), LogColor{});
  for (size_t v = 0; v < brighter.size(); ++v) {
    if (!brighter[v].empty()) exposures[v] = MedianOf(brighter[v]);
  }
  return exposures;
}

// Gathers the profiles of one link, view by view.
class Gatherer {
 public:
  void Add(const LinkProfile& at_place, float sharp_width_px) {
    const EdgeProfile& profile = at_place.profile;
    LogColor brighter = LogOf(profile.left);
    LogColor darker = LogOf(profile.right);
    float change_of_all = 0;
    for (int c = 0; c < 3; ++c) change_of_all += brighter[c] - darker[c];
    if (change_of_all < 0) std::swap(brighter, darker);
    LogColor change;
    LogColor chroma;
    for (int c = 0; c < 3; ++c) {
      change[c] = brighter[c] - darker[c];
      chroma[c] = change[c] - std::abs(change_of_all) / 3;
    }
    here_.change.push_back(change);
    here_.darker.push_back(darker);
    here_.brighter.push_back(brighter);
    chroma_.push_back(chroma);
    ratios_.push_back(profile.width_px / sharp_width_px);
    const auto place = static_cast<size_t>(at_place.place);
    if (place >= changes_of_place_.size()) changes_of_place_.resize(place + 1);
    changes_of_place_[place].push_back(std::abs(change_of_all) / 3);
  }

  void EndView(const LogColor& exposure) {
    if (here_.change.empty()) return;
    exposures_.push_back(exposure);
    views_.change.push_back(MedianOf(here_.change));
    views_.darker.push_back(MedianOf(here_.darker));
    views_.brighter.push_back(MedianOf(here_.brighter));
    here_ = {};
  }

  KindEvidence Evidence() {
    KindEvidence evidence;
    evidence.num_profiles = static_cast<int>(ratios_.size());
    evidence.num_views = static_cast<int>(views_.change.size());
    if (ratios_.empty()) return evidence;
    evidence.blur_ratio = Quantile(&ratios_, 0.5);
    for (const float value : MedianOf(chroma_)) {
      evidence.chroma_change = std::max(evidence.chroma_change, double{std::abs(value)});
    }
    evidence.unevenness = UnevennessOf(&changes_of_place_);
    evidence.change_spread = SpreadOf(views_.change);
    evidence.darker_spread = SpreadOf(views_.darker);
    evidence.brighter_spread = SpreadOf(views_.brighter);
    evidence.steadier_spread_exposed =
        std::min(SpreadOf(Exposed(views_.darker)), SpreadOf(Exposed(views_.brighter)));
    return evidence;
  }

 private:
  struct Sides {
    std::vector<LogColor> change;
    std::vector<LogColor> darker;
    std::vector<LogColor> brighter;
  };
  // Colors of the views as with the same exposure.
  std::vector<LogColor> Exposed(std::vector<LogColor> colors) const {
    for (size_t v = 0; v < colors.size(); ++v) {
      colors[v] = Combined(colors[v], exposures_[v], 1, -1);
    }
    return colors;
  }

  Sides here_;                       // per profile of this view
  Sides views_;                      // per view
  std::vector<LogColor> exposures_;  // per view
  std::vector<LogColor> chroma_;
  std::vector<float> ratios_;
  std::vector<std::vector<float>> changes_of_place_;
};

}  // namespace

std::vector<KindEvidence> GatherEvidence(
    size_t num_links, const std::vector<std::vector<LinkProfile>>& profiles_of_view) {
  const std::vector<LogColor> exposures = ExposuresOf(num_links, profiles_of_view);
  std::vector<Gatherer> gatherers(num_links);
  for (size_t v = 0; v < profiles_of_view.size(); ++v) {
    const std::vector<LinkProfile>& profiles = profiles_of_view[v];
    const SharpWidths sharp(profiles);
    ForEachLink(profiles, [&](std::span<const LinkProfile> of_link) {
      Gatherer& gatherer = gatherers[of_link.front().link];
      for (const LinkProfile& profile : of_link) gatherer.Add(profile, sharp.At(profile.depth));
      gatherer.EndView(exposures[v]);
    });
  }
  std::vector<KindEvidence> evidence;
  evidence.reserve(num_links);
  for (Gatherer& gatherer : gatherers) evidence.push_back(gatherer.Evidence());
  return evidence;
}

}  // namespace limn
