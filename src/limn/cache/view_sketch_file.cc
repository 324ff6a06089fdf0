// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/view_sketch_file.h"

#include <algorithm>
#include <cmath>

#include "limn/cache/packed_numbers.h"
#include "limn/cache/packed_support.h"
#include "limn/cache/stage_file.h"
#include "limn/sketch/fragment_rays.h"
#include "limn/sketch/sketch_of_depths.h"
#include "limn/util/byte_stream.h"

namespace limn {
namespace {

// What is found at a sample of a fragment: a reason why there is no depth, or one of these.
constexpr uint8_t kHasDepth = 64;
constexpr uint8_t kIsCertain = 32;

// The numbers of all depths.
struct DepthNumbers {
  std::vector<double> inverse_depth;
  std::vector<double> weight;
  std::vector<double> px_per_inverse_depth;
};

void PutDepths(const ViewDepths& depths, ByteWriter* out) {
  std::vector<uint8_t> is_long;
  std::vector<uint8_t> found;
  DepthNumbers numbers;
  for (const DepthProfile& profile : depths.of_fragment) {
    is_long.push_back(!profile.depths.empty());
    for (size_t i = 0; i < profile.depths.size(); ++i) {
      const FusedDepth& depth = profile.depths[i];
      if (!depth.has_depth) {
        found.push_back(static_cast<uint8_t>(profile.fates[i]));
        continue;
      }
      found.push_back(kHasDepth | (depth.certain ? kIsCertain : 0));
      numbers.inverse_depth.push_back(depth.inverse_depth);
      numbers.weight.push_back(depth.weight);
      numbers.px_per_inverse_depth.push_back(depth.px_per_inverse_depth);
    }
  }
  out->Put(depths.spacing_px);
  out->Put<int32_t>(depths.sample_step);
  PutPacked(is_long, out);
  PutPacked(found, out);
  PutPacked(numbers.inverse_depth, out);
  PutPacked(numbers.weight, out);
  PutPacked(numbers.px_per_inverse_depth, out);
}

class DepthReader {
 public:
  explicit DepthReader(ByteReader* in) : in_(*in) {
    spacing_px_ = in->Get<double>();
    in->Check(spacing_px_ > 0, "spacing of samples not positive");
    sample_step_ = in->Get<int32_t>();
    in->Check(sample_step_ > 0, "step of samples not positive");
    is_long_ = GetPacked<uint8_t>(in);
    found_ = GetPacked<uint8_t>(in);
    numbers_.inverse_depth = GetPacked<double>(in);
    numbers_.weight = GetPacked<double>(in);
    numbers_.px_per_inverse_depth = GetPacked<double>(in);
    in->Check(numbers_.weight.size() == numbers_.inverse_depth.size() &&
                  numbers_.px_per_inverse_depth.size() == numbers_.inverse_depth.size(),
              "not three numbers per depth");
  }

  ViewDepths DepthsOf(const View& view, const ImageCurves& curves) {
    in_.Check(is_long_.size() == curves.fragments.size(), "not the fragments of the view");
    ViewDepths depths;
    depths.spacing_px = spacing_px_;
    depths.sample_step = sample_step_;
    depths.of_fragment.resize(is_long_.size());
    for (size_t f = 0; f < is_long_.size(); ++f) {
      if (!is_long_[f]) continue;
      const FragmentRays fragment = MakeFragmentRays(view, curves, static_cast<int>(f));
      const size_t num_samples = SpacedVertices(fragment, spacing_px_).size();
      for (size_t i = 0; i < num_samples; ++i) Next(&depths.of_fragment[f]);
    }
    in_.Check(next_found_ == found_.size() && next_depth_ == numbers_.weight.size(),
              "depths of other fragments");
    return depths;
  }

 private:
  void Next(DepthProfile* profile) {
    in_.Check(next_found_ < found_.size(), "a sample without depth or reason");
    const uint8_t found = found_[next_found_++];
    FusedDepth& depth = profile->depths.emplace_back();
    if ((found & kHasDepth) == 0) {
      in_.Check(found < kNumEdgelFates, "unknown fate of an edgel");
      profile->fates.push_back(static_cast<EdgelFate>(found));
      return;
    }
    profile->fates.push_back(EdgelFate::kTooFewViews);  // means nothing
    in_.Check(next_depth_ < numbers_.weight.size(), "a depth without numbers");
    depth.has_depth = true;
    depth.certain = (found & kIsCertain) != 0;
    depth.inverse_depth = numbers_.inverse_depth[next_depth_];
    depth.weight = numbers_.weight[next_depth_];
    depth.px_per_inverse_depth = numbers_.px_per_inverse_depth[next_depth_];
    ++next_depth_;
    in_.Check(std::isfinite(depth.inverse_depth) && depth.weight >= 0 &&
                  !std::isnan(depth.px_per_inverse_depth),
              "depth is no number");
  }

  const ByteReader& in_;  // for messages
  double spacing_px_ = 0;
  int sample_step_ = 1;
  std::vector<uint8_t> is_long_;  // per fragment
  std::vector<uint8_t> found_;
  DepthNumbers numbers_;
  size_t next_found_ = 0;
  size_t next_depth_ = 0;
};

bool IsFiniteCurve(const Curve3D& curve) {
  const auto is_finite = [](const Eigen::Vector3d& vector) { return vector.allFinite(); };
  return std::ranges::all_of(curve.points_in_world, is_finite) &&
         std::ranges::all_of(curve.tangents_in_world, is_finite) &&
         std::ranges::all_of(curve.depth_sigma, [](double sigma) { return sigma >= 0; });
}

}  // namespace

void WriteViewSketch(const OutputPath& path, const ViewDepths& depths,
                     const std::vector<Curve3D>& sketched, const std::vector<ViewId>& depends_on,
                     const std::vector<ImageCurves>& curves, const std::string& identity) {
  ByteWriter out;
  PutDepths(depths, &out);
  PutPackedSupport(sketched, depends_on, curves, &out);
  WriteStageFile(path, StageKind::kViewSketch, identity, out.bytes());
}

std::optional<ViewSketch> ReadViewSketch(const std::string& path, ViewId id,
                                         const std::vector<ViewId>& depends_on,
                                         const std::vector<View>& views,
                                         const std::vector<ImageCurves>& curves,
                                         const std::string& identity) {
  const std::optional<std::string> payload = ReadStageFile(path, StageKind::kViewSketch, identity);
  if (!payload) return std::nullopt;
  ByteReader in(path, *payload);
  DepthReader depths(&in);
  ViewSketch sketch =
      SketchOfDepths(id, views[id], curves[id], depths.DepthsOf(views[id], curves[id]));
  in.Check(std::ranges::all_of(sketch.curves, IsFiniteCurve), "coordinate not finite");
  GetPackedSupport(depends_on, curves, &in, &sketch.curves);
  in.ExpectEnd();
  return sketch;
}

}  // namespace limn
