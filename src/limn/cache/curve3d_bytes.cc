// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/curve3d_bytes.h"

#include <algorithm>
#include <vector>

#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr size_t kSampleBytes = 7 * sizeof(double) + 1 + sizeof(uint32_t);

void PutVector(const Eigen::Vector3d& vector, ByteWriter* out) {
  for (int axis = 0; axis < 3; ++axis) out->Put(vector[axis]);
}

Eigen::Vector3d GetVector(ByteReader* in) {
  Eigen::Vector3d vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = in->Get<double>();
  in->Check(vector.allFinite(), "coordinate not finite");
  return vector;
}

template <typename Item>
bool IsIndexOf(int32_t index, const std::vector<Item>& items) {
  return index >= 0 && static_cast<size_t>(index) < items.size();
}

// The edgels of the fragment that the curve was made from, in the order of its samples.
class AnchorEdgels {
 public:
  AnchorEdgels(const ByteReader& in, const CurveAnchor& anchor, size_t num_samples,
               const std::vector<ImageCurves>& curves)
      : anchor_(anchor) {
    const auto& fragments = curves[anchor.view].fragments;
    in.Check(IsIndexOf(anchor.fragment, fragments), "fragment out of range");
    ids_ = &fragments[anchor.fragment].edgel_ids;
    in.Check(anchor.step > 0, "step of samples not positive");
    const size_t most = (ids_->size() + anchor.step - 1) / anchor.step;
    in.Check(IsIndexOf(anchor.begin, *ids_) && num_samples <= most,
             "the curve is not in its fragment");
  }
  EdgelRef Of(size_t sample) const {
    return {anchor_.view, (*ids_)[anchor_.VertexOf(sample, ids_->size())]};
  }

 private:
  CurveAnchor anchor_;
  const std::vector<EdgelId>* ids_;
};

void GetSupport(ByteReader* in, const std::vector<ImageCurves>& curves, const EdgelRef& own,
                std::vector<EdgelRef>* of_sample) {
  of_sample->clear();
  const uint32_t count = in->Get<uint32_t>();
  for (uint32_t i = 0; i < count; ++i) {
    EdgelRef edgel;
    edgel.view = in->Get<int32_t>();
    edgel.edgel = in->Get<int32_t>();
    in->Check(IsIndexOf(edgel.view, curves), "view out of range");
    in->Check(IsIndexOf(edgel.edgel, curves[edgel.view].edge_map.edgels), "edgel id out of range");
    in->Check(of_sample->empty() || of_sample->back().view < edgel.view,
              "support not sorted by view");
    of_sample->push_back(edgel);
  }
  in->Check(std::ranges::find(*of_sample, own) != of_sample->end(),
            "a sample is not supported by its own edgel");
}

void CheckSizes(const Curve3D& curve) {
  const size_t count = curve.size();
  if (curve.tangents_in_world.size() != count || curve.depth_sigma.size() != count ||
      curve.certain.size() != count || curve.support.NumSamples() != count) {
    throw InputError("curve sketch: a curve's lists differ in length");
  }
}

}  // namespace

void PutCurve3d(const Curve3D& curve, ByteWriter* out) {
  CheckSizes(curve);
  out->Put<int32_t>(curve.anchor.view);
  out->Put<int32_t>(curve.anchor.fragment);
  out->Put<int32_t>(curve.anchor.begin);
  out->Put<int32_t>(curve.anchor.step);
  out->Put<uint8_t>(curve.closed);
  out->Put(curve.total_support);
  out->PutCount(curve.size());
  for (size_t i = 0; i < curve.size(); ++i) {
    PutVector(curve.points_in_world[i], out);
    PutVector(curve.tangents_in_world[i], out);
    out->Put(curve.depth_sigma[i]);
    out->Put<uint8_t>(curve.certain[i] != 0);
    out->Put<uint32_t>(static_cast<uint32_t>(curve.support.Of(i).size()));
    for (const EdgelRef& edgel : curve.support.Of(i)) {
      out->Put<int32_t>(edgel.view);
      out->Put<int32_t>(edgel.edgel);
    }
  }
}

Curve3D GetCurve3d(ByteReader* in, const std::vector<ImageCurves>& curves) {
  Curve3D curve;
  curve.anchor.view = in->Get<int32_t>();
  curve.anchor.fragment = in->Get<int32_t>();
  curve.anchor.begin = in->Get<int32_t>();
  curve.anchor.step = in->Get<int32_t>();
  in->Check(IsIndexOf(curve.anchor.view, curves), "view out of range");
  curve.closed = in->GetFlag();
  curve.total_support = in->Get<double>();
  in->Check(curve.total_support >= 0, "total support is negative or no number");
  const size_t count = in->GetCount(kSampleBytes);
  const AnchorEdgels own(*in, curve.anchor, count, curves);
  std::vector<EdgelRef> support;
  for (size_t i = 0; i < count; ++i) {
    curve.points_in_world.push_back(GetVector(in));
    curve.tangents_in_world.push_back(GetVector(in));
    curve.depth_sigma.push_back(in->Get<double>());
    in->Check(curve.depth_sigma.back() >= 0, "sigma is negative or no number");
    curve.certain.push_back(in->GetFlag());
    GetSupport(in, curves, own.Of(i), &support);
    curve.support.Append(support);
  }
  return curve;
}

}  // namespace limn
