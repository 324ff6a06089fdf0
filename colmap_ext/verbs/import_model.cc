// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/import_model.h"

#include <string>
#include <vector>

#include "colmap_ext/import/new_model_folder.h"

namespace limn::colmap_ext {

void RunImporter(const ImporterOptions& options, Console* console) {
  CheckNewModelFolder(options.output_path);
  std::vector<std::string> notes;
  const ImportedModel imported = ImportModel(options, &notes);
  const SparseModel& model = imported.model;
  for (const std::string& note : notes) console->Say(note);
  for (const std::string& warning : model.warnings) console->Say("WARNING: " + warning);
  WriteNewModel(model, options.output_path, options.output_type, [&](const OutputPath& folder) {
    if (imported.masks.empty()) return;
    WriteMaskList(imported.masks, options.output_path, folder);
  });
  console->Say("Written: " + options.output_path + " with " + std::to_string(model.cameras.size()) +
               " cameras, " + std::to_string(model.images.size()) + " images, " +
               std::to_string(model.points.size()) + " points");
}

}  // namespace limn::colmap_ext
