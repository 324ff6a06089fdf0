#include "limn/drawing/sketch_samples.h"

#include "limn/model/footprint.h"

namespace limn {
namespace {

double FootprintOf(const Curve3D& curve, size_t s, const std::vector<View>& views) {
  std::vector<ViewId> supporting;
  for (const EdgelRef& ref : curve.support.Of(s)) supporting.push_back(ref.view);
  const double footprint = MedianFootprint(curve.points_in_world[s], supporting, views);
  return footprint > 0 ? footprint : PixelFootprint(views, curve.points_in_world[s]);
}

SampleArrays ArraysOf(const Curve3D& curve, const std::vector<View>& views) {
  SampleArrays arrays;
  arrays.position = curve.points_in_world;
  arrays.tangent = curve.tangents_in_world;
  for (size_t s = 0; s < curve.size(); ++s) {
    const double footprint = FootprintOf(curve, s, views);
    const Eigen::Vector3d& tangent = curve.tangents_in_world[s];
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - tangent * tangent.transpose();
    arrays.footprint.push_back(footprint);
    arrays.information.push_back(across / (footprint * footprint));
  }
  return arrays;
}

}  // namespace

SampleSet TakeSamples(const CurveSketch& sketch, const TopologyInput& images) {
  SampleSet samples;
  for (size_t c = 0; c < sketch.curves.size(); ++c) {
    const Curve3D& curve = sketch.curves[c];
    if (curve.size() < 2) continue;
    AppendCurve(ArraysOf(curve, images.views), curve.support, 0, static_cast<int>(curve.size()),
                {static_cast<int>(c), 0, curve.anchor.view, curve.closed}, &samples);
  }
  return samples;
}

}  // namespace limn
