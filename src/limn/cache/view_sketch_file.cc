#include "limn/cache/view_sketch_file.h"

#include "limn/cache/stage_file.h"
#include "limn/util/byte_stream.h"

namespace limn {

void WriteViewSketch(const std::string& path, const ViewSketch& sketch,
                     const std::string& identity) {
  ByteWriter out;
  out.PutCount(sketch.curves.size());
  for (const Curve3D& curve : sketch.curves) PutCurve3d(curve, &out);
  out.PutCount(sketch.fates.size());
  for (const EdgelFate fate : sketch.fates) out.Put(static_cast<uint8_t>(fate));
  WriteStageFile(path, StageKind::kViewSketch, identity, out.bytes());
}

std::optional<ViewSketch> ReadViewSketch(const std::string& path, ViewId view,
                                         const CurvesOfViews& curves, const std::string& identity) {
  const std::optional<std::string> payload = ReadStageFile(path, StageKind::kViewSketch, identity);
  if (!payload) return std::nullopt;
  ByteReader in(path, *payload);
  ViewSketch sketch;
  const size_t num_curves = in.GetCount(kCurve3dBytes);
  sketch.curves.reserve(num_curves);
  for (size_t i = 0; i < num_curves; ++i) {
    sketch.curves.push_back(GetCurve3d(&in, curves));
    in.Check(sketch.curves.back().anchor.view == view, "a curve of another view");
  }
  const size_t num_edgels = in.GetCount(1);
  in.Check(num_edgels == curves[view]->edge_map.edgels.size(), "not one fate per edgel");
  sketch.fates.reserve(num_edgels);
  for (size_t i = 0; i < num_edgels; ++i) {
    const uint8_t fate = in.Get<uint8_t>();
    in.Check(fate < kNumEdgelFates, "unknown fate of an edgel");
    sketch.fates.push_back(static_cast<EdgelFate>(fate));
  }
  in.ExpectEnd();
  return sketch;
}

}  // namespace limn
