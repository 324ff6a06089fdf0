#include "limn/refinement/edgel_matches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "limn/refinement/crowding.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

constexpr double kSampleSpacingPx = 1.5;
// Image edges nearer to each other than this displace each other or merge, px. Chosen on midday,
// mixed light, vase and day: F -.3 to +.4 with 2, -.7 to +.3 with 4.
constexpr double kResolvedPx = 3;
// An edgel is given up if another link passes nearer to it by more than this, px.
constexpr double kClearlyBetterPx = 0.1;
// Half length of the stretch that decides which side of a link is the brighter one, px, and the
// share of its edgels that must agree.
constexpr double kSideWindowPx = 15;
constexpr double kSameSideShare = 0.85;

class LinkMatcher {
 public:
  LinkMatcher(const TopologyInput& input, const ControlGraph& control,
              const RefinementOptions& options)
      : input_(input), control_(control), options_(options) {}

  // Where the links run in the images of the views that show them.
  std::vector<ImagePlace> PlacesIn(ViewId view) const {
    std::vector<ImagePlace> found;
    for (size_t l = 0; l < control_.links.size(); ++l) {
      const ControlLink& link = control_.links[l];
      if (!std::binary_search(link.views.begin(), link.views.end(), view)) continue;
      for (const Place& place : MakePlaces(link)) {
        if (const auto seen = SightOf(view, place)) {
          found.push_back({static_cast<int>(l), seen->position_px, seen->direction_rad});
        }
      }
    }
    return found;
  }

  LinkMatches Run(int link, const std::vector<Crowding>& crowding) const {
    const std::vector<Place> places = MakePlaces(control_.links[link]);
    LinkMatches matches;
    for (const Place& place : places) matches.push_back({place.segment, place.t, {}});
    for (const ViewId view : control_.links[link].views) AddView(view, places, &matches);
    KeepOneSide(places, &matches);
    KeepResolved(link, places, crowding, &matches);
    for (LinkSample& sample : matches) {
      if (static_cast<int>(sample.pulls.size()) < options_.min_views) sample.pulls.clear();
    }
    return matches;
  }

 private:
  struct Place {
    int segment;
    double t;
    Eigen::Vector3d position;
    Eigen::Vector3d tangent;
    double arc_px;
  };

  // What a view shows at a place.
  struct Answer {
    bool asked = false;
    std::optional<EdgelMatch> match;
    Eigen::Vector2d pixel;
    // Whether the edgel has the direction of the link, not the opposite one. All views of an edge
    // in the same light agree on its brighter side.
    bool bright_left = false;
  };

  std::vector<Place> MakePlaces(const ControlLink& link) const {
    std::vector<double> arc_px = {0};
    for (int s = 0; s < link.NumSegments(); ++s)
      arc_px.push_back(arc_px.back() + SegmentPx(link, s));
    std::vector<Place> places;
    for (int s = 0; s < link.NumSegments(); ++s) {
      const double length_px = arc_px[s + 1] - arc_px[s];
      const int count = std::max(1, static_cast<int>(std::lround(length_px / kSampleSpacingPx)));
      for (int k = 0; k < count; ++k) {
        const double t = (k + 0.5) / count;
        const double at_px = arc_px[s] + t * length_px;
        if (at_px < link.skip_px[0] || arc_px.back() - at_px < link.skip_px[1]) continue;
        const Eigen::Vector3d& from = control_.position[link.points[s]];
        const Eigen::Vector3d& to = control_.position[link.points[s + 1]];
        places.push_back({s, t, from + t * (to - from), Direction(link, s), at_px});
      }
    }
    return places;
  }

  double SegmentPx(const ControlLink& link, int s) const {
    const int from = link.points[s];
    const int to = link.points[s + 1];
    const double footprint = 0.5 * (control_.footprint[from] + control_.footprint[to]);
    if (!(footprint > 0)) return 0;
    return (control_.position[to] - control_.position[from]).norm() / footprint;
  }

  // Over the segment and its neighbors, since the direction of a short segment alone is unreliable.
  Eigen::Vector3d Direction(const ControlLink& link, int s) const {
    const Eigen::Vector3d chord = Chord(control_, link, s - 1, s + 2);
    return chord.norm() > 0 ? Eigen::Vector3d(chord.normalized()) : Eigen::Vector3d::UnitX();
  }

  std::optional<CurveSight> SightOf(ViewId view, const Place& place) const {
    return See(input_.views[view], place.position, place.tangent);
  }

  Answer Ask(ViewId id, const Place& place) const {
    const auto seen = SightOf(id, place);
    if (!seen) return {};
    const auto& [pixel, direction] = *seen;
    Answer answer = {true, input_.edgels[id]->edgels.Best(pixel, direction, input_.gate), pixel,
                     false};
    if (answer.match) {
      const Edgel& edgel = input_.curves[id].edge_map.edgels[answer.match->edgel];
      answer.bright_left = std::cos(edgel.tangent_rad - direction) > 0;
    }
    return answer;
  }

  // Call visit(k) at every place, with those within half a window counted: count(k, 1) when a place
  // comes in, count(k, -1) when it is left behind.
  template <typename Count, typename Visit>
  static void SlideWindow(const std::vector<Place>& places, double half_px, Count&& count,
                          Visit&& visit) {
    const int size = static_cast<int>(places.size());
    int begin = 0;
    int end = 0;
    for (int k = 0; k < size; ++k) {
      for (; end < size && places[end].arc_px <= places[k].arc_px + half_px; ++end) count(end, 1);
      for (; places[begin].arc_px < places[k].arc_px - half_px; ++begin) count(begin, -1);
      visit(k);
    }
  }

  void AddView(ViewId view, const std::vector<Place>& places, LinkMatches* matches) const {
    std::vector<Answer> answers;
    for (const Place& place : places) answers.push_back(Ask(view, place));
    int num_asked = 0;
    int num_found = 0;
    const auto count = [&](int k, int sign) {
      num_asked += sign * answers[k].asked;
      num_found += sign * answers[k].match.has_value();
    };
    SlideWindow(places, options_.support_window_px, count, [&](int k) {
      if (!answers[k].match || num_found < options_.min_window_support * num_asked) return;
      const EdgelMatch& match = *answers[k].match;
      (*matches)[k].pulls.push_back({{view, match.edgel},
                                     Weight(view, answers, k),
                                     match.normal_residual_px,
                                     answers[k].bright_left});
    });
  }

  // Where nearly all edgels around a sample agree on the brighter side, the others belong to
  // another edge nearby, such as the other side of a thin bar.
  void KeepOneSide(const std::vector<Place>& places, LinkMatches* matches) const {
    const LinkMatches all = *matches;
    int num[2] = {0, 0};
    const auto count = [&](int k, int sign) {
      for (const EdgelPull& pull : all[k].pulls) num[pull.bright_left] += sign;
    };
    SlideWindow(places, kSideWindowPx, count, [&](int k) {
      const bool major = num[1] > num[0];
      if (num[major] < kSameSideShare * (num[0] + num[1])) return;
      std::erase_if((*matches)[k].pulls,
                    [&](const EdgelPull& pull) { return pull.bright_left != major; });
    });
  }

  // Views in which another link runs too near to this one to tell their edges apart would pull both
  // onto one edge. They are ignored where enough other views remain.
  void KeepResolved(int link, const std::vector<Place>& places,
                    const std::vector<Crowding>& crowding, LinkMatches* matches) const {
    for (size_t k = 0; k < places.size(); ++k) {
      std::vector<EdgelPull> resolved;
      for (const EdgelPull& pull : (*matches)[k].pulls) {
        const auto seen = SightOf(pull.ref.view, places[k]);
        const ImagePlace place = {link, seen->position_px, seen->direction_rad};
        if (!crowding[pull.ref.view].At(place, kResolvedPx)) resolved.push_back(pull);
      }
      if (static_cast<int>(resolved.size()) >= options_.min_views) {
        (*matches)[k].pulls = std::move(resolved);
      }
    }
  }

  // Share of an independent observation: the step to the next sample in the image, divided by the
  // correlation length.
  double Weight(ViewId view, const std::vector<Answer>& answers, int k) const {
    const int size = static_cast<int>(answers.size());
    const int other = k + 1 < size && answers[k + 1].asked ? k + 1 : k - 1;
    if (other < 0 || !answers[other].asked) return 0.1;
    const Edgel& edgel = input_.curves[view].edge_map.edgels[answers[k].match->edgel];
    const double step_px =
        (edgel.stored_from_virtual.cast<double>() * (answers[other].pixel - answers[k].pixel))
            .norm();
    return std::clamp(step_px / options_.correlation_px, 0.01, 1.0);
  }

  const TopologyInput& input_;
  const ControlGraph& control_;
  const RefinementOptions& options_;
};

// Per view and edgel the smallest residual of a link.
std::vector<std::vector<float>> BestResiduals(const std::vector<ImageCurves>& curves,
                                              const std::vector<LinkMatches>& matches) {
  std::vector<std::vector<float>> best;
  for (const ImageCurves& of_view : curves) {
    best.emplace_back(of_view.edge_map.edgels.size(), std::numeric_limits<float>::infinity());
  }
  for (const LinkMatches& of_link : matches) {
    for (const LinkSample& sample : of_link) {
      for (const EdgelPull& pull : sample.pulls) {
        float& own = best[pull.ref.view][pull.ref.edgel];
        own = std::min(own, static_cast<float>(std::abs(pull.residual_px)));
      }
    }
  }
  return best;
}

}  // namespace

std::vector<LinkMatches> MatchEdgels(const TopologyInput& input, const ControlGraph& control,
                                     const RefinementOptions& options, const RunContext& context) {
  const LinkMatcher matcher(input, control, options);
  std::vector<std::vector<ImagePlace>> places(input.views.size());
  ParallelFor(context, "projecting links", places.size(),
              [&](size_t v) { places[v] = matcher.PlacesIn(static_cast<ViewId>(v)); });
  std::vector<Crowding> crowding(places.begin(), places.end());
  std::vector<LinkMatches> matches(control.links.size());
  ParallelFor(context, "matching edgels", matches.size(),
              [&](size_t l) { matches[l] = matcher.Run(static_cast<int>(l), crowding); });
  const auto best = BestResiduals(input.curves, matches);
  for (LinkMatches& of_link : matches) {
    for (LinkSample& sample : of_link) {
      std::erase_if(sample.pulls, [&](const EdgelPull& pull) {
        return std::abs(pull.residual_px) > best[pull.ref.view][pull.ref.edgel] + kClearlyBetterPx;
      });
      if (static_cast<int>(sample.pulls.size()) < options.min_views) sample.pulls.clear();
    }
  }
  return matches;
}

}  // namespace limn
