// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/edit.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/edit_report.h"
#include "limn/belief/node_covariance.h"
#include "limn/cache/content_hash.h"
#include "limn/editing/apply_edits.h"
#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_edits_reader.h"
#include "limn/pipeline/refit_edited.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

using Json = nlohmann::ordered_json;

// What became of the edits, and of what else is in the drawing.
void SayEdits(const std::vector<Edit>& edits, const EditedDrawing& edited, Console* console) {
  for (const std::string& line : LinesOfEdits(edits, edited.outcomes)) console->Say(line);
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

// Edits name links by their course, so that they can be for another state of the drawing.
void SayOtherDrawing(const DrawingStamp& of_page, const DrawingInScene& given, Console* console) {
  const bool is_known = !of_page.fingerprint.empty() && !given.fingerprint.empty();
  if (!is_known || of_page.fingerprint == given.fingerprint) return;
  if (of_page.name == kFusedDrawing) return;  // the same links, with classes
  const std::string name = of_page.name.empty() ? "another drawing" : Printable(of_page.name);
  console->Say("WARNING: the edits were made in a page of " + name +
               " as it is no longer, or of another folder: what they name is looked for by its "
               "course");
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
  EditsFile file = ParseJsonEdits(edits_path_, text);
  edits_ = std::move(file.edits);
  of_page_ = std::move(file.drawing);
  content_hash_ = hash.Hex();
}

std::string EditVerb::Provenance(const RunOptions&, const std::string& before) const {
  Json json = ParseJson("options of the drawing", before);
  json["edits"].push_back(content_hash_);
  return json.dump();
}

DrawingInScene EditVerb::Apply(const Job& job, const DrawingInScene& given) {
  SayOtherDrawing(of_page_, given, job.console);
  EditedDrawing edited = ApplyEdits(given.graph, given.views, Moved(edits_, -job.scene.origin()),
                                    job.options.pipeline.drawing.topology);
  auto curves = given.curves;
  if (HasTouched(edited)) {
    curves = CurvesOf(job, given);
    job.console->Report(RefitEdited({given.views, *curves}, job.scene.images().read,
                                    job.options.pipeline, job.context(), &edited));
  } else {
    MeasureNodes(given.views, job.context(), &edited.graph);  // some have other links
  }
  SayEdits(edits_, edited, job.console);
  CheckGraph(edited.graph);
  return {std::move(edited.graph), given.metadata, given.views, std::move(curves)};
}

}  // namespace limn::colmap_ext
