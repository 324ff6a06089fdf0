#pragma once

#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/run_options.h"
#include "limn/editing/apply_edits.h"
#include "limn/editing/edits.h"

namespace limn::colmap_ext {

// Edits made by hand to a drawing, in the model's coordinates.
struct EditsFile {
  std::vector<Edit> edits;
  std::string content_hash;
};

// Reads an edits.json (json_edits_reader.h). Throws OptionError if the path is empty, and IoError.
EditsFile ReadEdits(const std::string& path);

// Throws OptionError for options that do not apply to edits.
void CheckEditorOptions(const RunOptions& options);

// Provenance of a drawing that was edited.
std::string EditProvenance(const EditsFile& file, const std::string& drawing_provenance);

// Reports how many edits were applied. Warns, with their index in the file, about those that were
// not or only partly applied, and about other changes to the drawing.
void SayEdits(const std::vector<Edit>& edits, const EditedDrawing& edited, Console* console);

}  // namespace limn::colmap_ext
