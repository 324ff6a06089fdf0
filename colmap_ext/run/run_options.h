#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/workspace/layout.h"
#include "colmap_ext/workspace/to_views.h"
#include "limn/pipeline/pipeline_options.h"

namespace limn::colmap_ext {

// How far a shard goes.
enum class ShardStage { kCurves, kSketches };

// What the commands that work on photographs have in common.
struct RunOptions {
  LayoutOptions layout;
  ViewOptions view;
  PipelineOptions pipeline;
  DenseOptions dense;
  // The 3D box to reconstruct: x0,x1,y0,y1,z0,z1 in the model's unit. Empty = everything.
  std::vector<double> box;
  Quality quality = Quality::kMedium;
  int num_threads = -1;
  // Do only this part of the views, "i/n", into the cache; empty = everything.
  std::string shard;
  ShardStage shard_stage = ShardStage::kSketches;
  // Another process holds the lock of the output folder for this one. Not an option of users.
  bool is_led = false;
  // Replace a drawing that was made in another way.
  bool overwrite = false;

  // Throws OptionError.
  void Check() const;
};

// Groups of options a command has beside paths and selection.
struct OptionGroups {
  bool linking = false;
  bool sketch = false;
  bool drawing = false;
  bool refinement = false;
  bool dense = false;
  bool tiles = false;
  // It can do a part of its work, and has --shard.
  bool shards = false;
  // It writes a drawing, and has --overwrite.
  bool writes_drawing = false;
  // What --output_path is for.
  const char* output_help = "where results go instead";
};

// "x0,x1,y0,y1,z0,z1" as a box; nothing if there are no numbers. Throws OptionError.
std::optional<Eigen::AlignedBox3d> BoxFromNumbers(const std::vector<double>& numbers);

// Parse the command line of a command with run options. The level of quality sets the defaults that
// single options override, wherever they stand. `add_more` declares further options; it is called
// twice. Returns the parser, for WriteIni, or nothing when help was asked for and printed. Throws
// OptionError and IoError.
std::optional<OptionParser> ParseRunOptions(
    const std::string& command, const std::string& summary, const OptionGroups& groups, int argc,
    const char* const* argv, RunOptions* options,
    const std::function<void(OptionParser*)>& add_more = {});

}  // namespace limn::colmap_ext
