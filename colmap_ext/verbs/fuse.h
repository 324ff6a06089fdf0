// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/verbs/dense_input.h"
#include "colmap_ext/verbs/drawing_verb.h"
#include "limn/dense/fuse_drawing.h"

namespace limn::colmap_ext {

// drawing_fuser: the drawing with the classes of its links by dense results. Writes
// drawing-fused.{ply,json,obj} and, as far as the dense results allow, with-curves/,
// pmvs-with-curves.{patch,ply} and sparse-with-curves/; prints the meshers' commands.
class FuseVerb : public DrawingVerb {
 public:
  OptionGroups Groups() const override { return {.dense = true, .overwrites = true}; }
  bool HasOwnOptions() const override { return true; }
  void AddOptions(OptionParser* parser) override;
  void AddFileOptions(OptionParser* parser) override;
  void Prepare(RunOptions* options, Console* console) override;
  std::string Provenance(const RunOptions& options, const std::string& before) const override;
  DrawingInScene Apply(const Job& job, const DrawingInScene& given) override;
  void Conclude(const Job&, const DrawingInScene&, const DrawingInScene&) override {}

 protected:
  // Clouds and models bear no mark: they are ours beside a drawing-fused.json.
  void CheckFiles(const Project& project, const RunOptions& options) const override;
  void CheckReplaces(const Project& project, const RunOptions& options,
                     const std::string& provenance) const override;
  void Write(const Job& job, const Project& project, const DrawingInScene& made) override;

 private:
  DenseOptionsPaths paths_;
  bool remove_occluded_ = false;
  int sparse_spacing_px_ = 4;
  // Of the last Apply.
  DenseInput dense_;
  std::vector<CurvePoint> points_;
};

// Colors every point from the photograph of the first of its views.
void ColorCurvePoints(const Scene& scene, const RunContext& context,
                      std::vector<CurvePoint>* points);

}  // namespace limn::colmap_ext
