#include "limn/drawing/graph_assembly.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <Eigen/Eigenvalues>

#include "limn/support/edgel_residual.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Points nearer to each other than this are thinned out, px.
constexpr double kMinSpacingPx = 0.5;
// A view supports a link along at least this much of it, in points.
constexpr int kMinSupportedPoints = 3;

// Standard deviation across the curve: the root of the mean of the two variances.
double SigmaAcross(const Eigen::Matrix3d& information, double footprint) {
  const Eigen::Vector3d values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(information, Eigen::EigenvaluesOnly)
          .eigenvalues();
  const double weak = WeakInformation(footprint);
  return std::sqrt(0.5 * (1 / std::max(values[1], weak) + 1 / std::max(values[2], weak)));
}

std::vector<LinkMember> Members(const SampleSet& samples, const DraftLink& link) {
  std::vector<int> all;
  for (const auto& of_point : link.samples) all.insert(all.end(), of_point.begin(), of_point.end());
  std::sort(all.begin(), all.end());
  std::vector<LinkMember> members;
  for (const int s : all) {
    const CurveOrigin& origin = samples.origins[samples.curve_of[s]];
    if (origin.sketch_curve < 0) continue;
    const int index = origin.begin + s - samples.curve_begin[samples.curve_of[s]];
    if (!members.empty() && members.back().curve == origin.sketch_curve &&
        members.back().end == index) {
      ++members.back().end;
    } else {
      members.push_back({origin.sketch_curve, index, index + 1});
    }
  }
  return members;
}

std::vector<ViewId> SupportingViews(const SampleSet& samples, const DraftLink& link) {
  std::map<ViewId, int> points;
  for (const auto& of_point : link.samples) {
    std::vector<ViewId> views;
    for (const int s : of_point) {
      for (const EdgelRef& ref : samples.support.Of(s)) views.push_back(ref.view);
    }
    std::sort(views.begin(), views.end());
    views.erase(std::unique(views.begin(), views.end()), views.end());
    for (const ViewId view : views) ++points[view];
  }
  std::vector<ViewId> views;
  for (const auto& [view, count] : points) {
    if (count >= kMinSupportedPoints) views.push_back(view);
  }
  return views;
}

double MedianResidualPx(const SampleSet& samples, const std::vector<View>& views,
                        const std::vector<ImageCurves>& curves, const DraftLink& link) {
  std::vector<double> residuals;
  for (int k = 0; k < link.size(); ++k) {
    if (link.samples[k].empty()) continue;
    for (const EdgelRef& ref : samples.support.Of(link.samples[k].front())) {
      const auto residual = ResidualToEdgel(
          views[ref.view], curves[ref.view].edge_map.edgels[ref.edgel], link.position[k]);
      if (residual) residuals.push_back(std::abs(residual->residual_px));
    }
  }
  return Median(std::move(residuals));
}

class Assembler {
 public:
  Assembler(const SampleSet& samples, const std::vector<View>& views,
            const std::vector<ImageCurves>& curves, const DrawingOptions& options,
            const Draft& draft)
      : samples_(samples), views_(views), curves_(curves), options_(options), draft_(draft) {}

  DrawingGraph Run() {
    MakeNodes();
    for (size_t i = 0; i < draft_.links.size(); ++i) AddLink(static_cast<int>(i));
    RebuildIncidence(&graph_);
    for (DrawingNode& node : graph_.nodes) AddContinuations(&node);
    return std::move(graph_);
  }

 private:
  // Nodes in the order of the links that use them first; positions are means of the incident ends.
  void MakeNodes() {
    std::map<int, NodeId> ids;
    std::vector<int> num_ends;
    for (const DraftLink& link : draft_.links) {
      std::array<NodeId, 2> of_link;
      for (const int end : {0, 1}) {
        if (link.closed && end == 1) {
          of_link[1] = of_link[0];
          continue;
        }
        const int node = link.node[end];
        const bool is_new = node < 0 || !ids.count(node);
        const NodeId id = is_new ? static_cast<NodeId>(graph_.nodes.size()) : ids[node];
        if (is_new) {
          graph_.nodes.emplace_back();
          num_ends.push_back(0);
          if (node >= 0) ids[node] = id;
        }
        graph_.nodes[id].position_in_world +=
            end == 0 ? link.position.front() : link.position.back();
        ++num_ends[id];
        of_link[end] = id;
      }
      nodes_of_link_.push_back(of_link);
    }
    for (size_t id = 0; id < num_ends.size(); ++id) {
      graph_.nodes[id].position_in_world /= num_ends[id];
    }
  }

  void AddLink(int id) {
    const DraftLink& from = draft_.links[id];
    DrawingLink link;
    link.node0 = nodes_of_link_[id][0];
    link.node1 = nodes_of_link_[id][1];
    link.closed = from.closed;
    link.points_in_world.push_back(graph_.nodes[link.node0].position_in_world);
    link.sigma.push_back(SigmaAcross(from.information.front(), from.footprint.front()));
    const int last = from.closed ? from.size() : from.size() - 1;
    const Eigen::Vector3d& end = graph_.nodes[link.node1].position_in_world;
    for (int k = 1; k < last; ++k) {
      const double spacing = kMinSpacingPx * from.footprint[k];
      if ((from.position[k] - link.points_in_world.back()).norm() < spacing) continue;
      if ((from.position[k] - end).norm() < spacing && last - k < 3) continue;
      link.points_in_world.push_back(from.position[k]);
      link.sigma.push_back(SigmaAcross(from.information[k], from.footprint[k]));
    }
    link.points_in_world.push_back(end);
    link.sigma.push_back(from.closed ? link.sigma.front()
                                     : SigmaAcross(from.information.back(), from.footprint.back()));
    link.members = Members(samples_, from);
    link.supporting_views = SupportingViews(samples_, from);
    link.residual_px = MedianResidualPx(samples_, views_, curves_, from);
    graph_.links.push_back(std::move(link));
  }

  Eigen::Vector3d Outward(const LinkEnd& end) const {
    return LineAtEnd(draft_.links[end.link], end.end).outward;
  }

  // Pair the incident ends that go on most smoothly through the node, each at most once.
  void AddContinuations(DrawingNode* node) const {
    std::vector<std::tuple<double, LinkEnd, LinkEnd>> pairs;
    for (size_t i = 0; i < node->incident.size(); ++i) {
      for (size_t j = i + 1; j < node->incident.size(); ++j) {
        const double cosine = Outward(node->incident[i]).dot(Outward(node->incident[j]));
        if (cosine < -std::cos(options_.max_continuation_angle_deg * M_PI / 180)) {
          pairs.push_back({cosine, node->incident[i], node->incident[j]});
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<LinkEnd> used;
    for (const auto& [cosine, a, b] : pairs) {
      const auto taken = [&](const LinkEnd& end) {
        return std::find(used.begin(), used.end(), end) != used.end();
      };
      if (taken(a) || taken(b)) continue;
      node->continuations.push_back({a, b});
      used.insert(used.end(), {a, b});
    }
  }

  const SampleSet& samples_;
  const std::vector<View>& views_;
  const std::vector<ImageCurves>& curves_;
  const DrawingOptions& options_;
  const Draft& draft_;
  DrawingGraph graph_;
  std::vector<std::array<NodeId, 2>> nodes_of_link_;
};

}  // namespace

DrawingGraph AssembleGraph(const SampleSet& samples, const std::vector<View>& views,
                           const std::vector<ImageCurves>& curves, const DrawingOptions& options,
                           const Draft& draft) {
  return Assembler(samples, views, curves, options, draft).Run();
}

}  // namespace limn
