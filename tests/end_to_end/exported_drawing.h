// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"
#include "limn/model/alignment.h"
#include "limn/model/drawing_graph.h"

namespace limn::testing {

// A drawing.json in a folder of its own, exported by `limn drawing_exporter` and read back by
// programs that are not ours.
class ExportedDrawing {
 public:
  explicit ExportedDrawing(const DrawingGraph& graph,
                           const std::optional<Alignment>& alignment = std::nullopt);

  std::string Path(const std::string& name) const { return (dir_ / name).string(); }

  // Fails the test if limn does.
  void Export(const std::string& name, const std::vector<std::string>& more = {}) const;
  LimnRun TryExport(const std::string& name, const std::vector<std::string>& more = {}) const;

  // What tests/scripts/readers/<script> prints of the file: the JSON of its last line.
  nlohmann::json Read(const std::string& script, const std::string& name) const;
  // What read_in_programs.py there prints of a program that reads the file.
  nlohmann::json ReadIn(const std::string& program, const std::string& name) const;
  // As Read, run inside Blender.
  nlohmann::json ReadInBlender(const std::string& script, const std::string& name) const;

  const TempDir& dir() const { return dir_; }

 private:
  TempDir dir_;
};

// The length by the primitive where there is one, else by the points; summed finely, far within
// 1e-7 of the whole.
double ShapeLength(const DrawingLink& link);

Eigen::Vector3d ToPoint(const nlohmann::json& json);

}  // namespace limn::testing
