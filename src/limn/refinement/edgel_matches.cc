// SPDX-License-Identifier: BSD-3-Clause
#include "limn/refinement/edgel_matches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "limn/refinement/crowding.h"
#include "limn/support/edgel_residual.h"
#include "limn/topology/fragment_neighbors.h"

namespace limn {
namespace {

// Of a segment: only one that the fit has thrown far away is longer.
constexpr double kMaxSegmentSamples = 1000;
// Of links with fewer segments single samples of them might all be at ends that take no data.
constexpr int kFewSegments = 4;
// Image edges nearer to each other than this displace each other or merge, px.
constexpr double kResolvedPx = 3;
// An edgel is given up if another link passes nearer to it by more than this, px.
constexpr double kClearlyBetterPx = 0.1;
// Half length of the stretch that decides which side of a link is the brighter one, px, and the
// share of its edgels that must agree.
constexpr double kSideWindowPx = 15;
constexpr double kSameSideShare = 0.85;
// Half length of the stretch around a sample that decides whether a view shows the link there, px,
// and the share of it that edgels must cover: single edgels may be there by chance.
constexpr double kSupportWindowPx = 6;
constexpr double kMinWindowSupport = 0.5;

// In px of the mean footprint of its ends.
double SegmentPx(const ControlGraph& control, int from, int to) {
  const double footprint = 0.5 * (control.footprint[from] + control.footprint[to]);
  if (!(footprint > 0)) return 0;
  return (control.position[to] - control.position[from]).norm() / footprint;
}

std::vector<FitSample> MakeSamples(const ControlGraph& control, const ControlLink& link,
                                   double spacing_px) {
  std::vector<double> arc_px = {0};
  for (int s = 0; s < link.NumSegments(); ++s) {
    arc_px.push_back(arc_px.back() + SegmentPx(control, link.points[s], link.points[s + 1]));
  }
  std::vector<FitSample> samples;
  const int least = link.NumSegments() < kFewSegments ? 2 : 1;
  for (int s = 0; s < link.NumSegments(); ++s) {
    const Eigen::Vector3d& from = control.position[link.points[s]];
    const Eigen::Vector3d& to = control.position[link.points[s + 1]];
    // Over the neighbors, too: the direction of a short segment alone is unreliable.
    const Eigen::Vector3d tangent = Tangent(control, link, s - 1, s + 2);
    const double length_px = arc_px[s + 1] - arc_px[s];
    const double num_steps = std::min(length_px / spacing_px, kMaxSegmentSamples);
    const int count = std::max(least, static_cast<int>(std::lround(num_steps)));
    for (int k = 0; k < count; ++k) {
      const double t = (k + 0.5) / count;
      const double at_px = arc_px[s] + t * length_px;
      if (at_px < link.skip_px[0] || arc_px.back() - at_px < link.skip_px[1]) continue;
      samples.push_back({s, t, from + t * (to - from), tangent, at_px, {}});
    }
  }
  return samples;
}

// Where the links run in the image of a view, if it shows them.
std::vector<ImagePlace> PlacesIn(ViewId id, const View& view, const ControlGraph& control) {
  std::vector<ImagePlace> places;
  for (size_t l = 0; l < control.links.size(); ++l) {
    const ControlLink& link = control.links[l];
    if (!std::binary_search(link.views.begin(), link.views.end(), id)) continue;
    for (const FitSample& sample : link.samples) {
      if (const auto seen = See(view, sample.position, sample.tangent)) {
        places.push_back({static_cast<int>(l), seen->position_px, seen->direction});
      }
    }
  }
  return places;
}

// Call visit(k) at every sample, with those within half a window counted: count(k, 1) when a sample
// comes in, count(k, -1) when it is left behind.
template <typename Count, typename Visit>
void SlideWindow(const std::vector<FitSample>& samples, double half_px, Count&& count,
                 Visit&& visit) {
  const int size = static_cast<int>(samples.size());
  int begin = 0;
  int end = 0;
  for (int k = 0; k < size; ++k) {
    const double at_px = samples[k].arc_px;
    for (; end < size && samples[end].arc_px <= at_px + half_px; ++end) count(end, 1);
    for (; samples[begin].arc_px < at_px - half_px; ++begin) count(begin, -1);
    visit(k);
  }
}

// What a view shows at a sample.
struct Answer {
  std::optional<CurveSight> sight;
  std::optional<EdgelMatch> match;
};

// The least share of an independent observation, and that of a sample that is seen alone.
constexpr double kMinShare = 0.01;
constexpr double kShareAlone = 0.1;

// From a sample to the next one in the virtual image, or else from the previous one.
std::optional<Eigen::Vector2d> StepAt(const std::vector<Answer>& answers, int k) {
  const int size = static_cast<int>(answers.size());
  const int other = k + 1 < size && answers[k + 1].sight ? k + 1 : k - 1;
  if (other < 0 || !answers[other].sight) return std::nullopt;
  return answers[other].sight->position_px - answers[k].sight->position_px;
}

// Share of an independent observation: the step to the next sample in the image, divided by the
// correlation length.
double Share(const Edgel& edgel, const std::optional<Eigen::Vector2d>& step,
             double correlation_px) {
  if (!step) return kShareAlone;
  const double step_px = (edgel.stored_from_virtual.cast<double>() * *step).norm();
  return std::clamp(step_px / correlation_px, kMinShare, 1.0);
}

// Adds the edgels of a view to the samples of a link.
void AddView(const TopologyInput& input, const RefinementOptions& options, ViewId view, int link,
             const Crowding& crowding, std::vector<FitSample>* samples) {
  std::vector<Answer> answers;
  for (const FitSample& sample : *samples) {
    Answer& answer = answers.emplace_back();
    answer.sight = See(input.views[view], sample.position, sample.tangent);
    if (!answer.sight) continue;
    answer.match = input.edgels[view]->edgels.Best(answer.sight->position_px,
                                                   answer.sight->direction, input.gate);
  }
  int num_asked = 0;
  int num_found = 0;
  const auto count = [&](int k, int sign) {
    num_asked += sign * answers[k].sight.has_value();
    num_found += sign * answers[k].match.has_value();
  };
  SlideWindow(*samples, kSupportWindowPx, count, [&](int k) {
    const auto& [sight, match] = answers[k];
    if (!match || num_found < kMinWindowSupport * num_asked) return;
    const Edgel& edgel = input.curves[view].edge_map.edgels[match->edgel];
    const ImagePlace place = {link, sight->position_px, sight->direction};
    const EdgelRef ref{view, match->edgel};
    EdgelPull pull = {ref, input.LineOf(ref)};
    const std::optional<Eigen::Vector2d> step = StepAt(answers, k);
    pull.weight = Share(edgel, step, options.correlation_px) / ResidualVariance(edgel);
    pull.residual_px = match->normal_residual_px;
    // All views of an edge in the same light agree on its brighter side.
    pull.bright_left = edgel.Tangent().dot(place.direction) > 0;
    pull.crowded = crowding.At(place, kResolvedPx, step ? 0.5 * step->norm() : 0);
    (*samples)[k].pulls.push_back(pull);
  });
}

// Where nearly all edgels around a sample agree on the brighter side, the others belong to another
// edge nearby, such as the other side of a thin bar.
void KeepOneSide(std::vector<FitSample>* samples) {
  int num[2] = {0, 0};
  const auto count = [&](int k, int sign) {
    for (const EdgelPull& pull : (*samples)[k].pulls) num[pull.bright_left] += sign;
  };
  // Pulls are dropped at the end, since the windows of other samples count them, too.
  std::vector<std::pair<int, bool>> agreed;  // sample, side
  SlideWindow(*samples, kSideWindowPx, count, [&](int k) {
    const bool major = num[1] > num[0];
    if (num[major] >= kSameSideShare * (num[0] + num[1])) agreed.push_back({k, major});
  });
  for (const auto& [k, major] : agreed) {
    std::erase_if((*samples)[k].pulls,
                  [side = major](const EdgelPull& pull) { return pull.bright_left != side; });
  }
}

// Views in which another link runs too near to this one to tell their edges apart would pull both
// onto one edge. They are ignored where enough other views remain.
void KeepResolved(int min_views, std::vector<EdgelPull>* pulls) {
  const auto num_crowded = std::ranges::count(*pulls, true, &EdgelPull::crowded);
  if (std::ssize(*pulls) - num_crowded >= min_views) {
    std::erase_if(*pulls, [](const EdgelPull& pull) { return pull.crowded; });
  }
}

void RequireViews(int min_views, std::vector<EdgelPull>* pulls) {
  if (std::ssize(*pulls) < min_views) pulls->clear();
}

// Residuals at an edgel, px: of the link that fits it best, and of the best other one.
struct BestFits {
  int link = -1;
  float of_link_px = std::numeric_limits<float>::infinity();
  float of_other_px = std::numeric_limits<float>::infinity();

  void Add(int other, float residual_px) {
    if (other == link) {
      of_link_px = std::min(of_link_px, residual_px);
    } else if (residual_px < of_link_px) {
      of_other_px = of_link_px;
      link = other;
      of_link_px = residual_px;
    } else {
      of_other_px = std::min(of_other_px, residual_px);
    }
  }
  float BestBut(int own) const { return own == link ? of_other_px : of_link_px; }
};

// Edgels on either side of one that are compared with it, along its fragment: samples of two links
// seldom find the same one.
constexpr int kBeside = 1;

// Gives up edgels that another link fits better.
void KeepBest(const TopologyInput& input, int min_views, ControlGraph* control) {
  std::vector<std::vector<BestFits>> best;  // per view and edgel
  for (const ImageCurves& of_view : input.curves) best.emplace_back(of_view.edge_map.edgels.size());
  for (size_t l = 0; l < control->links.size(); ++l) {
    for (const FitSample& sample : control->links[l].samples) {
      for (const EdgelPull& pull : sample.pulls) {
        const auto residual_px = static_cast<float>(std::abs(pull.residual_px));
        ForEachNeighbor(input, pull.ref, kBeside, [&](EdgelId edgel) {
          best[pull.ref.view][edgel].Add(static_cast<int>(l), residual_px);
        });
      }
    }
  }
  for (size_t l = 0; l < control->links.size(); ++l) {
    for (FitSample& sample : control->links[l].samples) {
      std::erase_if(sample.pulls, [&](const EdgelPull& pull) {
        const BestFits& fits = best[pull.ref.view][pull.ref.edgel];
        return std::abs(pull.residual_px) > fits.BestBut(static_cast<int>(l)) + kClearlyBetterPx;
      });
      RequireViews(min_views, &sample.pulls);
    }
  }
}

}  // namespace

void MatchEdgels(const TopologyInput& input, const RefinementOptions& options,
                 const RunContext& context, ControlGraph* control) {
  for (ControlLink& link : control->links) {
    link.samples = MakeSamples(*control, link, options.sample_spacing_px);
  }
  std::vector<std::optional<Crowding>> crowding(input.views.size());
  ParallelFor(context, "projecting links", crowding.size(), [&](size_t v) {
    crowding[v].emplace(PlacesIn(static_cast<ViewId>(v), input.views[v], *control));
  });
  ParallelFor(context, "matching edgels", control->links.size(), [&](size_t l) {
    ControlLink& link = control->links[l];
    for (const ViewId view : link.views) {
      AddView(input, options, view, static_cast<int>(l), *crowding[view], &link.samples);
    }
    KeepOneSide(&link.samples);
    for (FitSample& sample : link.samples) {
      KeepResolved(options.min_views, &sample.pulls);
      RequireViews(options.min_views, &sample.pulls);
    }
  });
  KeepBest(input, options.min_views, control);
}

}  // namespace limn
