// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/workspace/layout.h"
#include "limn/cache/result_cache.h"
#include "limn/files/output_lock.h"
#include "limn/files/output_path.h"

namespace limn::colmap_ext {

// The locked folder that a run writes to.
class OutputFolder {
 public:
  // Writes only the lock file, which keeps other commands (for a shard: all except other shards)
  // out of the folder during the lifetime of this object. Removes temporary files of a killed run,
  // unless other shards may be running. Throws IoError, also if one of the folders, or anything in
  // the folder of curves, is a link.
  OutputFolder(const OutputLayout& output, const RunOptions& options, Console* console);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  // Image curves and sketches stored for later runs.
  ResultCache* cache() const { return cache_.get(); }
  // Path of a file beside fused.ply.
  OutputPath DrawingPath(const std::string& name) const;
  // Path of a file in the folder of curves.
  OutputPath CurvesPath(const std::string& name) const;

 private:
  OutputLayout output_;
  std::optional<OutputLock> lock_;
  std::shared_ptr<ResultCache> cache_;
};

}  // namespace limn::colmap_ext
