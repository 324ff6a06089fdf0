// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/run_report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "colmap_ext/host/world_shift.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/drawing_results.h"
#include "colmap_ext/verbs/page.h"
#include "colmap_ext/verbs/renew_page.h"
#include "limn/model/link_selection.h"
#include "limn/viewer/viewer_page.h"

namespace limn::colmap_ext {
namespace {

using Json = nlohmann::ordered_json;

// Links of more images are rare.
constexpr size_t kMaxSupportOfCurves = 12;

Json ToJson(const StageSummary::Counts& counts) {
  Json json = Json::object();
  for (const auto& [what, count] : counts) json[what] = count;
  return json;
}

Json StagesAsJson(const RunLog& log) {
  Json stages = Json::array();
  for (const RunLog::Stage& stage : log.stages) {
    stages.push_back({{"stage", stage.summary.stage},
                      {"seconds", stage.seconds},
                      {"peak_mb", stage.peak_memory_mb},
                      {"in", ToJson(stage.summary.in)},
                      {"kept", ToJson(stage.summary.kept)},
                      {"dropped", ToJson(stage.summary.dropped)}});
  }
  return stages;
}

// {"Group.option": value} of what differs.
Json ChangedOptions(const Json& options, const Json& defaults, const std::string& prefix = "") {
  Json changed = Json::object();
  for (const auto& [name, value] : options.items()) {
    const Json normal = defaults.value(name, Json());
    if (value.is_object() && normal.is_object()) {
      changed.update(ChangedOptions(value, normal, prefix + name + "."));
    } else if (value != normal) {
      changed[prefix + name] = value;
    }
  }
  return changed;
}

// By link, the images that support it.
std::vector<size_t> CountSupport(const ViewSet& set, const DrawingGraph& graph) {
  std::vector<size_t> counts;
  for (const DrawingLink& link : graph.links) {
    counts.push_back(set.CountImages(link.supporting_views));
  }
  return counts;
}

Json SupportHistogram(const std::vector<size_t>& support) {
  std::vector<int> counts;
  for (const size_t num_images : support) {
    counts.resize(std::max(counts.size(), num_images + 1));
    ++counts[num_images];
  }
  return counts;
}

CurveSet LinksOfImages(const DrawingGraph& graph, const std::vector<size_t>& support,
                       size_t min_images) {
  CurveSet set;
  for (size_t i = 0; i < support.size(); ++i) {
    if (support[i] >= min_images) set.polylines.push_back(graph.links[i].points_in_world);
  }
  return set;
}

Json OrNull(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

// All links, also tentative ones, but no rods: truths of curves hold their outlines.
LinkSelection LinksToEvaluate() {
  LinkSelection selection;
  selection.kinds.fill(true);
  selection.kinds[static_cast<int>(LinkKind::kRod)] = false;
  selection.tentative = true;
  return selection;
}

void AddEvaluation(const DrawingGraph& graph, const std::vector<size_t>& support,
                   const std::vector<View>& views, const TruthInput& input,
                   const RunContext& context, Json* report) {
  const Truth truth = ReadTruth(input);
  const bool in_footprints = input.unit == TruthInput::Unit::kFootprint;
  for (const TauResult& row : Evaluate(ToCurveSet(graph), truth, input, views, context).rows) {
    (*report)["evaluation"].push_back({{"tau", row.tau},
                                       {"unit", in_footprints ? "px" : ""},
                                       {"precision", OrNull(row.precision)},
                                       {"recall", OrNull(row.recall)},
                                       {"f", OrNull(row.f)}});
  }
  TruthInput quick = input;
  quick.evaluation.find_duplicates = false;
  Json& curves = (*report)["pr_curves"];
  for (const double tau : input.evaluation.taus) {
    curves.push_back({{"name", "within " + Json(tau).dump() + (in_footprints ? " px" : "")},
                      {"points", Json::array()}});
  }
  for (size_t min_images = 2; min_images <= kMaxSupportOfCurves; ++min_images) {
    const CurveSet kept = LinksOfImages(graph, support, min_images);
    if (kept.polylines.empty()) break;
    const EvaluationReport at = Evaluate(kept, truth, quick, views, context);
    for (size_t t = 0; t < at.rows.size(); ++t) {
      const TauResult& row = at.rows[t];
      if (!row.precision || !row.recall) continue;
      curves[t]["points"].push_back({*row.recall, *row.precision});
    }
  }
}

Json ToJson(const Trust& trust) {
  Json less = Json::array();
  for (const NamedNumber& image : trust.agree_less) {
    less.push_back({{"name", image.name}, {"share", image.number / 100}});
  }
  return {{"images", trust.num_images},
          {"explained", OrNull(trust.explained)},
          {"agree_less", less},
          {"many_views", kManyImages},
          {"well_seen", OrNull(trust.well_seen)},
          {"error_px", OrNull(trust.error_px)},
          {"error_90_px", OrNull(trust.error_90_px)},
          {"has_share_of_cameras", trust.has_share_of_cameras},
          {"right", OrNull(trust.right)},
          {"tentative", OrNull(trust.tentative)},
          {"unmeasured", OrNull(trust.unmeasured)},
          {"apart", trust.apart},
          {"shared_if_apart", trust.shared_if_apart},
          {"at_other_depths", OrNull(trust.at_other_depths)},
          {"still", OrNull(trust.still)}};
}

std::string RunReportJson(const Project& project, const RunOptions& options,
                          const std::string& drawing_path, const DrawingGraph& graph,
                          const std::vector<View>& views, const Trust& trust,
                          const TruthInput& truth, const Console& console) {
  const std::vector<size_t> support = CountSupport(project.view_set(), graph);
  Json report = {{"workspace", project.layout().description},
                 {"drawing", FingerprintOf(drawing_path)},
                 {"stages", StagesAsJson(console.log())},
                 {"warnings", console.log().warnings},
                 {"trust", ToJson(trust)},
                 {"options_changed", ChangedOptions(Json::parse(Provenance(options)),
                                                    Json::parse(Provenance(RunOptions())))},
                 {"support_histogram", SupportHistogram(support)}};
  if (truth.IsGiven()) {
    const DrawingGraph judged = Selected(graph, LinksToEvaluate());
    AddEvaluation(judged, CountSupport(project.view_set(), judged), views, truth, console.context(),
                  &report);
  }
  // Paths need not be UTF-8.
  return report.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void WritePageWithReport(const Project& project, const DrawingInScene& drawing,
                         const DrawerOptions& options, const Trust& trust, Console* console) {
  if (!HasViewerPage()) {
    console->Say("drawing.html is not written: this limn was built without the viewer");
    WarnOfOldPage(project, "this limn was built without the viewer", console);
    return;
  }
  // Truth files are in the model's coordinates.
  const std::string path = project.DrawingPath("drawing.json").string();
  std::string report = RunReportJson(
      project, options.run, path, Moved(drawing.graph, project.origin()),
      InImagePixels(Moved(drawing.views, project.origin())), trust, options.truth, *console);
  PageOptions page;
  page.detail = options.results.detail;
  auto cloud = MakeCloud(project, options.run.layout.workspace_path, page, console);
  auto thumbnails = MakeThumbnails(project, drawing.views, page.thumbnail_size, {}, console);
  WritePage(project, drawing, path, page,
            {std::move(cloud), std::move(thumbnails), std::move(report)}, console);
}

}  // namespace limn::colmap_ext
