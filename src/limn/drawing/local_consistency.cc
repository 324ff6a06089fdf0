#include "limn/drawing/local_consistency.h"

#include <algorithm>
#include <cmath>

#include "limn/util/map_items.h"

namespace limn {
namespace {

// Edgels of one view farther apart than this across the edge belong to different edges, px.
constexpr double kSideBySidePx = 1;

// Per view, the samples that each edgel supports, back to back.
struct EdgelClaims {
  std::vector<uint32_t> begin;
  std::vector<int> samples;
};

std::vector<EdgelClaims> CollectClaims(const SampleSet& samples,
                                       const std::vector<ImageCurves>& curves) {
  std::vector<EdgelClaims> claims(curves.size());
  for (size_t v = 0; v < curves.size(); ++v) {
    claims[v].begin.assign(curves[v].edge_map.edgels.size() + 1, 0);
  }
  for (const EdgelRef& ref : samples.support.edgels) ++claims[ref.view].begin[ref.edgel + 1];
  for (EdgelClaims& of_view : claims) {
    for (size_t i = 1; i < of_view.begin.size(); ++i) of_view.begin[i] += of_view.begin[i - 1];
    of_view.samples.resize(of_view.begin.back());
  }
  std::vector<std::vector<uint32_t>> next;
  for (const EdgelClaims& of_view : claims) next.push_back(of_view.begin);
  for (int s = 0; s < samples.NumSamples(); ++s) {
    for (const EdgelRef& ref : samples.support.Of(s)) {
      claims[ref.view].samples[next[ref.view][ref.edgel]++] = s;
    }
  }
  return claims;
}

// Views in which the two samples are supported by different edgels that lie side by side.
int CountSideBySide(const SampleSet& samples, const std::vector<ImageCurves>& curves, int a,
                    int b) {
  int count = 0;
  const auto support_a = samples.support.Of(a);
  const auto support_b = samples.support.Of(b);
  for (size_t i = 0, j = 0; i < support_a.size() && j < support_b.size();) {
    if (support_a[i].view < support_b[j].view) {
      ++i;
    } else if (support_b[j].view < support_a[i].view) {
      ++j;
    } else {
      const auto& edgels = curves[support_a[i].view].edge_map.edgels;
      const Edgel& edgel_a = edgels[support_a[i].edgel];
      const Edgel& edgel_b = edgels[support_b[j].edgel];
      const Eigen::Vector2d offset =
          edgel_a.stored_from_virtual.cast<double>() * (edgel_b.position_px - edgel_a.position_px);
      count += std::abs(edgel_a.Normal().dot(offset)) > kSideBySidePx;
      ++i;
      ++j;
    }
  }
  return count;
}

class LinkFinder {
 public:
  LinkFinder(const SampleSet& samples, const std::vector<ImageCurves>& curves,
             const std::vector<EdgelClaims>& claims, const DrawingOptions& options)
      : samples_(samples),
        curves_(curves),
        claims_(claims),
        options_(options),
        min_cosine_(std::cos(options.max_link_angle_deg * M_PI / 180)) {}

  std::vector<SampleLink> LinksOf(int s) const {
    std::vector<int> others;
    const int curve = samples_.curve_of[s];
    const ViewId anchor = samples_.origins[curve].anchor_view;
    for (const EdgelRef& ref : samples_.support.Of(s)) {
      const EdgelClaims& claims = claims_[ref.view];
      for (size_t i = claims.begin[ref.edgel]; i < claims.begin[ref.edgel + 1]; ++i) {
        const int other = claims.samples[i];
        if (samples_.origins[samples_.curve_of[other]].anchor_view != anchor) {
          others.push_back(other);
        }
      }
    }
    std::sort(others.begin(), others.end());
    std::vector<SampleLink> best;  // per other curve, whose sample ids are consecutive
    for (size_t i = 0; i < others.size();) {
      size_t j = i;
      while (j < others.size() && others[j] == others[i]) ++j;
      const SampleLink link{others[i], static_cast<int>(j - i)};
      i = j;
      if (link.votes < options_.dense_link_views) continue;
      if (std::abs(samples_.tangent[s].dot(samples_.tangent[link.other])) < min_cosine_) continue;
      const bool same_curve =
          !best.empty() && samples_.curve_of[best.back().other] == samples_.curve_of[link.other];
      if (!same_curve) {
        best.push_back(link);
      } else if (Better(s, link, best.back())) {
        best.back() = link;
      }
    }
    std::erase_if(best, [&](const SampleLink& link) {
      return CountSideBySide(samples_, curves_, s, link.other) >= link.votes;
    });
    return best;
  }

 private:
  bool Better(int s, const SampleLink& a, const SampleLink& b) const {
    if (a.votes != b.votes) return a.votes > b.votes;
    return (samples_.position[a.other] - samples_.position[s]).squaredNorm() <
           (samples_.position[b.other] - samples_.position[s]).squaredNorm();
  }

  const SampleSet& samples_;
  const std::vector<ImageCurves>& curves_;
  const std::vector<EdgelClaims>& claims_;
  const DrawingOptions& options_;
  double min_cosine_;
};

void Append(const std::vector<SampleLink>& links, LocalConsistency* network) {
  network->links.insert(network->links.end(), links.begin(), links.end());
  network->begin.push_back(network->links.size());
}

// Concatenates the networks of consecutive samples.
LocalConsistency Joined(std::vector<LocalConsistency> parts) {
  LocalConsistency whole;
  size_t num_samples = 0;
  size_t num_links = 0;
  for (const LocalConsistency& part : parts) {
    num_samples += part.begin.size() - 1;
    num_links += part.links.size();
  }
  whole.begin.reserve(num_samples + 1);
  whole.links.reserve(num_links);
  for (LocalConsistency& part : parts) {
    const size_t before = whole.links.size();
    for (size_t s = 1; s < part.begin.size(); ++s) whole.begin.push_back(before + part.begin[s]);
    whole.links.insert(whole.links.end(), part.links.begin(), part.links.end());
    part = {};
  }
  return whole;
}

}  // namespace

LocalConsistency BuildLocalConsistency(const SampleSet& samples,
                                       const std::vector<ImageCurves>& curves,
                                       const DrawingOptions& options, const RunContext& context) {
  const auto claims = CollectClaims(samples, curves);
  const LinkFinder finder(samples, curves, claims, options);
  return Joined(MapItems(context, "local consistency", samples.NumCurves(), [&](size_t c) {
    LocalConsistency of_curve;
    for (int s = samples.curve_begin[c]; s < samples.curve_begin[c + 1]; ++s) {
      Append(finder.LinksOf(s), &of_curve);
    }
    return of_curve;
  }));
}

}  // namespace limn
