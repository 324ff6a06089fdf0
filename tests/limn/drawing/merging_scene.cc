#include "limn/drawing/merging_scene.h"

#include <algorithm>

#include "limn/drawing/link_fitting.h"

namespace limn::testing {

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

MergingCounts MergingScene::Merge(const DrawingOptions& options) {
  Make();
  const SampleSet samples = MakeSampleSet();
  const CurveConsistency network = MakeNetwork(samples);
  MergingCounts counts;
  DrawingGraph graph = MergeCurves(samples, network, views(), options, {}, &counts);
  FitLinks(samples, network, options, &graph);
  SetGraph(std::move(graph));
  return counts;
}

}  // namespace limn::testing
