// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/packed_support.h"

#include <algorithm>
#include <span>

#include "limn/util/errors.h"

namespace limn {
namespace {

// A sample and, of the edgel of a view that supports it, its place along the view's fragments.
struct PlaceAtSample {
  size_t sample = 0;
  int place = -1;
};

// Per edgel, its place along the fragments; -1: in none.
std::vector<int> PlacesAlongFragments(const ImageCurves& curves) {
  std::vector<int> places(curves.edge_map.edgels.size(), -1);
  const std::vector<EdgelId> edgels = EdgelsAlongFragments(curves);
  for (size_t i = 0; i < edgels.size(); ++i) places[edgels[i]] = static_cast<int>(i);
  return places;
}

// Runs of successive samples: how many are left out before, how many there are, and their places.
void PutRuns(std::span<const PlaceAtSample> places, StepWriter* out) {
  size_t next = 0;
  for (size_t begin = 0; begin < places.size();) {
    size_t end = begin + 1;
    while (end < places.size() && places[end].sample == places[end - 1].sample + 1) ++end;
    out->PutUnsigned(end - begin);
    out->PutUnsigned(places[begin].sample - next);
    for (size_t i = begin; i < end; ++i) out->Put(places[i].place);
    next = places[end - 1].sample + 1;
    begin = end;
  }
  out->PutUnsigned(0);
}

class SupportWriter {
 public:
  SupportWriter(const std::vector<ViewId>& views, const std::vector<ImageCurves>& curves)
      : views_(views), of_view_(views.size()) {
    for (const ViewId view : views) places_.push_back(PlacesAlongFragments(curves[view]));
  }

  void Put(const Curve3D& curve) {
    for (std::vector<PlaceAtSample>& of_view : of_view_) of_view.clear();
    for (size_t s = 0; s < curve.size(); ++s) {
      for (const EdgelRef& ref : curve.support.Of(s)) {
        if (ref.view != curve.anchor.view) of_view_[CountOf(ref.view)].push_back({s, PlaceOf(ref)});
      }
    }
    for (size_t v = 0; v < views_.size(); ++v) {
      if (of_view_[v].empty()) continue;
      steps_.PutUnsigned(v + 1);
      PutRuns(of_view_[v], &steps_);
    }
    steps_.PutUnsigned(0);
  }

  void Finish(ByteWriter* out) const { steps_.Finish(out); }

 private:
  size_t CountOf(ViewId view) const {
    const auto found = std::ranges::lower_bound(views_, view);
    if (found == views_.end() || *found != view) throw InputError("support by an unknown view");
    return static_cast<size_t>(found - views_.begin());
  }
  int PlaceOf(const EdgelRef& ref) const {
    const std::vector<int>& places = places_[CountOf(ref.view)];
    const bool is_in_fragment =
        ref.edgel >= 0 && static_cast<size_t>(ref.edgel) < places.size() && places[ref.edgel] >= 0;
    if (!is_in_fragment) throw InputError("support by an edgel of no fragment");
    return places[ref.edgel];
  }

  const std::vector<ViewId>& views_;
  std::vector<std::vector<int>> places_;             // per view
  std::vector<std::vector<PlaceAtSample>> of_view_;  // of the curve at hand
  StepWriter steps_;
};

class SupportReader {
 public:
  SupportReader(const std::vector<ViewId>& views, const std::vector<ImageCurves>& curves,
                ByteReader* in)
      : in_(*in), steps_(in), views_(views), of_view_(views.size()) {
    for (const ViewId view : views) {
      edgels_.push_back(view < 0 ? std::vector<EdgelId>() : EdgelsAlongFragments(curves[view]));
    }
  }

  // `own` are the edgels of the fragment that the curve was made from.
  void Get(const std::vector<EdgelId>& own, Curve3D* curve) {
    for (std::vector<EdgelId>& of_view : of_view_) of_view.clear();
    for (size_t next = 0;;) {
      const uint64_t v = steps_.GetUnsigned();
      if (v == 0) break;
      in_.Check(v > next && v <= views_.size(), "support not sorted by view");
      next = v;
      GetRuns(v - 1, curve->size());
    }
    for (size_t s = 0; s < curve->size(); ++s) {
      Append(s, own[curve->anchor.VertexOf(s, own.size())], curve);
    }
    curve->support.edgels.shrink_to_fit();
  }

  void ExpectEnd() const { steps_.ExpectEnd(); }

 private:
  void GetRuns(size_t v, size_t num_samples) {
    of_view_[v].assign(num_samples, kInvalidEdgel);
    for (size_t next = 0;;) {
      const uint64_t count = steps_.GetUnsigned();
      if (count == 0) return;
      const uint64_t gap = steps_.GetUnsigned();
      in_.Check(gap < num_samples - next && count <= num_samples - next - gap,
                "support beyond the last sample");
      next += gap;
      for (const size_t end = next + count; next < end; ++next) of_view_[v][next] = GetEdgel(v);
    }
  }

  EdgelId GetEdgel(size_t v) {
    const int64_t place = steps_.Get();
    if (views_[v] < 0) return kInvalidEdgel;
    in_.Check(place >= 0 && place < std::ssize(edgels_[v]), "edgel id out of range");
    return edgels_[v][place];
  }

  void Append(size_t sample, EdgelId own, Curve3D* curve) {
    std::vector<EdgelRef>& edgels = curve->support.edgels;
    for (size_t v = 0; v < views_.size(); ++v) {
      const bool is_own = views_[v] == curve->anchor.view;
      const EdgelId edgel = is_own                ? own
                            : of_view_[v].empty() ? kInvalidEdgel
                                                  : of_view_[v][sample];
      if (edgel != kInvalidEdgel) edgels.push_back({views_[v], edgel});
    }
    curve->support.offsets.push_back(static_cast<uint32_t>(edgels.size()));
  }

  const ByteReader& in_;  // for messages
  StepReader steps_;
  const std::vector<ViewId>& views_;
  std::vector<std::vector<EdgelId>> edgels_;   // per view, along its fragments
  std::vector<std::vector<EdgelId>> of_view_;  // of the curve at hand: per sample, or empty
};

}  // namespace

std::vector<EdgelId> EdgelsAlongFragments(const ImageCurves& curves) {
  std::vector<EdgelId> edgels;
  for (const CurveFragment& fragment : curves.fragments) {
    edgels.insert(edgels.end(), fragment.edgel_ids.begin(), fragment.edgel_ids.end());
  }
  return edgels;
}

void PutPackedSupport(const std::vector<Curve3D>& sketched, const std::vector<ViewId>& views,
                      const std::vector<ImageCurves>& curves, ByteWriter* out) {
  SupportWriter writer(views, curves);
  for (const Curve3D& curve : sketched) writer.Put(curve);
  writer.Finish(out);
}

void GetPackedSupport(const std::vector<ViewId>& views, const std::vector<ImageCurves>& curves,
                      ByteReader* in, std::vector<Curve3D>* sketched) {
  SupportReader reader(views, curves, in);
  for (Curve3D& curve : *sketched) {
    const ImageCurves& of_view = curves[curve.anchor.view];
    reader.Get(of_view.fragments[curve.anchor.fragment].edgel_ids, &curve);
  }
  reader.ExpectEnd();
}

}  // namespace limn
