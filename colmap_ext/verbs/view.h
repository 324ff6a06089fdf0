// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/verbs/page.h"
#include "colmap_ext/verbs/verb.h"

namespace limn::colmap_ext {

// drawing_viewer: a page that shows a stored drawing.
class ViewVerb : public Verb {
 public:
  OptionGroups Groups() const override { return {.overwrites = true}; }
  void AddOptions(OptionParser* parser) override;
  void Prepare(RunOptions* options, Console* console) override;
  std::vector<std::string> StartsFrom(const RunOptions& options) const override;
  void Run(const Project& project, const RunOptions& options, Console* console) override;

 private:
  // Empty: the newest drawing in the output folder.
  std::string drawing_path_;
  // JSON file for the tab Report; empty: the report of the page that is replaced.
  std::string report_path_;
  PageOptions page_;
  // The text of the report; empty if none is given.
  std::string report_json_;
};

}  // namespace limn::colmap_ext
