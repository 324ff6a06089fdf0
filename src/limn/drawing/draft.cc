#include "limn/drawing/draft.h"

#include <algorithm>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "limn/drawing/curve_smoothing.h"
#include "limn/geometry/tangent_frame.h"

namespace limn {
namespace {

// Stretch of a link that the line at its end is fitted to, px; the outermost part, which suffers
// from the neighbouring edges, is left out.
constexpr double kLineSkipPx = 2;
constexpr double kLineLengthPx = 12;

std::vector<Eigen::Vector3d> Tangents(const DraftLink& link) {
  const int size = link.size();
  std::vector<Eigen::Vector3d> tangents(size, Eigen::Vector3d::UnitX());
  for (int k = 0; k < size; ++k) {
    const int before = link.closed ? (k + size - 1) % size : std::max(k - 1, 0);
    const int after = link.closed ? (k + 1) % size : std::min(k + 1, size - 1);
    const Eigen::Vector3d chord = link.position[after] - link.position[before];
    if (chord.norm() > 0) tangents[k] = chord.normalized();
  }
  return tangents;
}

// Weighted mean, across the curve, of the samples merged into a vertex.
Eigen::Vector3d MeanPosition(const SampleSet& samples, int own, const std::vector<int>& merged) {
  const Eigen::Vector3d& position = samples.position[own];
  const Eigen::Vector3d& tangent = samples.tangent[own];
  const Eigen::Matrix<double, 3, 2> across = TangentFrame(tangent);
  const double weak = WeakInformation(samples.footprint[own]);
  Eigen::Matrix2d sum = weak * Eigen::Matrix2d::Identity();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const int s : merged) {
    const Eigen::Matrix2d weight = across.transpose() * samples.information[s] * across;
    sum += weight;
    right += weight * (across.transpose() * (samples.position[s] - position));
  }
  return position + across * sum.inverse() * right;
}

void SmoothLink(const DrawingOptions& options, DraftLink* link) {
  const auto tangents = Tangents(*link);
  link->position =
      SmoothCurve({link->position, tangents, link->information, link->footprint, link->closed},
                  options.bending_sigma_px, false);
}

}  // namespace

Draft FitLinks(const SampleSet& samples, const MergedCurves& merged,
               const DrawingOptions& options) {
  std::vector<std::vector<int>> merged_into(merged.vertex_sample.size());
  for (int s = 0; s < samples.NumSamples(); ++s) {
    if (merged.home[s] >= 0) merged_into[merged.home[s]].push_back(s);
  }
  Draft draft;
  draft.num_nodes = merged.num_nodes;
  draft.num_sketch_samples = samples.NumSamples();
  for (const LinkBuilder::Link& from : merged.links) {
    if (!from.alive || from.vertices.size() < 2) continue;
    DraftLink link;
    link.node[0] = from.node[0];
    link.node[1] = from.node[1];
    link.closed = from.closed;
    for (const int vertex : from.vertices) {
      const int own = merged.vertex_sample[vertex];
      link.position.push_back(MeanPosition(samples, own, merged_into[vertex]));
      link.information.push_back(samples.information[own]);
      link.footprint.push_back(samples.footprint[own]);
      link.samples.push_back(merged_into[vertex]);
    }
    SmoothLink(options, &link);
    draft.links.push_back(std::move(link));
  }
  return draft;
}

int64_t Draft::NumSketchSamples(const DraftLink& link) const {
  int64_t count = 0;
  for (const auto& of_point : link.samples) {
    count += std::count_if(of_point.begin(), of_point.end(),
                           [&](int s) { return s < num_sketch_samples; });
  }
  return count;
}

double ArcPx(const DraftLink& link, int from, int to) {
  double arc = 0;
  for (int i = from; i < to; ++i) {
    arc += (link.position[i + 1] - link.position[i]).norm() / link.footprint[i];
  }
  return arc;
}

double LengthPx(const DraftLink& link) { return ArcPx(link, 0, link.size() - 1); }

Eigen::Vector3d TangentAt(const DraftLink& link, int point) {
  const int last = link.size() - 1;
  return (link.position[std::min(point + 1, last)] - link.position[std::max(point - 1, 0)])
      .stableNormalized();
}

std::vector<int> ProbePoints(const DraftLink& link, int count) {
  const int step = std::max(1, (link.size() + count - 1) / count);
  std::vector<int> points;
  for (int k = 0; k < link.size(); k += step) points.push_back(k);
  return points;
}

EndLine LineAtEnd(const DraftLink& link, int end) {
  const int size = link.size();
  const auto at = [&](int k) { return end == 0 ? k : size - 1 - k; };
  EndLine line;
  line.point = link.position[at(0)];
  line.footprint = link.footprint[at(0)];
  std::vector<Eigen::Vector3d> points;
  double arc = 0;
  const double skip = LengthPx(link) > kLineSkipPx + kLineLengthPx ? kLineSkipPx : 0;
  for (int k = 0; k < size && arc <= skip + kLineLengthPx; ++k) {
    if (k > 0) arc += (link.position[at(k)] - link.position[at(k - 1)]).norm() / line.footprint;
    if (arc >= skip) points.push_back(link.position[at(k)]);
  }
  if (points.size() < 2) return line;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& point : points) mean += point / static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& point : points) scatter += (point - mean) * (point - mean).transpose();
  Eigen::Vector3d direction =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  if (direction.dot(points.front() - points.back()) < 0) direction = -direction;
  line.outward = direction;
  line.point = mean + direction * direction.dot(line.point - mean);
  return line;
}

void SplitLink(Draft* draft, int link, int index, int node) {
  DraftLink second;
  {
    DraftLink& first = draft->links[link];
    const auto tail = [&](auto& from, auto* to) {
      to->assign(from.begin() + index, from.end());
      from.resize(index + 1);
    };
    tail(first.position, &second.position);
    tail(first.information, &second.information);
    tail(first.footprint, &second.footprint);
    tail(first.samples, &second.samples);
    second.samples.front().clear();
    second.grown = first.grown;
    second.node[0] = node;
    second.node[1] = first.node[1];
    first.node[1] = node;
  }
  draft->links.push_back(std::move(second));
}

EndsAtNode CollectEnds(const Draft& draft) {
  EndsAtNode ends;
  for (size_t i = 0; i < draft.links.size(); ++i) {
    for (const int end : {0, 1}) {
      const int node = draft.links[i].node[end];
      if (node >= 0) ends[node].push_back({static_cast<int>(i), end});
    }
  }
  return ends;
}

void KeepLinks(const std::vector<uint8_t>& keep, Draft* draft) {
  std::vector<DraftLink> kept;
  for (size_t i = 0; i < draft->links.size(); ++i) {
    if (keep[i]) kept.push_back(std::move(draft->links[i]));
  }
  draft->links = std::move(kept);
  for (const auto& [node, ends] : CollectEnds(*draft)) {
    if (ends.size() == 1) draft->links[ends[0].link].node[ends[0].end] = -1;
  }
}

}  // namespace limn
