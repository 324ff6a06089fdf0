// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/verbs/drawing_verb.h"
#include "limn/editing/edits.h"
#include "limn/model/drawing_stamp.h"

namespace limn::colmap_ext {

// drawing_editor: the drawing with the edits of an edits.json (json_edits_reader.h), and the links
// that they touch fitted to the images again.
class EditVerb : public DrawingVerb {
 public:
  OptionGroups Groups() const override {
    return {.linking = true, .refit = true, .overwrites = true};
  }
  bool HasOwnOptions() const override { return true; }
  void AddOptions(OptionParser* parser) override;
  void Prepare(RunOptions* options, Console* console) override;
  std::string Provenance(const RunOptions& options, const std::string& before) const override;
  DrawingInScene Apply(const Job& job, const DrawingInScene& given) override;

 private:
  std::string edits_path_;
  std::vector<Edit> edits_;  // in the model's coordinates
  DrawingStamp of_page_;
  std::string content_hash_;
};

}  // namespace limn::colmap_ext
