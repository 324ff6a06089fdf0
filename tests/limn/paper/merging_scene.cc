// SPDX-License-Identifier: BSD-3-Clause
#include "limn/paper/merging_scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <Eigen/Geometry>

#include "limn/paper/link_fitting.h"

namespace limn::testing {
namespace {

constexpr const char* kColors[] = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e"};

double Tenths(double value) { return std::round(10 * value) / 10; }

// A polyline in the xy plane, y up, moved down by `shift`, in the color of this number.
std::string SvgLine(const Polyline3d& points, bool closed, size_t number, double shift) {
  std::ostringstream out;
  out << (closed ? "<polygon" : "<polyline") << " stroke=\"" << kColors[number % 5]
      << "\" points=\"";
  for (size_t k = 0; k < points.size(); ++k) {
    if (k % 3 != 0 && k + 1 < points.size()) continue;
    out << Tenths(points[k].x()) << ',' << Tenths(shift - points[k].y()) << ' ';
  }
  out << "\"/>\n";
  return out.str();
}

}  // namespace

SampleSet MergingScene::MakeSampleSet() const {
  SampleSet samples;
  for (int link = 0; link < static_cast<int>(specs().size()); ++link) {
    const LinkTraits& traits = specs()[link].traits;
    samples.origins.push_back(
        {link, traits.first_sketch_sample, traits.views.front(), traits.closed});
    for (const Sample& sample : SamplesOf(link)) {
      samples.curve_of.push_back(link);
      samples.position.push_back(sample.position);
      samples.tangent.push_back(sample.tangent);
      samples.information.push_back(sample.information);
      samples.footprint.push_back(footprint());
      samples.support.Append(sample.support);
    }
    samples.curve_begin.push_back(samples.NumSamples());
  }
  return samples;
}

CurveConsistency MergingScene::MakeNetwork(const SampleSet& samples) const {
  CurveConsistency network;
  network.overlaps.resize(samples.NumCurves());
  network.cluster_of.assign(samples.NumCurves(), 0);
  for (const auto& [curve, cluster] : cluster_of_) network.cluster_of[curve] = cluster;
  for (const auto& [curve, other] : along_) {
    CurveOverlap overlap{other, {}};
    for (int k = 0; k < samples.Size(curve); ++k) {
      const Eigen::Vector3d& own = samples.position[samples.curve_begin[curve] + k];
      const auto first = samples.position.begin() + samples.curve_begin[other];
      const auto nearest =
          std::min_element(first, first + samples.Size(other),
                           [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
                             return (a - own).squaredNorm() < (b - own).squaredNorm();
                           });
      overlap.partner.push_back(static_cast<int>(nearest - samples.position.begin()));
    }
    network.overlaps[curve].push_back(std::move(overlap));
  }
  return network;
}

void MergingScene::WritePicture(const std::string& name) {
  const char* folder = std::getenv("LIMN_PICTURES");
  if (!folder) return;
  Eigen::AlignedBox2d box;
  for (const LinkSpec& spec : specs()) {
    for (const Eigen::Vector3d& point : spec.points)
      box.extend(Eigen::Vector2d(point.x(), -point.y()));
  }
  const double height = box.sizes().y() + 30;
  std::ofstream out(std::string(folder) + "/" + name + ".svg");
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << Tenths(2 * (box.sizes().x() + 30))
      << "\" viewBox=\"" << Tenths(box.min().x() - 15) << ' ' << Tenths(box.min().y() - 15) << ' '
      << Tenths(box.sizes().x() + 30) << ' ' << Tenths(2 * height)
      << "\">\n<g fill=\"none\" stroke-width=\"1.5\">\n";
  // Side by side, not one over the other.
  for (size_t i = 0; i < specs().size(); ++i) {
    out << SvgLine(specs()[i].points, specs()[i].traits.closed, i, -2.0 * static_cast<double>(i));
  }
  const Picture picture = Look();
  for (size_t i = 0; i < picture.links.size(); ++i) {
    out << SvgLine(picture.links[i].points, picture.links[i].closed, i, height);
  }
  out << "</g>\n";
  for (const Meeting& meeting : picture.meetings) {
    out << "<circle r=\"3\" cx=\"" << Tenths(meeting.position.x()) << "\" cy=\""
        << Tenths(height - meeting.position.y()) << "\"/>\n";
  }
  out << "</svg>\n";
}

MergingCounts MergingScene::Merge(const PaperOptions& options) {
  Make();
  const SampleSet samples = MakeSampleSet();
  const CurveConsistency network = MakeNetwork(samples);
  MergingCounts counts;
  DrawingGraph graph = MergeCurves(samples, network, views(), options, {}, &counts);
  FitLinks(samples, network, &graph);
  SetGraph(std::move(graph));
  return counts;
}

}  // namespace limn::testing
