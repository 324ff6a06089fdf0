#include "colmap_ext/verbs/edit.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "limn/cache/content_hash.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_edits_reader.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using Json = nlohmann::ordered_json;

const char* StatusName(EditStatus status) {
  switch (status) {
    case EditStatus::kApplied:
      return "";
    case EditStatus::kPartly:
      return "applied in part: ";
    case EditStatus::kNotFound:
      return "not found: ";
    case EditStatus::kAmbiguous:
      return "ambiguous: ";
    case EditStatus::kNoSense:
      return "makes no sense: ";
  }
  return "";
}

}  // namespace

EditsFile ReadEdits(const std::string& path) {
  if (path.empty()) throw OptionError("--edits must be given");
  const std::string text = ReadWholeFile(path, kMaxJsonBytes);
  ContentHash hash;
  hash.AddText(text);
  return {ParseJsonEdits(path, text), hash.Hex()};
}

void CheckEditorOptions(const RunOptions& options) {
  if (!options.pipeline.refinement.refine_poses) return;
  throw OptionError(
      "DrawingRefinement.refine_poses = 1: edits do not move cameras; drawing_refiner does");
}

std::string EditProvenance(const EditsFile& file, const std::string& drawing_provenance) {
  Json json = Json::parse(drawing_provenance);
  json["edits"].push_back(file.content_hash);
  return json.dump();
}

void SayEdits(const std::vector<Edit>& edits, const EditedDrawing& edited, Console* console) {
  const auto& outcomes = edited.outcomes;
  const auto count = [&](EditStatus status) {
    return std::to_string(std::ranges::count(outcomes, status, &EditOutcome::status));
  };
  console->Say("edits: " + std::to_string(edits.size()) + "; applied " +
               count(EditStatus::kApplied) + ", in part " + count(EditStatus::kPartly) +
               ", not found " + count(EditStatus::kNotFound) + ", ambiguous " +
               count(EditStatus::kAmbiguous) + ", without sense " + count(EditStatus::kNoSense));
  for (size_t e = 0; e < edits.size(); ++e) {
    const auto& [status, text, warning] = outcomes[e];
    const std::string name = "edits[" + std::to_string(e) + "] (" + EditName(edits[e]) + "): ";
    const bool is_applied = status == EditStatus::kApplied;
    console->Say((is_applied ? "" : "WARNING: ") + name + StatusName(status) + text);
    if (!warning.empty()) console->Say("WARNING: " + name + warning);
  }
  if (edited.num_dropped_faces > 0) {
    console->Say("WARNING: the drawing has no faces any more (" +
                 std::to_string(edited.num_dropped_faces) + " before): run drawing_surfacer again");
  }
  const bool was_regular = !edited.graph.regularities.IsEmpty();
  if (was_regular && HasTouched(edited)) {
    console->Say(
        "Links that were fitted again follow no regularities: drawing_regularizer finds "
        "them anew");
  }
}

}  // namespace limn::colmap_ext
