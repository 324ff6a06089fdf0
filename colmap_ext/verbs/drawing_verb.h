// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "colmap_ext/host/job.h"
#include "colmap_ext/host/provenance.h"
#include "colmap_ext/verbs/drawing_in_scene.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/verb.h"

namespace limn::colmap_ext {

// A verb that makes a drawing of a drawing: for a command of one that is stored, for Python of one
// in memory. A new one says what Groups and ProvenanceRow are, and does its work in Apply.
class DrawingVerb : public Verb {
 public:
  // Whether it has options that no later verb knows, so that they end with it.
  virtual bool HasOwnOptions() const { return false; }
  // Whether it adds to what is known of a drawing, whose graph stays as it is.
  virtual bool KeepsGraph() const { return false; }

  // The provenance of what it makes, with these options, of a drawing with provenance `before`.
  virtual std::string Provenance(const RunOptions& options, const std::string& before) const;

  // The work. The provenance of the result is set by the caller. Throws InputError, Cancelled, and
  // what reading the photographs throws.
  virtual DrawingInScene Apply(const Job& job, const DrawingInScene& given) = 0;

  // What is said when the result is safe: by default the warnings again.
  virtual void Conclude(const Job& job, const DrawingInScene& given, const DrawingInScene& made);

  // By default --drawing_path and ResultOptions.
  void AddFileOptions(OptionParser* parser) override;

  bool WritesDrawing() const override { return true; }

  std::vector<std::string> StartsFrom(const RunOptions& options) const override;

  // Of drawing.json in the output folder, with the classes that drawing-fused.json has for its
  // links, or of the drawing of --drawing_path; in the latter case the result must not replace
  // another drawing.
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 protected:
  virtual ProvenanceKeys ProvenanceRow() const { return {}; }
  virtual void CheckFiles(const Project& project, const RunOptions& options) const;
  virtual void CheckReplaces(const Project& project, const RunOptions& options,
                             const std::string& provenance) const;
  virtual void Write(const Job& job, const Project& project, const DrawingInScene& made);

  void AddDrawingPath(const char* help, OptionParser* parser);
  const std::string& drawing_path() const { return drawing_path_; }

 private:
  std::string drawing_path_;
  ResultOptions results_;
};

// Those of the drawing, or else found in the images.
std::shared_ptr<const std::vector<ImageCurves>> CurvesOf(const Job& job,
                                                         const DrawingInScene& drawing);

}  // namespace limn::colmap_ext
