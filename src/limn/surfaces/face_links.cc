// SPDX-License-Identifier: BSD-3-Clause
#include "limn/surfaces/face_links.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "limn/model/footprint.h"
#include "limn/model/link_selection.h"

namespace limn {
namespace {

constexpr double kSpacingPx = 4;
constexpr size_t kMaxSamples = 50;

// Evenly along the link; enough to distinguish planes from lines.
Polyline3d SamplesOf(const DrawingLink& link, double footprint) {
  const double length = Length(link.points_in_world);
  const double spacing =
      std::max(kSpacingPx * footprint, length / static_cast<double>(kMaxSamples - 1));
  return ResampleUniform(link.points_in_world, std::min(spacing, length / 2));
}

// Directions and distances of the samples.
void MeasureShape(FaceLink* link) {
  for (const Eigen::Vector3d& sample : link->samples) link->center += sample;
  link->center /= static_cast<double>(link->samples.size());
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& sample : link->samples) {
    const Eigen::Vector3d offset = (sample - link->center) / link->footprint;
    moments += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  link->normal = solver.eigenvectors().col(0);
  link->direction = solver.eigenvectors().col(2);
  for (const Eigen::Vector3d& sample : link->samples) {
    const Eigen::Vector3d offset = (sample - link->center) / link->footprint;
    const double along = offset.dot(link->direction);
    link->bend_px = std::max(link->bend_px, (offset - along * link->direction).norm());
    link->twist_px = std::max(link->twist_px, std::abs(offset.dot(link->normal)));
  }
}

}  // namespace

std::vector<FaceLink> MeasureFaceLinks(const DrawingGraph& graph, const std::vector<View>& views,
                                       const SurfaceOptions& options) {
  const LinkSelection selection = LinkSelection::AsSeen();
  std::vector<FaceLink> links;
  for (size_t id = 0; id < graph.links.size(); ++id) {
    const DrawingLink& link = graph.links[id];
    if (!selection.Has(link)) continue;
    FaceLink measured;
    measured.link = static_cast<LinkId>(id);
    measured.footprint = LinkFootprint(link, views);
    if (!(measured.footprint > 0)) continue;
    measured.length_px = Length(link.points_in_world) / measured.footprint;
    if (measured.length_px < options.min_length_px) continue;
    measured.samples = SamplesOf(link, measured.footprint);
    MeasureShape(&measured);
    links.push_back(std::move(measured));
  }
  return links;
}

bool LiesIn(const FaceLink& link, const Eigen::Vector3d& normal, double offset,
            double tolerance_px) {
  return std::ranges::all_of(link.samples, [&](const Eigen::Vector3d& sample) {
    return std::abs(normal.dot(sample) - offset) <= tolerance_px * link.footprint;
  });
}

}  // namespace limn
