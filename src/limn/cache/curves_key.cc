// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/curves_key.h"

#include "limn/cache/content_hash.h"

namespace limn {
namespace {

void AddView(const View& view, ContentHash* hash) {
  const PinholeCamera& camera = view.camera;
  hash->AddText(view.name);
  for (const double value : {camera.fx, camera.fy, camera.cx, camera.cy}) hash->AddNumber(value);
  hash->AddNumber(camera.width);
  hash->AddNumber(camera.height);
  for (const double value : view.cam_from_world.rotation.coeffs()) hash->AddNumber(value);
  for (const double value : view.cam_from_world.translation) hash->AddNumber(value);
  const ImageRegion& region = view.region;
  for (const double value : region.min_px) hash->AddNumber(value);
  for (const double value : region.max_px) hash->AddNumber(value);
  hash->AddNumber(region.cell_px);
  hash->AddNumber(region.cols);
  hash->AddNumber(region.rows);
  hash->AddNumbers(region.valid);
}

void AddEdgel(const Edgel& edgel, ContentHash* hash) {
  for (int i = 0; i < 2; ++i) hash->AddWord(edgel.position_px[i]);
  hash->AddWord(edgel.tangent_rad);
  hash->AddWord(edgel.strength);
  hash->AddWord(edgel.position_sigma_px);
  for (int i = 0; i < 2; ++i) hash->AddWord(edgel.stored_px[i]);
  for (int i = 0; i < 4; ++i) hash->AddWord(edgel.stored_from_virtual(i / 2, i % 2));
}

void AddFragments(const std::vector<CurveFragment>& fragments, ContentHash* hash) {
  for (const CurveFragment& fragment : fragments) {
    hash->AddNumber(fragment.closed);
    hash->AddNumbers(fragment.edgel_ids);
  }
}

}  // namespace

std::string BoxKey(const std::optional<Eigen::AlignedBox3d>& box) {
  ContentHash hash;
  if (box) {
    for (const double value : box->min()) hash.AddNumber(value);
    for (const double value : box->max()) hash.AddNumber(value);
  }
  return hash.Hex();
}

std::string ViewKey(const View& view, const ImageCurves& curves) {
  ContentHash hash;
  AddView(view, &hash);
  hash.AddNumber(curves.edge_map.edgels.size());
  for (const Edgel& edgel : curves.edge_map.edgels) AddEdgel(edgel, &hash);
  AddFragments(curves.fragments, &hash);
  return hash.Hex();
}

std::vector<std::string> ViewKeys(const std::vector<View>& views,
                                  const std::vector<ImageCurves>& curves,
                                  const RunContext& context) {
  std::vector<std::string> keys(views.size());
  ParallelFor(context, "keys", views.size(),
              [&](size_t v) { keys[v] = ViewKey(views[v], curves[v]); });
  return keys;
}

std::string CurvesKey(const std::vector<View>& views, const std::vector<ImageCurves>& curves,
                      const RunContext& context) {
  ContentHash hash;
  for (const std::string& key : ViewKeys(views, curves, context)) hash.AddText(key);
  return hash.Hex();
}

std::string StoredCurvesKey(const std::vector<ImageCurves>& curves) {
  ContentHash hash;
  for (const ImageCurves& of_view : curves) {
    hash.AddNumber(of_view.edge_map.edgels.size());
    for (const Edgel& edgel : of_view.edge_map.edgels) {
      for (int i = 0; i < 2; ++i) hash.AddWord(edgel.stored_px[i]);
    }
    AddFragments(of_view.fragments, &hash);
  }
  return hash.Hex();
}

}  // namespace limn
