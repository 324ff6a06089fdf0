#include "limn/cache/image_curves_file.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "limn/cache/stage_file.h"
#include "limn/util/byte_stream.h"

namespace limn {
namespace {

constexpr size_t kStoredEdgelBytes = 3 * sizeof(double) + 2 * sizeof(float);

// Before ApplyLens the place in the stored image is the position, and nothing needs to be told of
// it.
bool IsAsStored(const Edgel& edgel) {
  return edgel.stored_px == edgel.position_px.cast<float>() &&
         edgel.stored_from_virtual == Eigen::Matrix2f::Identity();
}

void PutEdgel(const Edgel& edgel, bool as_stored, ByteWriter* out) {
  out->Put(edgel.position_px.x());
  out->Put(edgel.position_px.y());
  out->Put(edgel.tangent_rad);
  out->Put(edgel.strength);
  out->Put(edgel.position_sigma_px);
  if (as_stored) return;
  out->Put(edgel.stored_px.x());
  out->Put(edgel.stored_px.y());
  for (int i = 0; i < 4; ++i) out->Put(edgel.stored_from_virtual(i / 2, i % 2));
}

Edgel GetEdgel(bool as_stored, ByteReader* in) {
  Edgel edgel;
  edgel.position_px.x() = in->Get<double>();
  edgel.position_px.y() = in->Get<double>();
  edgel.tangent_rad = in->Get<double>();
  edgel.strength = in->Get<float>();
  edgel.position_sigma_px = in->Get<float>();
  edgel.stored_px = edgel.position_px.cast<float>();
  if (!as_stored) {
    edgel.stored_px.x() = in->Get<float>();
    edgel.stored_px.y() = in->Get<float>();
    for (int i = 0; i < 4; ++i) edgel.stored_from_virtual(i / 2, i % 2) = in->Get<float>();
  }
  in->Check(edgel.position_px.allFinite() && std::isfinite(edgel.tangent_rad) &&
                std::isfinite(edgel.strength) && !std::isnan(edgel.position_sigma_px) &&
                edgel.stored_px.allFinite() && edgel.stored_from_virtual.allFinite(),
            "edgel not finite");
  return edgel;
}

void PutEdgeMap(const EdgeMap& map, ByteWriter* out) {
  out->Put<int32_t>(map.width);
  out->Put<int32_t>(map.height);
  out->Put(map.gradient_noise);
  out->Put<int32_t>(map.num_outside_lens);
  const bool as_stored = std::all_of(map.edgels.begin(), map.edgels.end(), IsAsStored);
  out->Put<uint8_t>(as_stored);
  out->PutCount(map.edgels.size());
  for (const Edgel& edgel : map.edgels) PutEdgel(edgel, as_stored, out);
  out->PutCount(map.texture.size());
  for (const EdgelId id : map.texture) out->Put<int32_t>(id);
}

EdgelId GetEdgelId(ByteReader* in, size_t num_edgels) {
  const EdgelId id = in->Get<int32_t>();
  in->Check(id >= 0 && static_cast<size_t>(id) < num_edgels, "edgel id out of range");
  return id;
}

std::vector<EdgelId> GetTexture(ByteReader* in, size_t num_edgels) {
  const size_t count = in->GetCount(sizeof(int32_t));
  std::vector<EdgelId> texture;
  texture.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    const EdgelId id = GetEdgelId(in, num_edgels);
    in->Check(texture.empty() || texture.back() < id, "edgels of texture not ascending");
    texture.push_back(id);
  }
  return texture;
}

EdgeMap GetEdgeMap(ByteReader* in) {
  EdgeMap map;
  map.width = in->Get<int32_t>();
  map.height = in->Get<int32_t>();
  in->Check(map.width >= 0 && map.height >= 0, "negative image size");
  map.gradient_noise = in->Get<double>();
  in->Check(std::isfinite(map.gradient_noise), "noise not finite");
  map.num_outside_lens = in->Get<int32_t>();
  const bool as_stored = in->GetFlag();
  const size_t count = in->GetCount(kStoredEdgelBytes);
  map.edgels.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    map.edgels.push_back(GetEdgel(as_stored, in));
    in->Check(IsNearImage(map.width, map.height, map.edgels.back().position_px),
              "edgel outside the image");
  }
  map.texture = GetTexture(in, count);
  return map;
}

CurveFragment GetFragment(ByteReader* in, size_t num_edgels) {
  CurveFragment fragment;
  fragment.closed = in->GetFlag();
  const size_t count = in->GetCount(sizeof(int32_t));
  fragment.edgel_ids.reserve(count);
  for (size_t i = 0; i < count; ++i) fragment.edgel_ids.push_back(GetEdgelId(in, num_edgels));
  return fragment;
}

EdgelLink GetLink(ByteReader* in, size_t num_edgels) {
  EdgelLink link;
  link.a = GetEdgelId(in, num_edgels);
  link.b = GetEdgelId(in, num_edgels);
  link.votes = in->Get<int32_t>();
  in->Check(link.a < link.b, "link of the link graph not ascending");
  return link;
}

}  // namespace

void WriteImageCurves(const std::string& path, const ImageCurves& curves,
                      const std::string& identity) {
  ByteWriter out;
  PutEdgeMap(curves.edge_map, &out);
  out.PutCount(curves.fragments.size());
  for (const CurveFragment& fragment : curves.fragments) {
    out.Put<uint8_t>(fragment.closed);
    out.PutCount(fragment.edgel_ids.size());
    for (const EdgelId id : fragment.edgel_ids) out.Put<int32_t>(id);
  }
  out.PutCount(curves.link_graph.size());
  for (const EdgelLink& link : curves.link_graph) {
    out.Put<int32_t>(link.a);
    out.Put<int32_t>(link.b);
    out.Put<int32_t>(link.votes);
  }
  WriteStageFile(path, StageKind::kImageCurves, identity, out.bytes());
}

std::optional<ImageCurves> ReadImageCurves(const std::string& path, const std::string& identity) {
  const std::optional<std::string> payload = ReadStageFile(path, StageKind::kImageCurves, identity);
  if (!payload) return std::nullopt;
  ByteReader in(path, *payload);
  ImageCurves curves;
  curves.edge_map = GetEdgeMap(&in);
  const size_t num_edgels = curves.edge_map.edgels.size();
  const size_t num_fragments = in.GetCount(1 + sizeof(uint64_t));
  curves.fragments.reserve(num_fragments);
  for (size_t i = 0; i < num_fragments; ++i) {
    curves.fragments.push_back(GetFragment(&in, num_edgels));
  }
  const size_t num_links = in.GetCount(3 * sizeof(int32_t));
  curves.link_graph.reserve(num_links);
  for (size_t i = 0; i < num_links; ++i) {
    const EdgelLink link = GetLink(&in, num_edgels);
    const EdgelLink* last = curves.link_graph.empty() ? nullptr : &curves.link_graph.back();
    in.Check(!last || std::tie(last->a, last->b) < std::tie(link.a, link.b),
             "link graph not sorted");
    curves.link_graph.push_back(link);
  }
  in.ExpectEnd();
  return curves;
}

}  // namespace limn
