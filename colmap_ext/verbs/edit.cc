#include "colmap_ext/verbs/edit.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "limn/cache/content_hash.h"
#include "limn/editing/apply_edits.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_edits_reader.h"
#include "limn/pipeline/refit_edited.h"
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

// How many edits were applied; warns, with their index in the file, of those that were not or only
// in part, and of what else has become of the drawing.
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
    console->Say("WARNING: the drawing has no faces left (" +
                 std::to_string(edited.num_dropped_faces) + " before): run drawing_surfacer again");
  }
  const bool was_regular = !edited.graph.regularities.IsEmpty();
  if (was_regular && HasTouched(edited)) {
    console->Say(
        "Links that were fitted again follow no regularities: drawing_regularizer finds "
        "them anew");
  }
}

}  // namespace

void EditVerb::AddOptions(OptionParser* parser) {
  parser->AddOption("edits", &edits_path_, BasicOption("edits.json, as made in drawing.html"));
}

void EditVerb::Prepare(RunOptions*, Console*) {
  if (edits_path_.empty()) throw OptionError("--edits must be given");
  const std::string text = ReadWholeFile(edits_path_, kMaxJsonBytes);
  ContentHash hash;
  hash.AddText(text);
  edits_ = ParseJsonEdits(edits_path_, text);
  content_hash_ = hash.Hex();
}

std::string EditVerb::Provenance(const RunOptions&, const std::string& before) const {
  Json json = ParseJson("options of the drawing", before);
  json["edits"].push_back(content_hash_);
  return json.dump();
}

DrawingInScene EditVerb::Apply(const Job& job, const DrawingInScene& given) {
  EditedDrawing edited = ApplyEdits(given.graph, given.views, Moved(edits_, -job.scene.origin()),
                                    job.options.pipeline.drawing.topology);
  auto curves = given.curves;
  if (HasTouched(edited)) {
    curves = CurvesOf(job, given);
    job.console->Report(RefitEdited({given.views, *curves}, job.scene.images().read,
                                    job.options.pipeline, job.context(), &edited));
  }
  SayEdits(edits_, edited, job.console);
  CheckGraph(edited.graph);
  return {std::move(edited.graph), given.metadata, given.views, std::move(curves)};
}

}  // namespace limn::colmap_ext
