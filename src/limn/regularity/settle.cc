// SPDX-License-Identifier: BSD-3-Clause
#include "limn/regularity/settle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "limn/primitives/shape_fit.h"
#include "limn/regularity/least_move.h"
#include "limn/regularity/regular_fit.h"

namespace limn {
namespace {

// How often what left is tried again: in company that left, too, it may have been opposed wrongly.
constexpr int kTrials = 2;

CurveShape ToWorld(const CurveShape& shape, const LocalUnit& unit) {
  return Transformed(shape, unit.length, Eigen::Matrix3d::Identity(), unit.origin);
}

NewShapes ShapesByLink(const RegularShapes& shapes, const DrawingEvidence& evidence,
                       size_t num_links) {
  NewShapes by_link(num_links);
  for (const auto& [i, line] : shapes.lines) {
    by_link[evidence.lines[i].link] = ToWorld(line, evidence.unit);
  }
  for (const auto& [i, arc] : shapes.arcs) {
    by_link[evidence.arcs[i].link] = ToWorld(arc, evidence.unit);
  }
  return by_link;
}

// Per link; 0 where there is no evidence. Root mean squares, px.
std::vector<double> ResidualsOf(const DrawingGraph& graph, const DrawingEvidence& evidence) {
  std::vector<double> residuals;
  for (size_t l = 0; l < graph.links.size(); ++l) {
    const LinkSamples& samples = evidence.samples[l];
    residuals.push_back(
        samples.samples.empty() ? 0 : ResidualOf(graph.links[l].primitive->shape, samples).RmsPx());
  }
  return residuals;
}

class Settler {
 public:
  Settler(const DrawingGraph& graph, const DrawingEvidence& evidence,
          const RegularityOptions& options, RegularityClasses classes)
      : graph_(graph),
        evidence_(evidence),
        options_(options),
        classes_(std::move(classes)),
        rms_before_(ResidualsOf(graph, evidence)) {}

  void LeaveWhatStrains() {
    std::set<Membership> strained;
    for (const auto& [link, memberships] : MembershipsOf(classes_, evidence_)) {
      for (const Membership& of : memberships) {
        if (Strain({&of, 1}) > options_.max_growth_px) strained.insert(of);
      }
    }
    End(strained);
  }

  // Ends: every round ends memberships. `on_trial` go before others.
  void FitUntilUnopposed(const std::set<Membership>& on_trial, const RunContext& context) {
    while (true) {
      ThrowIfCancelled(context);
      shapes_ = ShapesByLink(FitRegularShapes(graph_, evidence_, &classes_), evidence_,
                             graph_.links.size());
      const Memberships memberships = MembershipsOf(classes_, evidence_);
      std::set<Membership> culprits;
      for (const LinkId l : Opposed()) {
        if (const auto culprit = Culprit(l, memberships, on_trial)) culprits.insert(*culprit);
      }
      if (culprits.empty()) return;
      End(culprits);
    }
  }

  // Ends planes that have a normal of their own and lost so much that they no longer save it. Those
  // across a direction stay: it holds them. Whether there were any.
  bool LeavePoorPlanes() {
    std::set<int> poor;
    for (size_t p = 0; p < classes_.planes.size(); ++p) {
      const PlaneClass& plane = classes_.planes[p];
      if (plane.Size() > 0 && plane.normal_class < 0 &&
          !SavesItsNormal(plane, graph_, evidence_, classes_.directions, options_)) {
        poor.insert(static_cast<int>(p));
      }
    }
    std::set<Membership> leaving;
    for (const auto& [link, memberships] : MembershipsOf(classes_, evidence_)) {
      for (const Membership& of : memberships) {
        if (of.kind == RegularityKind::kPlane && poor.contains(of.index)) leaving.insert(of);
      }
    }
    Leave(leaving, evidence_, &classes_);
    return !poor.empty();
  }

  // Takes back what the regularities as they are now do not strain. Those that lost too much are
  // as they were last.
  std::set<Membership> TryAgain() {
    Memberships held = MembershipsOf(classes_, evidence_);
    std::set<Membership> offered;
    for (const Membership& of : ended_) {
      std::vector<Membership>& with = held[of.link];
      with.push_back(of);
      if (Strain(with) <= options_.max_growth_px) {
        offered.insert(of);
      } else {
        with.pop_back();
      }
    }
    Join(offered, evidence_, &classes_);
    for (const Membership& of : offered) ended_.erase(of);
    return offered;
  }

  SettledRegularities Result() {
    SettledRegularities result;
    const Memberships held = MembershipsOf(classes_, evidence_);
    for (const Membership& of : ended_) {
      if (!held.contains(of.link)) result.let_go.insert(of.link);
    }
    RemoveEmpty(&classes_);
    result.classes = std::move(classes_);
    result.shapes = std::move(shapes_);
    return result;
  }

 private:
  double Growth(LinkId l, const CurveShape& shape) const {
    const double growth = ResidualOf(shape, evidence_.samples[l]).RmsPx() - rms_before_[l];
    if (!ValidateShape(shape).empty() || !std::isfinite(growth)) {
      return std::numeric_limits<double>::infinity();
    }
    return growth;
  }

  // By how much a link's residual grows if it follows these alone.
  double Strain(std::span<const Membership> memberships) const {
    const CurveShape shape = LeastMove(memberships, classes_, evidence_);
    return Growth(memberships.front().link, ToWorld(shape, evidence_.unit));
  }

  // Links whose residual grows too much, of those that meet the worst: others may be well without.
  std::vector<LinkId> Opposed() const {
    constexpr double kAsBad = 0.5;  // share of the worst growth
    std::map<LinkId, double> growths;
    for (size_t l = 0; l < shapes_.size(); ++l) {
      if (!shapes_[l]) continue;
      const double growth = Growth(static_cast<LinkId>(l), *shapes_[l]);
      if (growth > options_.max_growth_px) growths[static_cast<LinkId>(l)] = growth;
    }
    std::vector<LinkId> opposed;
    for (const auto& [l, growth] : growths) {
      double worst = growth;
      for (const LinkId other : LinksAt(l)) {
        const auto found = growths.find(other);
        if (found != growths.end()) worst = std::max(worst, found->second);
      }
      if (growth >= kAsBad * worst) opposed.push_back(l);
    }
    return opposed;
  }

  // A link and those that meet it.
  std::set<LinkId> LinksAt(LinkId link) const {
    std::set<LinkId> links = {link};
    for (const NodeId node : {graph_.links[link].node0, graph_.links[link].node1}) {
      for (const LinkEnd& at : graph_.nodes[node].incident) links.insert(at.link);
    }
    return links;
  }

  // What strains its link most, of what a link and those that meet it follow.
  std::optional<Membership> Culprit(LinkId link, const Memberships& memberships,
                                    const std::set<Membership>& on_trial) const {
    std::optional<Membership> culprit;
    std::pair<bool, double> most = {false, -std::numeric_limits<double>::infinity()};
    for (const LinkId l : LinksAt(link)) {
      const auto follows = memberships.find(l);
      if (follows == memberships.end()) continue;
      for (const Membership& of : follows->second) {
        const std::pair<bool, double> strain = {on_trial.contains(of), Strain({&of, 1})};
        if (culprit && strain <= most) continue;
        culprit = of;
        most = strain;
      }
    }
    return culprit;
  }

  // These, and those of regularities that too few follow then.
  void End(const std::set<Membership>& memberships) {
    const Memberships before = MembershipsOf(classes_, evidence_);
    Leave(memberships, evidence_, &classes_);
    Memberships left = MembershipsOf(classes_, evidence_);
    for (const auto& [link, of] : before) {
      std::set_difference(of.begin(), of.end(), left[link].begin(), left[link].end(),
                          std::inserter(ended_, ended_.end()));
    }
  }

  const DrawingGraph& graph_;
  const DrawingEvidence& evidence_;
  const RegularityOptions& options_;
  RegularityClasses classes_;
  NewShapes shapes_;
  std::vector<double> rms_before_;
  std::set<Membership> ended_;
};

}  // namespace

SettledRegularities SettleRegularities(const DrawingGraph& graph, const DrawingEvidence& evidence,
                                       const RegularityOptions& options, RegularityClasses classes,
                                       const RunContext& context) {
  Settler settler(graph, evidence, options, std::move(classes));
  settler.LeaveWhatStrains();
  settler.FitUntilUnopposed({}, context);
  for (int trial = 0; trial < kTrials; ++trial) {
    settler.LeavePoorPlanes();
    settler.FitUntilUnopposed(settler.TryAgain(), context);
  }
  while (settler.LeavePoorPlanes()) settler.FitUntilUnopposed({}, context);
  return settler.Result();
}

}  // namespace limn
