// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/curve_sketch_file.h"

#include <nlohmann/json.hpp>

#include "limn/cache/curve3d_bytes.h"
#include "limn/cache/stage_file.h"
#include "limn/files/json_text.h"
#include "limn/util/byte_stream.h"

namespace limn {

void WriteCurveSketch(const OutputPath& path, const CurveSketch& sketch,
                      const DrawingMetadata& metadata, const std::string& identity) {
  ByteWriter out;
  out.PutString(metadata.refined_cameras);
  out.PutString(metadata.options_json);
  out.PutCount(metadata.view_names.size());
  for (const std::string& name : metadata.view_names) out.PutString(name);
  out.PutCount(sketch.curves.size());
  for (const Curve3D& curve : sketch.curves) PutCurve3d(curve, &out);
  WriteStageFile(path, StageKind::kCurveSketch, identity, out.bytes());
}

std::optional<StoredCurveSketch> ReadCurveSketch(const std::string& path,
                                                 const std::vector<ImageCurves>& curves,
                                                 const std::string& identity) {
  const std::optional<std::string> payload = ReadStageFile(path, StageKind::kCurveSketch, identity);
  if (!payload) return std::nullopt;
  ByteReader in(path, *payload);
  StoredCurveSketch stored;
  stored.metadata.refined_cameras = in.GetString();
  stored.metadata.options_json = in.GetString();
  in.Check(ParseJson(path, stored.metadata.options_json).is_object(),
           "the options are not an object");
  const size_t num_views = in.GetCount(sizeof(uint64_t));
  for (size_t i = 0; i < num_views; ++i) stored.metadata.view_names.push_back(in.GetString());
  in.Check(num_views == curves.size(), "made from another number of views");
  const size_t num_curves = in.GetCount(kCurve3dBytes);
  for (size_t i = 0; i < num_curves; ++i) {
    stored.sketch.curves.push_back(GetCurve3d(&in, curves));
  }
  in.ExpectEnd();
  return stored;
}

std::string RefinedCamerasOfSketch(const std::string& path) {
  return FirstTextOfStageFile(path, StageKind::kCurveSketch);
}

}  // namespace limn
