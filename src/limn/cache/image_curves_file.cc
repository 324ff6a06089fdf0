// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/image_curves_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "limn/cache/packed_numbers.h"
#include "limn/cache/stage_file.h"
#include "limn/util/byte_stream.h"

namespace limn {
namespace {

// Before ApplyLens the place in the stored image is the position, and nothing needs to be told of
// it.
bool IsAsStored(const Edgel& edgel) {
  return edgel.stored_px == edgel.position_px.cast<float>() &&
         edgel.stored_from_virtual == Eigen::Matrix2f::Identity();
}

// The same number of all edgels.
template <typename Get>
void PutNumbers(const std::vector<Edgel>& edgels, const Get& get, ByteWriter* out) {
  std::vector<decltype(get(Edgel()))> numbers;
  numbers.reserve(edgels.size());
  for (const Edgel& edgel : edgels) numbers.push_back(get(edgel));
  PutPacked(numbers, out);
}

template <typename T, typename Set>
void GetNumbers(ByteReader* in, std::vector<Edgel>* edgels, const Set& set) {
  const std::vector<T> numbers = GetPacked<T>(in);
  in->Check(numbers.size() == edgels->size(), "not a number per edgel");
  for (size_t i = 0; i < numbers.size(); ++i) {
    in->Check(!std::isnan(numbers[i]), "an edgel that is no number");
    set(&(*edgels)[i], numbers[i]);
  }
}

void PutEdgels(const std::vector<Edgel>& edgels, ByteWriter* out) {
  const bool as_stored = std::ranges::all_of(edgels, IsAsStored);
  out->Put<uint8_t>(as_stored);
  PutNumbers(
      edgels, [](const Edgel& e) { return e.position_px.x(); }, out);
  PutNumbers(
      edgels, [](const Edgel& e) { return e.position_px.y(); }, out);
  PutNumbers(
      edgels, [](const Edgel& e) { return e.tangent_rad; }, out);
  PutNumbers(
      edgels, [](const Edgel& e) { return e.strength; }, out);
  PutNumbers(
      edgels, [](const Edgel& e) { return e.position_sigma_px; }, out);
  if (as_stored) return;
  PutNumbers(
      edgels, [](const Edgel& e) { return e.stored_px.x(); }, out);
  PutNumbers(
      edgels, [](const Edgel& e) { return e.stored_px.y(); }, out);
  for (int i = 0; i < 4; ++i) {
    PutNumbers(
        edgels, [i](const Edgel& e) { return e.stored_from_virtual(i / 2, i % 2); }, out);
  }
}

bool IsFiniteEdgel(const Edgel& edgel) {
  return edgel.position_px.allFinite() && std::isfinite(edgel.tangent_rad) &&
         std::isfinite(edgel.strength) && edgel.stored_px.allFinite() &&
         edgel.stored_from_virtual.allFinite();
}

std::vector<Edgel> GetEdgels(ByteReader* in) {
  const bool as_stored = in->GetFlag();
  const std::vector<double> x = GetPacked<double>(in);
  std::vector<Edgel> edgels(x.size());
  for (size_t i = 0; i < x.size(); ++i) edgels[i].position_px.x() = x[i];
  GetNumbers<double>(in, &edgels, [](Edgel* e, double y) { e->position_px.y() = y; });
  GetNumbers<double>(in, &edgels, [](Edgel* e, double rad) { e->tangent_rad = rad; });
  GetNumbers<float>(in, &edgels, [](Edgel* e, float strength) { e->strength = strength; });
  GetNumbers<float>(in, &edgels, [](Edgel* e, float px) { e->position_sigma_px = px; });
  if (as_stored) {
    for (Edgel& edgel : edgels) edgel.stored_px = edgel.position_px.cast<float>();
  } else {
    GetNumbers<float>(in, &edgels, [](Edgel* e, float px) { e->stored_px.x() = px; });
    GetNumbers<float>(in, &edgels, [](Edgel* e, float px) { e->stored_px.y() = px; });
    for (int i = 0; i < 4; ++i) {
      GetNumbers<float>(in, &edgels,
                        [i](Edgel* e, float px) { e->stored_from_virtual(i / 2, i % 2) = px; });
    }
  }
  in->Check(std::ranges::all_of(edgels, IsFiniteEdgel), "edgel not finite");
  return edgels;
}

void PutEdgeMap(const EdgeMap& map, ByteWriter* out) {
  out->Put<int32_t>(map.width);
  out->Put<int32_t>(map.height);
  out->Put(map.gradient_noise);
  out->Put<int32_t>(map.num_outside_lens);
  PutEdgels(map.edgels, out);
}

EdgeMap GetEdgeMap(ByteReader* in) {
  EdgeMap map;
  map.width = in->Get<int32_t>();
  map.height = in->Get<int32_t>();
  in->Check(map.width >= 0 && map.height >= 0, "negative image size");
  map.gradient_noise = in->Get<double>();
  in->Check(std::isfinite(map.gradient_noise), "noise not finite");
  map.num_outside_lens = in->Get<int32_t>();
  map.edgels = GetEdgels(in);
  for (const Edgel& edgel : map.edgels) {
    in->Check(IsNearImage(map.width, map.height, edgel.position_px), "edgel outside the image");
  }
  return map;
}

// Texture and fragments.
void PutIds(const ImageCurves& curves, ByteWriter* out) {
  StepWriter ids;
  ids.PutUnsigned(curves.edge_map.texture.size());
  for (const EdgelId id : curves.edge_map.texture) ids.Put(id);
  ids.PutUnsigned(curves.fragments.size());
  for (const CurveFragment& fragment : curves.fragments) {
    ids.PutUnsigned(fragment.closed);
    ids.PutUnsigned(fragment.edgel_ids.size());
    for (const EdgelId id : fragment.edgel_ids) ids.Put(id);
  }
  ids.Finish(out);
}

EdgelId GetEdgelId(const ByteReader& in, size_t num_edgels, StepReader* ids) {
  const int64_t id = ids->Get();
  in.Check(id >= 0 && static_cast<size_t>(id) < num_edgels, "edgel id out of range");
  return static_cast<EdgelId>(id);
}

CurveFragment GetFragment(const ByteReader& in, size_t num_edgels, StepReader* ids) {
  CurveFragment fragment;
  const uint64_t closed = ids->GetUnsigned();
  in.Check(closed <= 1, "a flag is neither 0 nor 1");
  fragment.closed = closed == 1;
  const size_t count = ids->GetCount();
  fragment.edgel_ids.reserve(count);
  for (size_t i = 0; i < count; ++i) fragment.edgel_ids.push_back(GetEdgelId(in, num_edgels, ids));
  return fragment;
}

void GetIds(ByteReader* in, ImageCurves* curves) {
  const size_t num_edgels = curves->edge_map.edgels.size();
  StepReader ids(in);
  std::vector<EdgelId>& texture = curves->edge_map.texture;
  const size_t num_in_texture = ids.GetCount();
  texture.reserve(num_in_texture);
  for (size_t i = 0; i < num_in_texture; ++i) {
    const EdgelId id = GetEdgelId(*in, num_edgels, &ids);
    in->Check(texture.empty() || texture.back() < id, "edgels of texture not ascending");
    texture.push_back(id);
  }
  const size_t num_fragments = ids.GetCount();
  curves->fragments.reserve(num_fragments);
  for (size_t i = 0; i < num_fragments; ++i) {
    curves->fragments.push_back(GetFragment(*in, num_edgels, &ids));
  }
  ids.ExpectEnd();
}

}  // namespace

void WriteImageCurves(const OutputPath& path, const ImageCurves& curves,
                      const std::string& identity) {
  ByteWriter out;
  PutEdgeMap(curves.edge_map, &out);
  PutIds(curves, &out);
  out.Put<int32_t>(curves.num_unlinked);
  WriteStageFile(path, StageKind::kImageCurves, identity, out.bytes());
}

std::optional<ImageCurves> ReadImageCurves(const std::string& path, const std::string& identity) {
  const std::optional<std::string> payload = ReadStageFile(path, StageKind::kImageCurves, identity);
  if (!payload) return std::nullopt;
  ByteReader in(path, *payload);
  ImageCurves curves;
  curves.edge_map = GetEdgeMap(&in);
  GetIds(&in, &curves);
  curves.num_unlinked = in.Get<int32_t>();
  in.Check(curves.num_unlinked >= 0, "a negative number of edgels");
  in.ExpectEnd();
  return curves;
}

}  // namespace limn
