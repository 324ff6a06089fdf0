// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "limn/cache/result_cache.h"
#include "limn/model/drawing_graph.h"
#include "limn/model/view.h"
#include "limn/pipeline/pipeline_options.h"

namespace limn {

struct RecordedView {
  std::string name;
  std::string key;  // ViewKey
};

// A sketch in the cache. Its file counts views by their places in `views`: the view itself and
// those in its plan, some of which may have gone since.
struct RecordedSketch {
  ViewId place = -1;  // of the view itself
  std::string key;
  std::vector<RecordedView> views;

  const std::string& ViewName() const { return views[place].name; }
};

// What a drawing was made from, stored with it so that it can be brought up to date.
struct SceneRecord {
  std::vector<RecordedView> views;       // that the supporting views of links are places in
  std::vector<RecordedSketch> sketches;  // of the primary views
  // Of the last drawing made from scratch.
  std::vector<RecordedView> drawn_views;
  DrawingGraph graph;
};

// Everything else that the drawing depends on: options, box and versions.
std::string RecordKey(const PipelineOptions& options,
                      const std::optional<Eigen::AlignedBox3d>& box);

void KeepRecord(const SceneRecord& record, const std::string& key, ResultCache* cache);

// Nothing if there is no record with this key. Throws IoError if the file is damaged.
std::optional<SceneRecord> FindRecord(const std::string& key, const ResultCache& cache);

}  // namespace limn
