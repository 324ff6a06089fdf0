#include "limn/regularity/settle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "limn/primitives/shape_fit.h"
#include "limn/regularity/least_move.h"
#include "limn/regularity/regular_fit.h"

namespace limn {
namespace {

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

  // Takes back what the regularities as they are now do not strain.
  std::set<Membership> TryAgain() {
    Memberships held = MembershipsOf(classes_, evidence_);
    std::set<Membership> offered;
    for (const Membership& of : ended_) {
      if (!IsLeft(of.kind, of.index, classes_)) continue;
      std::vector<Membership>& with = held[of.link];
      with.push_back(of);
      if (Strain(with) <= options_.max_growth_px) {
        offered.insert(of);
      } else {
        with.pop_back();
      }
    }
    Join(offered, evidence_, &classes_);
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

  // Links whose residual grows too much, of these the worst: others may be well without them.
  std::vector<LinkId> Opposed() const {
    constexpr double kAsBad = 0.5;  // share of the worst growth
    std::vector<std::pair<double, LinkId>> growths;
    double worst = 0;
    for (size_t l = 0; l < shapes_.size(); ++l) {
      if (!shapes_[l]) continue;
      const double growth = Growth(static_cast<LinkId>(l), *shapes_[l]);
      worst = std::max(worst, growth);
      if (growth > options_.max_growth_px) growths.push_back({growth, static_cast<LinkId>(l)});
    }
    std::vector<LinkId> opposed;
    for (const auto& [growth, l] : growths) {
      if (growth >= kAsBad * worst) opposed.push_back(l);
    }
    return opposed;
  }

  // What strains its link most, of what a link and those that meet it follow.
  std::optional<Membership> Culprit(LinkId link, const Memberships& memberships,
                                    const std::set<Membership>& on_trial) const {
    std::set<LinkId> near = {link};
    for (const NodeId node : {graph_.links[link].node0, graph_.links[link].node1}) {
      for (const LinkEnd& at : graph_.nodes[node].incident) near.insert(at.link);
    }
    std::optional<Membership> culprit;
    std::pair<bool, double> most = {false, -std::numeric_limits<double>::infinity()};
    for (const LinkId l : near) {
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

  void End(const std::set<Membership>& memberships) {
    Leave(memberships, evidence_, &classes_);
    ended_.insert(memberships.begin(), memberships.end());
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
  const std::set<Membership> on_trial = settler.TryAgain();
  settler.FitUntilUnopposed(on_trial, context);
  return settler.Result();
}

}  // namespace limn
