#include "limn/drawing/joints.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "limn/support/edgel_residual.h"

namespace limn {
namespace {

// Stretch of a link in which support makes the joint visible, px.
constexpr double kVisibleStretchPx = 10;
// Edgels to either side on the fragment that belong to a claimed one: samples are about 2 px apart.
constexpr int kClaimedNeighbors = 1;
// Between the points of a straight link, px.
constexpr double kSpacingPx = 2;

void MarkViews(const SampleSet& samples, const DraftLink& link, int end,
               std::vector<uint8_t>* visible) {
  double arc_px = 0;
  for (int k = 0; k < link.size() && arc_px <= kVisibleStretchPx; ++k) {
    const int at = end == 0 ? k : link.size() - 1 - k;
    for (const int s : link.samples[at]) {
      for (const EdgelRef& ref : samples.support.Of(s)) (*visible)[ref.view] = 1;
    }
    if (k + 1 < link.size()) arc_px += end == 0 ? ArcPx(link, at, at + 1) : ArcPx(link, at - 1, at);
  }
}

}  // namespace

std::vector<Joint> CollectJoints(const SampleSet& samples, size_t num_views, const Draft& draft) {
  std::vector<Joint> joints;
  std::map<int, size_t> of_node;
  for (size_t l = 0; l < draft.links.size(); ++l) {
    const DraftLink& link = draft.links[l];
    if (link.closed || link.size() < 2) continue;
    for (const int end : {0, 1}) {
      const auto known = link.node[end] < 0 ? of_node.end() : of_node.find(link.node[end]);
      const size_t id = known == of_node.end() ? joints.size() : known->second;
      if (id == joints.size()) {
        joints.emplace_back();
        joints[id].visible.assign(num_views, 0);
        if (link.node[end] >= 0) of_node[link.node[end]] = id;
      }
      Joint& joint = joints[id];
      joint.position += end == 0 ? link.position.front() : link.position.back();
      joint.footprint += end == 0 ? link.footprint.front() : link.footprint.back();
      joint.ends.push_back({static_cast<int>(l), end});
      joint.leaving.push_back(-LineAtEnd(link, end).outward);
      MarkViews(samples, link, end, &joint.visible);
    }
  }
  for (Joint& joint : joints) {
    joint.position /= static_cast<double>(joint.ends.size());
    joint.footprint /= static_cast<double>(joint.ends.size());
  }
  return joints;
}

bool IsTaken(const Joint& joint, const Eigen::Vector3d& direction, double max_angle_rad) {
  const double min_cosine = std::cos(max_angle_rad);
  return std::any_of(
      joint.leaving.begin(), joint.leaving.end(),
      [&](const Eigen::Vector3d& leaving) { return leaving.dot(direction) > min_cosine; });
}

EdgelEvidence IndexEdgels(const std::vector<ImageCurves>& curves,
                          const std::vector<std::unique_ptr<ViewEvidence>>& evidence,
                          const SampleSet& samples, const Draft& draft) {
  std::vector<std::vector<bool>> claimed;
  for (const ImageCurves& of_view : curves) claimed.emplace_back(of_view.edge_map.edgels.size());
  for (const DraftLink& link : draft.links) {
    for (const auto& of_point : link.samples) {
      for (const int s : of_point) {
        for (const EdgelRef& ref : samples.support.Of(s)) claimed[ref.view][ref.edgel] = true;
      }
    }
  }
  EdgelEvidence result;
  for (size_t v = 0; v < curves.size(); ++v) {
    std::vector<bool> unclaimed(claimed[v].size(), false);
    for (const CurveFragment& fragment : curves[v].fragments) {
      const auto size = static_cast<int>(fragment.edgel_ids.size());
      for (const EdgelId id : fragment.edgel_ids) unclaimed[id] = true;
      for (int i = 0; i < size; ++i) {
        if (!claimed[v][fragment.edgel_ids[i]]) continue;
        const int last = std::min(size - 1, i + kClaimedNeighbors);
        for (int j = std::max(0, i - kClaimedNeighbors); j <= last; ++j) {
          unclaimed[fragment.edgel_ids[j]] = false;
        }
      }
    }
    result.all.push_back(&evidence[v]->edgels);
    result.owned.emplace_back(curves[v].edge_map, unclaimed);
  }
  for (const EdgelIndex& index : result.owned) result.unclaimed.push_back(&index);
  return result;
}

SupportGate CornerGate() { return {1.5, 1.5, 25 * M_PI / 180}; }

std::vector<EdgelRef> SupportAt(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                                const std::vector<ViewId>& in_views, const std::vector<View>& views,
                                const EdgelIndexes& edgels, const SupportGate& gate) {
  std::vector<EdgelRef> support;
  for (const ViewId v : in_views) {
    const auto sight = See(views[v], position, direction);
    if (!sight) continue;
    const auto match = edgels[v]->Best(sight->position_px, sight->direction_rad, gate);
    if (match) support.push_back({v, match->edgel});
  }
  return support;
}

int StraightLinks::NodeAt(const Joint& joint) {
  int node = -1;
  for (const LinkEnd& end : joint.ends) {
    node = std::max(node, draft_->links[end.link].node[end.end]);
  }
  if (node < 0) node = draft_->num_nodes++;
  for (const LinkEnd& end : joint.ends) draft_->links[end.link].node[end.end] = node;
  return node;
}

int StraightLinks::AppendSample(const Eigen::Vector3d& position, const Eigen::Vector3d& direction,
                                double footprint, const std::vector<ViewId>& in_views) {
  const auto support = SupportAt(position, direction, in_views, views_, edgels_, CornerGate());
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const EdgelRef& ref : support) {
    const Edgel& edgel = curves_[ref.view].edge_map.edgels[ref.edgel];
    const auto residual = ResidualToEdgel(views_[ref.view], edgel, position);
    if (!residual) continue;
    information += residual->gradient * residual->gradient.transpose() / ResidualVariance(edgel);
  }
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - direction * direction.transpose();
  samples_->curve_of.push_back(samples_->NumCurves() - 1);
  samples_->position.push_back(position);
  samples_->tangent.push_back(direction);
  samples_->information.push_back(across * information * across);
  samples_->footprint.push_back(footprint);
  samples_->support.Append(support);
  return samples_->NumSamples() - 1;
}

void StraightLinks::Add(const Eigen::Vector3d& end, const std::vector<ViewId>& in_views,
                        Joint* joint, Joint* target) {
  const Eigen::Vector3d begin = joint->position;
  const Eigen::Vector3d direction = (end - begin).normalized();
  const double length_px = (end - begin).norm() / joint->footprint;
  const int count = std::max(3, static_cast<int>(std::lround(length_px / kSpacingPx)) + 1);
  DraftLink link;
  link.grown = true;
  link.node[0] = NodeAt(*joint);
  if (target) link.node[1] = NodeAt(*target);
  samples_->origins.push_back({});
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d position = begin + (end - begin) * k / (count - 1.0);
    const int sample = AppendSample(position, direction, joint->footprint, in_views);
    link.position.push_back(position);
    link.information.push_back(samples_->information[sample]);
    link.footprint.push_back(joint->footprint);
    link.samples.push_back({sample});
  }
  samples_->curve_begin.push_back(samples_->NumSamples());
  const int id = static_cast<int>(draft_->links.size());
  draft_->links.push_back(std::move(link));
  joint->leaving.push_back(direction);
  joint->ends.push_back({id, 0});
  if (!target) return;
  target->leaving.push_back(-direction);
  target->ends.push_back({id, 1});
}

}  // namespace limn
