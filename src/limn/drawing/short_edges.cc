#include "limn/drawing/short_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <tuple>

#include "limn/drawing/segment_evidence.h"
#include "limn/drawing/vertex_grid.h"
#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

constexpr double kDeg = M_PI / 180;
// Between points of a new link, px.
constexpr double kSpacingPx = 2;
// Nodes nearer than this are one.
constexpr double kMinLengthPx = 3;
// Directions nearer than this to a link's are taken by it.
constexpr double kMinTurnDeg = 25;

// A place where links end: a node or a free end.
struct Joint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double footprint = 0;
  std::vector<Eigen::Vector3d> leaving;  // unit directions into the links
  std::vector<std::pair<int, int>> ends;  // (link, end)
};

class ShortEdges {
 public:
  ShortEdges(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
             const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
             const DrawingOptions& options, SampleSet* samples, Draft* draft)
      : views_(views), curves_(curves), evidence_(evidence), options_(options), samples_(samples),
        draft_(draft), gate_(options.Gate()) {
    gate_.normal_px = 1.5;
    gate_.along_px = 1.5;
    gate_.angle_rad = 25 * kDeg;
  }

  int64_t Run() {
    CollectJoints();
    std::vector<std::tuple<double, int, int>> found;
    VertexGrid grid(options_.max_short_edge_px);
    for (size_t i = 0; i < joints_.size(); ++i) {
      grid.Add(static_cast<int>(i), joints_[i].position, joints_[i].footprint);
    }
    for (size_t i = 0; i < joints_.size(); ++i) {
      std::vector<int> near;
      grid.ForEachNear(joints_[i].position, joints_[i].footprint, [&](int j) {
        if (j > static_cast<int>(i) && Possible(joints_[i], joints_[j])) near.push_back(j);
      });
      std::sort(near.begin(), near.end());
      for (const int j : near) {
        const double chance = Chance(joints_[i], joints_[j], near.size());
        if (chance < std::log(1e-3)) found.push_back({chance, static_cast<int>(i), j});
      }
    }
    std::sort(found.begin(), found.end());
    int64_t added = 0;
    for (const auto& [chance, i, j] : found) {
      if (!Possible(joints_[i], joints_[j])) continue;  // another one has taken the direction
      AddLink(i, j);
      ++added;
    }
    return added;
  }

 private:
  void CollectJoints() {
    std::map<int, int> of_node;
    for (size_t l = 0; l < draft_->links.size(); ++l) {
      const DraftLink& link = draft_->links[l];
      if (link.closed || link.size() < 2) continue;
      for (const int end : {0, 1}) {
        const int node = link.node[end];
        auto known = node >= 0 ? of_node.find(node) : of_node.end();
        const int id = known != of_node.end() ? known->second : static_cast<int>(joints_.size());
        if (known == of_node.end()) {
          joints_.emplace_back();
          if (node >= 0) of_node[node] = id;
        }
        Joint& joint = joints_[id];
        joint.position += end == 0 ? link.position.front() : link.position.back();
        joint.footprint += end == 0 ? link.footprint.front() : link.footprint.back();
        joint.leaving.push_back(-LineAtEnd(link, end).outward);
        joint.ends.push_back({static_cast<int>(l), end});
      }
    }
    for (Joint& joint : joints_) {
      joint.position /= static_cast<double>(joint.ends.size());
      joint.footprint /= static_cast<double>(joint.ends.size());
    }
  }

  static bool Taken(const Joint& joint, const Eigen::Vector3d& direction) {
    return std::any_of(joint.leaving.begin(), joint.leaving.end(), [&](const auto& leaving) {
      return leaving.dot(direction) > std::cos(kMinTurnDeg * kDeg);
    });
  }

  bool Possible(const Joint& a, const Joint& b) const {
    const Eigen::Vector3d offset = b.position - a.position;
    const double length_px = offset.norm() / a.footprint;
    if (length_px < kMinLengthPx || length_px > options_.max_short_edge_px) return false;
    const Eigen::Vector3d direction = offset.normalized();
    return !Taken(a, direction) && !Taken(b, -direction);
  }

  double Chance(const Joint& a, const Joint& b, size_t num_tests) const {
    const SegmentEvidence found = FindEvidence(a.position, b.position, views_, evidence_, gate_);
    const int count = static_cast<int>(found.seen_in.size());
    if (getenv("DBG")) printf("SE %.3f %.3f %.3f  %.3f %.3f %.3f len %.1f seen %d of %d bg %.3f chance %.1f\n", a.position.x(), a.position.y(), a.position.z(), b.position.x(), b.position.y(), b.position.z(), (a.position-b.position).norm()/a.footprint, count, found.num_views, found.background, LogChance(count, found.num_views, found.background) + std::log(double(num_tests)));
    if (count < options_.min_supporting_views) return 0;
    return LogChance(count, found.num_views, found.background) +
           std::log(static_cast<double>(num_tests));
  }

  int NodeAt(const Joint& joint) {
    int node = -1;
    for (const auto& [link, end] : joint.ends) node = std::max(node, draft_->links[link].node[end]);
    if (node < 0) node = draft_->num_nodes++;
    for (const auto& [link, end] : joint.ends) draft_->links[link].node[end] = node;
    return node;
  }

  void AddLink(int i, int j) {
    const Eigen::Vector3d from = joints_[i].position;
    const Eigen::Vector3d to = joints_[j].position;
    const double footprint = 0.5 * (joints_[i].footprint + joints_[j].footprint);
    const Eigen::Vector3d direction = (to - from).normalized();
    const int count =
        std::max(3, static_cast<int>(std::lround((to - from).norm() / footprint / kSpacingPx)) + 1);
    DraftLink link;
    link.node[0] = NodeAt(joints_[i]);
    link.node[1] = NodeAt(joints_[j]);
    const int first_sample = samples_->NumSamples();
    const int curve = samples_->NumCurves();
    samples_->origins.push_back({});
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector3d position = from + (to - from) * k / (count - 1.0);
      std::vector<EdgelRef> support;
      Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
      for (size_t v = 0; v < views_.size(); ++v) {
        const auto pixel = views_[v].Project(position);
        const auto angle = ProjectedDirection(views_[v], position, direction);
        if (!pixel || !angle) continue;
        const auto match = evidence_[v]->edgels.Best(*pixel, *angle, gate_);
        if (!match) continue;
        support.push_back({static_cast<ViewId>(v), match->edgel});
        const auto residual = ResidualToEdgel(
            views_[v], curves_[v].edge_map.edgels[match->edgel], position);
        if (residual) information += residual->gradient * residual->gradient.transpose();
      }
      const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
      samples_->curve_of.push_back(curve);
      samples_->position.push_back(position);
      samples_->tangent.push_back(direction);
      samples_->information.push_back(across * information * across);
      samples_->footprint.push_back(footprint);
      samples_->support.Append(support);
      link.position.push_back(position);
      link.information.push_back(samples_->information.back());
      link.footprint.push_back(footprint);
      link.samples.push_back({first_sample + k});
    }
    samples_->curve_begin.push_back(samples_->NumSamples());
    const int id = static_cast<int>(draft_->links.size());
    draft_->links.push_back(std::move(link));
    joints_[i].leaving.push_back(direction);
    joints_[i].ends.push_back({id, 0});
    joints_[j].leaving.push_back(-direction);
    joints_[j].ends.push_back({id, 1});
  }

  const std::vector<View>& views_;
  const std::vector<ImageCurves>& curves_;
  const std::vector<std::unique_ptr<ViewEvidence>>& evidence_;
  const DrawingOptions& options_;
  SampleSet* samples_;
  Draft* draft_;
  SupportGate gate_;
  std::vector<Joint> joints_;
};

}  // namespace

int64_t AddShortEdges(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                      const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                      const DrawingOptions& options, SampleSet* samples, Draft* draft) {
  return ShortEdges(views, curves, evidence, options, samples, draft).Run();
}

}  // namespace limn
