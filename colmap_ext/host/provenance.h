// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/host/run_options.h"

namespace limn::colmap_ext {

// The options that a result depends on, as the text of a JSON object: no paths, no thread count.
std::string Provenance(const RunOptions& options);

// What a verb does to the provenance of the drawing that it is given: a row of the table of verbs.
struct ProvenanceKeys {
  // Groups of options, or single ones, that the result depends on from now on.
  std::vector<const char*> taken;
  // What the result no longer depends on: null.
  std::vector<const char*> dropped;
};

std::string ProvenanceAfter(const std::string& before, const ProvenanceKeys& keys,
                            const RunOptions& options);

// Whether a result with this provenance was made in a box.
bool HasBox(const std::string& provenance);

}  // namespace limn::colmap_ext
