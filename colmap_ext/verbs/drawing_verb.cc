// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/drawing_verb.h"

#include <array>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <system_error>

#include "colmap_ext/verbs/drawing_input.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Of the same links.
void TakeClasses(const DrawingGraph& classified, DrawingGraph* graph) {
  using Ends = std::array<double, 6>;
  const auto ends_of = [](const Polyline3d& points) {
    const Eigen::Vector3d &a = points.front(), &b = points.back();
    return Ends{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
  };
  std::multimap<Ends, const DrawingLink*> known;
  for (const DrawingLink& link : classified.links) {
    known.emplace(ends_of(link.points_in_world), &link);
  }
  for (DrawingLink& link : graph->links) {
    const auto [begin, end] = known.equal_range(ends_of(link.points_in_world));
    for (auto other = begin; other != end; ++other) {
      const bool is_same = other->second->points_in_world == link.points_in_world;
      if (is_same && !link.dense) link.dense = other->second->dense;
    }
  }
}

// What drawing_fuser has found of the links of a drawing that are still the same.
void TakeClasses(const Project& project, const fs::path& fused, Console* console,
                 DrawingGraph* graph) {
  std::error_code ignored;
  if (!fs::is_regular_file(fused, ignored)) return;
  try {
    TakeClasses(ReadDrawingInScene(project, fused.string()).graph, graph);
  } catch (const std::runtime_error& error) {
    console->Say(std::string("WARNING: classes of links are not kept: ") + error.what());
  }
}

}  // namespace

std::string DrawingVerb::Provenance(const RunOptions& options, const std::string& before) const {
  return ProvenanceAfter(before, ProvenanceRow(), options);
}

void DrawingVerb::Conclude(const Job& job, const DrawingInScene&, const DrawingInScene&) {
  job.console->RepeatWarnings();
}

void DrawingVerb::AddFileOptions(OptionParser* parser) {
  AddDrawingPath("drawing.json to start from, instead of the one in the output folder", parser);
  results_.AddOptions(parser);
}

void DrawingVerb::AddDrawingPath(const char* help, OptionParser* parser) {
  parser->AddOption("drawing_path", &drawing_path_, BasicOption(help));
}

void DrawingVerb::CheckFiles(const Project& project, const RunOptions& options) const {
  CheckDrawingFiles(project, options);
}

void DrawingVerb::CheckReplaces(const Project& project, const RunOptions& options,
                                const std::string& provenance) const {
  if (!drawing_path_.empty()) CheckReplaceable(project, options, "drawing.json", provenance);
}

void DrawingVerb::Write(const Job& job, const Project& project, const DrawingInScene& made) {
  WriteDrawingResults(project, made, results_, job.console);
}

std::vector<std::string> DrawingVerb::StartsFrom(const RunOptions&) const {
  return DrawingsToStartFrom(DrawingChoice::kUnfused, drawing_path_);
}

void DrawingVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckFiles(project, options);
  const fs::path& folder = project.layout().output.drawing_dir;
  const bool is_named = !drawing_path_.empty();
  const std::string path =
      is_named ? drawing_path_ : FindDrawing(folder, DrawingChoice::kUnfused, "drawing_path");
  DrawingInScene given = ReadDrawingInScene(project, path);
  if (!is_named) TakeClasses(project, folder / kFusedDrawing, console, &given.graph);
  const std::string provenance = Provenance(options, given.metadata.options_json);
  CheckReplaces(project, options, provenance);
  const Job job = JobOf(project, options, console);
  DrawingInScene made = Apply(job, given);
  made.metadata.options_json = provenance;
  Write(job, project, made);
  Conclude(job, given, made);
}

std::shared_ptr<const std::vector<ImageCurves>> CurvesOf(const Job& job,
                                                         const DrawingInScene& drawing) {
  if (drawing.curves) return drawing.curves;
  return SharedImageCurves(job);
}

}  // namespace limn::colmap_ext
