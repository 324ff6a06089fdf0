// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "bench/data_sets.h"
#include "bench/json.h"
#include "colmap_ext/host/console.h"

namespace limn::bench {

struct ReportOptions {
  // Results go to <output_path>/<name of the set>/.
  std::string output_path;
  // Default options only, no sweep.
  bool quick = false;
  // Longer side of the images, px; -1 = as stored, 0 = as by default.
  int max_image_size = 0;
};

// Everything the report says of one data set:
//   name, plot, unit, taus, boxes (names), num_views, num_held_out
//   seconds            of the image curves that it measures by, unless they were cached
//   ceiling            {box: [recall per tau]}, null without truth
//   runs               [{method, threshold_name, threshold (null: default options), seconds,
//                        cpu_seconds, shape, truth: {box: report}}]; those with default options
//                        have also emap and held_out, and only their times are those of the
//                        command: others may find image curves in a cache
//   peers              [{method, shape, truth: {box: report}}] of stored results of other programs
//   missing_peers      files of such results that are not there
// Writes drawings, pictures and the list of images that are not held out. `on_run` hears of all
// this so far after every run. Throws IoError, InputError, OptionError and Cancelled.
void MeasureSet(const DataSet& set, const ReportOptions& options, colmap_ext::Console* console,
                const std::function<void(const Json& so_far)>& on_run);

}  // namespace limn::bench
