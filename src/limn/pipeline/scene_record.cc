// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/scene_record.h"

#include <cstdint>
#include <sstream>
#include <utility>

#include "limn/cache/curves_key.h"
#include "limn/cache/packed_numbers.h"
#include "limn/cache/stage_file.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/json_drawing_writer.h"
#include "limn/pipeline/sketch_views.h"
#include "limn/util/byte_stream.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr const char* kRecordName = "drawing";
// To be incremented when the drawing of the same input changes.
constexpr int kRecordVersion = 9;

DrawingMetadata NamesIn(const SceneRecord& record) {
  DrawingMetadata metadata;
  for (const RecordedView& view : record.views) metadata.view_names.push_back(view.name);
  return metadata;
}

void PutViews(const std::vector<RecordedView>& views, ByteWriter* out) {
  out->PutCount(views.size());
  for (const RecordedView& view : views) {
    out->PutString(view.name);
    out->PutString(view.key);
  }
}

std::vector<RecordedView> GetViews(ByteReader* in) {
  std::vector<RecordedView> views;
  const size_t num_views = in->GetCount(2 * sizeof(uint64_t));
  for (size_t i = 0; i < num_views; ++i) {
    RecordedView& view = views.emplace_back();
    view.name = in->GetString();
    view.key = in->GetString();
  }
  return views;
}

// Views, sketches, and the drawing as JSON.
std::string ToBytes(const SceneRecord& record) {
  ByteWriter out;
  PutViews(record.views, &out);
  out.PutCount(record.sketches.size());
  for (const RecordedSketch& sketch : record.sketches) {
    out.Put<int32_t>(sketch.place);
    out.PutString(sketch.key);
    PutViews(sketch.views, &out);
  }
  PutViews(record.drawn_views, &out);
  std::ostringstream drawing;
  WriteDrawingJson(record.graph, NamesIn(record), drawing);
  PutPackedText(drawing.str(), &out);
  return out.bytes();
}

SceneRecord FromBytes(const std::string& path, const std::string& bytes) {
  ByteReader in(path, bytes);
  SceneRecord record;
  record.views = GetViews(&in);
  const size_t num_sketches = in.GetCount(sizeof(int32_t) + 2 * sizeof(uint64_t));
  for (size_t i = 0; i < num_sketches; ++i) {
    RecordedSketch& sketch = record.sketches.emplace_back();
    sketch.place = in.Get<int32_t>();
    sketch.key = in.GetString();
    sketch.views = GetViews(&in);
    in.Check(sketch.place >= 0 && sketch.place < std::ssize(sketch.views),
             "a sketch without its view");
  }
  record.drawn_views = GetViews(&in);
  DrawingFile drawing = ParseDrawingJson(path, GetPackedText(&in));
  in.ExpectEnd();
  in.Check(drawing.metadata.view_names == NamesIn(record).view_names, "a drawing of other views");
  record.graph = std::move(drawing.graph);
  return record;
}

}  // namespace

std::string RecordKey(const PipelineOptions& options,
                      const std::optional<Eigen::AlignedBox3d>& box) {
  PipelineOptions relevant = options;
  relevant.regularity = {};
  relevant.surfaces = {};
  relevant.tiles = {};
  return "scene, version " + std::to_string(kRecordVersion) + "." + std::to_string(kSketchVersion) +
         "\n" + OptionsAsJson(relevant) + "\nbox " + BoxKey(box);
}

void KeepRecord(const SceneRecord& record, const std::string& key, ResultCache* cache) {
  cache->Store(CachedKind::kScene, kRecordName, [&](const OutputPath& path) {
    WriteStageFile(path, StageKind::kSceneRecord, key, ToBytes(record));
  });
}

std::optional<SceneRecord> FindRecord(const std::string& key, const ResultCache& cache) {
  return cache.Read<SceneRecord>(
      CachedKind::kScene, kRecordName, [&](const std::string& path) -> std::optional<SceneRecord> {
        const auto bytes = ReadStageFile(path, StageKind::kSceneRecord, key);
        if (!bytes) return std::nullopt;
        return FromBytes(path, *bytes);
      });
}

}  // namespace limn
