// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "colmap_ext/host/console.h"
#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/pipeline/pipeline_options.h"

namespace limn::colmap_ext {

// The last stage of a shard.
enum class ShardStage { kCurves, kSketches };

// Options common to the commands that work on photographs.
struct RunOptions {
  LayoutOptions layout;
  ViewOptions view;
  PipelineOptions pipeline;
  DenseOptions dense;
  // Folder of edges of the images, to use instead of detected ones (see FindEdgeFiles). Empty =
  // detect them.
  std::string edges_path;
  RidgeOptions edge_maps;
  // The 3D box to reconstruct: x0,x1,y0,y1,z0,z1 in the model's unit. Empty = everything.
  std::vector<double> box;
  Quality quality = Quality::kMedium;
  int num_threads = -1;
  // From 2 on also what stages kept and dropped is printed.
  int log_level = 1;
  // Compute only this part of the views, "i/n", for the cache; empty = everything.
  std::string shard;
  ShardStage shard_stage = ShardStage::kSketches;
  // Rank 0 holds the lock on the output folder for this process. Not a user option.
  bool is_locked_by_rank_zero = false;
  // Replace results made with other options, from other images or not by limn.
  bool overwrite = false;
  // Bring the existing drawing up to date (limn/pipeline/update_scene.h).
  bool update = false;

  // Throws OptionError.
  void Check() const;
  // The same except for the paths, for a model in memory.
  void CheckValues() const;
  // Sets what follows from other options.
  void SetDerived();
};

// The default options of a command at a quality level.
RunOptions DefaultRunOptions(Quality quality);

// The option groups of a command, in addition to paths and selection.
struct OptionGroups {
  // Of image curves. Commands with these options, or with those of regularities, use images at the
  // size at which they are drawn (ViewOptions::max_scale), others as they are.
  bool linking = false;
  bool sketch = false;
  bool drawing = false;
  bool refinement = false;
  // The options of the drawing and the refinement that apply to editing and refitting some links of
  // a finished drawing.
  bool refit = false;
  bool regularities = false;
  bool surfaces = false;
  bool dense = false;
  bool tiles = false;
  // Has --output_cameras.
  bool output_cameras = false;
  // Has --shard.
  bool shards = false;
  // Writes files that may replace others, and has --overwrite.
  bool overwrites = false;
  // Help text of --output_path.
  const char* output_help = "where results go instead";
};

// The box x0,x1,y0,y1,z0,z1; nothing if there are no numbers. Throws OptionError.
std::optional<Eigen::AlignedBox3d> BoxFromNumbers(const std::vector<double>& numbers);

// Parses the command line of a command with run options. --quality sets the defaults of other
// options, which override it in any order. `add_more` declares further options; it is called twice.
// Returns the parser, for WriteIni, or nothing if help was printed. Throws OptionError and IoError.
std::optional<OptionParser> ParseRunOptions(
    const std::string& command, const std::string& summary, const OptionGroups& groups, int argc,
    const char* const* argv, RunOptions* options,
    const std::function<void(OptionParser*)>& add_more = {});

// Says which of the given options are fixed now, if any are (OptionParser::NoteOnRetired).
void SayRetired(const OptionParser& parser, Console* console);

}  // namespace limn::colmap_ext
