// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/align.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "colmap_ext/verbs/aligned_project.h"
#include "colmap_ext/verbs/drawing_input.h"
#include "colmap_ext/verbs/image_places.h"
#include "colmap_ext/verbs/position_doubts.h"
#include "colmap_ext/workspace/pose_priors.h"
#include "limn/alignment/geodetic.h"
#include "limn/files/atomic_file.h"
#include "limn/files/kept_time.h"
#include "limn/formats/write_drawing.h"
#include "limn/util/angles.h"
#include "limn/util/errors.h"
#include "limn/util/name_list.h"
#include "limn/util/number_text.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// The database of a model may be this many folders above it: W/dense/0/sparse.
constexpr int kMaxFoldersUp = 3;

// Empty if there is none.
fs::path FindDatabase(const Scene& scene, const LayoutOptions& layout) {
  std::vector<fs::path> folders;
  if (!layout.workspace_path.empty()) folders.push_back(layout.workspace_path);
  const fs::path& model = scene.layout().given_model_dir;
  // A model in memory has no folder: its database may be near the images.
  const fs::path& near = model.empty() ? scene.layout().image_dir : model;
  fs::path folder = near.empty() ? fs::path() : fs::absolute(near).lexically_normal();
  for (int up = 0; up <= kMaxFoldersUp && !folder.empty(); ++up) {
    folders.push_back(folder);
    folder = folder.parent_path();
  }
  std::error_code ignored;
  for (const fs::path& candidate : folders) {
    if (fs::is_regular_file(candidate / "database.db", ignored)) return candidate / "database.db";
  }
  return {};
}

// Earth-fixed positions, which have no up of their own, become geographic ones. Whether they did.
bool MakeGeographic(PosePriors* priors) {
  std::vector<Eigen::Vector3d> positions;
  for (const auto& [image, prior] : *priors) {
    if (prior.position && !prior.is_geographic) positions.push_back(*prior.position);
  }
  if (!AreEarthFixed(positions)) return false;
  for (auto& [image, prior] : *priors) {
    if (!prior.position || prior.is_geographic) continue;
    const GeoPosition at = GeoFromEarthFixed(*prior.position);
    prior.position = {at.latitude_deg, at.longitude_deg, at.altitude_m};
    prior.is_geographic = true;
  }
  return true;
}

// Geographic positions in a local frame, also with latitude and longitude exchanged if that is on
// earth.
void SetPositions(const std::vector<std::pair<ViewId, Eigen::Vector3d>>& geographic,
                  std::vector<ViewPrior>* priors) {
  std::vector<GeoPosition> positions, exchanged;
  bool can_be_exchanged = true;
  for (const auto& [view, at] : geographic) {
    positions.push_back({at.x(), at.y(), at.z()});
    exchanged.push_back({at.y(), at.x(), at.z()});
    can_be_exchanged &= std::abs(at.y()) <= 90;
  }
  const std::vector<Eigen::Vector3d> local = LocalFromGeo(positions);
  const std::vector<Eigen::Vector3d> local_exchanged = LocalFromGeo(exchanged);
  for (size_t i = 0; i < local.size(); ++i) {
    ViewPrior& prior = (*priors)[geographic[i].first];
    prior.position = local[i];
    prior.is_geographic = true;
    if (can_be_exchanged) prior.exchanged_position = local_exchanged[i];
  }
}

// The views that stand for images: of the parts of a panorama, which were taken at once, the first.
std::vector<ViewId> ViewsOfImages(const ViewSet& set) {
  std::vector<ViewId> views;
  for (ViewId v = 0; v < static_cast<ViewId>(set.views.size()); ++v) {
    if (v == 0 || set.ImageName(v) != set.ImageName(v - 1)) views.push_back(v);
  }
  return views;
}

PosePriors ReadPriorsOf(const std::vector<ViewId>& of_images, const ViewSet& set,
                        const fs::path& database) {
  std::set<std::string> names;
  for (const ViewId v : of_images) names.insert(set.ImageName(v));
  return ReadPosePriors(database, names);
}

std::optional<Eigen::Vector3d> GravityIn(const ViewSet& set, ViewId view, const PosePrior& prior) {
  if (!prior.gravity || !set.Window(view)) return prior.gravity;
  if (IsOrientationFlag(*prior.gravity)) return std::nullopt;  // in a part it would look measured
  return set.files[view].view_from_image * *prior.gravity;
}

std::vector<ViewPrior> PriorsOfViews(const PosePriors& stored, const std::vector<ViewId>& of_images,
                                     const ViewSet& set) {
  std::vector<ViewPrior> priors(set.views.size());
  std::vector<std::pair<ViewId, Eigen::Vector3d>> geographic;
  for (const ViewId v : of_images) {
    const auto found = stored.find(set.ImageName(v));
    if (found == stored.end()) continue;
    const PosePrior& prior = found->second;
    priors[v].position = prior.position;
    priors[v].position_sigma = prior.position_sigma;
    priors[v].gravity_in_cam = GravityIn(set, v, prior);
    if (prior.is_geographic && prior.position) geographic.emplace_back(v, *prior.position);
  }
  SetPositions(geographic, &priors);
  return priors;
}

std::string CountsOf(const std::vector<ViewPrior>& priors, size_t num_images) {
  size_t num_positions = 0, num_gravities = 0, num_flags = 0;
  for (const ViewPrior& prior : priors) {
    num_positions += prior.position ? 1 : 0;
    const bool is_measured = MeasuredGravity(prior);
    num_gravities += is_measured ? 1 : 0;
    num_flags += prior.gravity_in_cam && !is_measured ? 1 : 0;
  }
  const std::string flags =
      num_flags == 0 ? "" : ", only the orientation flag of " + std::to_string(num_flags);
  return "positions of " + std::to_string(num_positions) + " and gravity of " +
         std::to_string(num_gravities) + " of " + std::to_string(num_images) + " images" + flags;
}

std::string DegreesText(double angle_rad) { return ShortNumber(Degrees(angle_rad)) + " degrees"; }
std::string Percent(double share) { return ShortNumber(100 * share) + " %"; }

std::string UpText(const AlignmentResult& result) {
  switch (result.alignment.up) {
    case UpSource::kGravity:
      return "the gravity that " + std::to_string(result.gravity->num_views) +
             " cameras measured, " + DegreesText(result.gravity->deviation_rad) +
             " from each (median)";
    case UpSource::kPositions:
      return "positions of cameras, standard error " + DegreesText(result.positions->up_error_rad);
    case UpSource::kLines:
      return "the lines, of which " + Percent(result.vertical->share) +
             " are vertical or horizontal, within " + DegreesText(result.vertical->deviation_rad) +
             " (median)";
    case UpSource::kCameras:
      return "the way the cameras are held, which is rough";
  }
  return "";
}

std::string AxesText(const AlignmentResult& result) {
  switch (result.alignment.axes) {
    case AxesSource::kLines:
      return "the main horizontal direction, which " + Percent(result.horizontal->share) +
             " of the horizontal lines follow";
    case AxesSource::kPositions:
      return "east by the positions of cameras";
    case AxesSource::kModel:
      return "the axes of the model";
    case AxesSource::kPlan:
      return "lines of a plan";
  }
  return "";
}

std::string ScaleText(const AlignmentResult& result) {
  const double scale = result.alignment.world_from_model.scale;
  const std::string unit = ShortNumber(scale) + " m per unit of the model, from ";
  switch (result.alignment.scale) {
    case ScaleSource::kNone:
      return "unknown, the unit is the model's";
    case ScaleSource::kLengths:
      return unit + "known lengths" +
             (result.lengths->sigma > 0 ? ", standard error " + Percent(result.lengths->sigma)
                                        : "");
    case ScaleSource::kPositions:
      return unit + "positions of cameras, standard error " +
             Percent(result.positions->scale_error);
  }
  return "";
}

// Why gravity was not used that cameras measured.
void SayGravity(const AlignmentResult& result, const std::vector<ViewPrior>& priors,
                Console* console) {
  const auto count = std::count_if(priors.begin(), priors.end(), MeasuredGravity);
  if (count == 0 || result.alignment.up == UpSource::kGravity) return;
  const std::string reason =
      result.gravity
          ? "is not used: it differs by " + DegreesText(result.gravity->deviation_rad) + " (median)"
          : "is not used: " + std::to_string(kMinGravities) + " that agree are needed";
  console->Say("alignment: gravity of " + std::to_string(count) + " cameras " + reason);
}

// How well positions fit, which are far off, or why there are too few.
void SayPositions(const AlignmentResult& result, const ViewSet& set, Console* console) {
  if (result.positioned.empty()) return;
  if (!result.positions) {
    console->Say("alignment: positions of " + std::to_string(result.positioned.size()) +
                 " cameras are not used: " + std::to_string(kMinPositions) +
                 " at different places are needed");
    return;
  }
  if (result.position_check.doubt != PositionDoubt::kNone) return;
  const PositionFit& fit = *result.positions;
  console->Say("alignment: positions fit the cameras within " + ShortNumber(fit.median_residual) +
               " m (median); standard errors: up " + DegreesText(fit.up_error_rad) + ", scale " +
               Percent(fit.scale_error));
  const std::vector<NamedNumber> far = FarPositions(result, set);
  if (!far.empty()) {
    console->Say("WARNING: positions far from their cameras are left out: " +
                 ListNumbers(far, "m"));
  }
}

void SayLengths(const std::vector<KnownLength>& lengths, const AlignmentResult& result,
                Console* console) {
  for (size_t i = 0; i < lengths.size(); ++i) {
    const double length = result.lengths->lengths[i];
    char off[40];
    std::snprintf(off, sizeof(off), "%+.2f %%", 100 * (length / lengths[i].meters - 1));
    console->Say("alignment: " + lengths[i].text + ": " + ShortNumber(length) +
                 " m in the drawing (" + off + ")");
  }
}

// Finds the places of the pixels of options, and says which they are.
class PixelPlacer {
 public:
  PixelPlacer(const ViewSet& set, const std::vector<View>& views, const DrawingGraph& graph,
              Console* console)
      : set_(set), views_(views), graph_(graph), console_(*console) {}

  // `given` is the option, with its text. Throws OptionError.
  void Place(const std::string& given, DrawingSpan* span) const {
    if (span->pixels.empty()) return;
    try {
      span->places = PlacesOf(span->pixels, set_, InStoredImages(set_, views_), graph_);
    } catch (const InputError& error) {
      throw OptionError(given + ": " + error.what());
    }
    for (size_t i = 0; i < span->places.size(); ++i) {
      const DrawingPlace& place = span->places[i];
      console_.Say("alignment: " + TextOf(span->pixels[i]) + " is on link " +
                   std::to_string(place.link) + ", " + ShortNumber(place.distance_px) + " px away");
    }
  }

 private:
  const ViewSet& set_;
  const std::vector<View>& views_;
  const DrawingGraph& graph_;
  Console& console_;
};

// The drawings of an output folder to align: the newest, in which is measured, then drawing.json if
// that is not the newest. An older drawing-fused.json is not aligned, and warned of. Throws IoError
// if there is none.
std::vector<std::string> DrawingsToAlign(const fs::path& folder, Console* console) {
  std::vector<std::string> paths = {FindDrawing(folder, DrawingChoice::kNewest, "drawing_path")};
  const fs::path plain = folder / "drawing.json", fused = folder / kFusedDrawing;
  std::error_code ignored;
  if (paths.front() != plain) {
    if (fs::exists(plain, ignored)) paths.push_back(plain.string());
  } else if (fs::exists(fused, ignored)) {
    console->Say("WARNING: " + fused.string() + " is older than " + plain.string() +
                 " and is not aligned: run drawing_fuser again");
  }
  return paths;
}

// Drawings keep their times of change, by which commands take the newest. All are read before the
// first is written. Throws IoError.
void StoreAlignment(const std::vector<OutputPath>& drawing_paths, const Alignment& alignment) {
  std::vector<DrawingFile> drawings;
  for (const OutputPath& path : drawing_paths) drawings.push_back(ReadDrawingJson(path.string()));
  for (size_t i = 0; i < drawings.size(); ++i) {
    drawings[i].metadata.alignment = alignment;
    const KeptTime time(drawing_paths[i]);
    WriteDrawing(drawing_paths[i], drawings[i].graph, drawings[i].metadata);
    time.Restore();
  }
}

}  // namespace

void AlignOptions::AddOptions(bool of_drawing, OptionParser* parser) {
  if (of_drawing) {
    mode = Mode::kAuto;
    contradictions_fail = true;
    parser->AddOption("known_length", &known_lengths,
                      BasicOption("measured lengths, such as \"link 12 = 2.40 m\", \"from 3 to 7 = "
                                  "2.40 m\" (nodes) or \"a.jpg 120,340 to b.jpg 500,220 = 2.40 "
                                  "m\" (pixels); several separated by ;"));
    parser->AddOption("plan_line", &plan_lines,
                      BasicOption("directions in a floor plan, such as \"link 12 = 30 deg\" (from "
                                  "x, counter-clockwise) or \"from 3 to 7 = north\"; several "
                                  "separated by ;"));
    parser->AddOption("use_positions", &use_positions,
                      "take positions of cameras from the database");
    parser->AddOption(
        "world", &world, {{"drawing", WorldFrame::kDrawing}, {"positions", WorldFrame::kPositions}},
        BasicOption("whose coordinates: those around the middle of the drawing, or of "
                    "the positions of cameras, such as a national grid"));
  } else {
    parser->AddOption("align", &mode, {{"none", Mode::kNone}, {"auto", Mode::kAuto}},
                      "store up, horizontal axes and scale in drawing.json");
  }
  parser->AddOption("database_path", &database_path,
                    {"COLMAP's database with gravity and positions of cameras, instead of the one "
                     "found",
                     /*is_basic=*/of_drawing});
}

void AlignOptions::Check() const {
  ParseKnownLengths(known_lengths);
  ParsePlanLines(plan_lines);
  if (world == WorldFrame::kPositions && !plan_lines.empty()) {
    throw OptionError("plan_line: with --world positions x is east; leave one of them out");
  }
  if (mode == Mode::kNone && !database_path.empty()) {
    throw OptionError("database_path = " + database_path + ": needs --align auto");
  }
  if (world == WorldFrame::kPositions && !use_positions) {
    throw OptionError("use_positions = 0: the world cannot be that of the positions then");
  }
}

SceneAligner::SceneAligner(const Scene& scene, const LayoutOptions& layout,
                           const AlignOptions& options, Console* console)
    : scene_(scene),
      is_asked_(options.mode == AlignOptions::Mode::kAuto),
      contradictions_fail_(options.contradictions_fail),
      world_(options.world) {
  if (!is_asked_) return;
  lengths_ = ParseKnownLengths(options.known_lengths);
  plan_lines_ = ParsePlanLines(options.plan_lines);
  const bool is_found = options.database_path.empty();
  const fs::path database =
      is_found ? FindDatabase(scene, layout) : fs::path(options.database_path);
  if (database.empty()) {
    console->Say("alignment: no database.db near the model");
    return;
  }
  const std::vector<ViewId> of_images = ViewsOfImages(scene.view_set());
  try {
    PosePriors stored = ReadPriorsOf(of_images, scene.view_set(), database);
    if (!options.use_positions) {
      for (auto& [image, prior] : stored) prior.position.reset();
    }
    if (MakeGeographic(&stored)) {
      console->Say("alignment: positions are earth-centered (ECEF): taken as geographic ones");
    }
    priors_ = PriorsOfViews(stored, of_images, scene.view_set());
  } catch (const IoError& error) {
    if (!is_found) throw;
    console->Say(std::string("WARNING: alignment without a database: ") + error.what());
    return;
  }
  database_ = database;
  console->Say("alignment: " + database.string() + " has " + CountsOf(priors_, of_images.size()));
}

std::optional<Alignment> SceneAligner::Align(const std::vector<View>& views,
                                             const DrawingGraph& graph, Console* console) const {
  if (!is_asked_) return std::nullopt;
  const PixelPlacer placer(scene_.view_set(), views, graph, console);
  std::vector<KnownLength> lengths = lengths_;
  for (KnownLength& length : lengths) {
    placer.Place("known_length = " + Printable(length.text), &length.span);
  }
  std::vector<PlanLine> plan_lines = plan_lines_;
  for (PlanLine& line : plan_lines) {
    placer.Place("plan_line = " + Printable(line.text), &line.span);
  }
  const AlignmentResult result = AlignDrawing({views, graph, priors_, lengths, plan_lines, world_});
  CheckPositions(result, console);
  CheckWorld(result);
  SayGravity(result, priors_, console);
  SayPositions(result, scene_.view_set(), console);
  SayLengths(lengths_, result, console);
  console->Say("alignment: up from " + UpText(result));
  console->Say("alignment: x and y from " + AxesText(result));
  console->Say("alignment: scale " + ScaleText(result));
  return After({1, Eigen::Matrix3d::Identity(), scene_.origin()}, result.alignment);
}

void SceneAligner::CheckPositions(const AlignmentResult& result, Console* console) const {
  const std::string doubt = PositionDoubtText(result, lengths_, scene_.view_set());
  if (doubt.empty()) return;
  if (contradictions_fail_) {
    throw IoError(database_.string(),
                  doubt + "; correct them, or align without them: --use_positions 0");
  }
  console->Say("WARNING: " + database_.string() + ": " + doubt + "; they are not used");
}

void SceneAligner::CheckWorld(const AlignmentResult& result) const {
  if (result.world == world_) return;
  throw IoError(database_.empty() ? "database.db" : database_.string(),
                "has no positions that tell where the drawing is, as world = positions needs: four "
                "or more, not along a line, that give east within 10 degrees and the scale within "
                "20 % (" +
                    std::to_string(result.positioned.size()) + " found); leave out --world");
}

void AlignVerb::AddOptions(OptionParser* parser) { align_.AddOptions(/*of_drawing=*/true, parser); }

void AlignVerb::AddFileOptions(OptionParser* parser) {
  AddDrawingPath(
      "drawing to align, instead of drawing.json (and drawing-fused.json) in the output folder",
      parser);
  parser->AddOption("apply_to", &apply_to_,
                    {{"drawing", AppliesTo::kDrawing}, {"project", AppliesTo::kProject}},
                    BasicOption("project: also write model, cloud, meshes and drawing in world "
                                "coordinates, to aligned/"));
}

void AlignVerb::Prepare(RunOptions*, Console*) {
  align_.Check();
  std::error_code ignored;
  if (!fs::is_directory(drawing_path(), ignored)) return;
  throw OptionError("drawing_path = " + drawing_path() +
                    ": is a folder, where no alignment can be stored; export it to a .json file "
                    "first (drawing_exporter)");
}

DrawingInScene AlignVerb::Apply(const Job& job, const DrawingInScene& given) {
  // What the options of a scene in memory name is no project.
  const bool is_project = !job.scene.layout().model_dir.empty();
  const SceneAligner aligner(job.scene, is_project ? job.options.layout : LayoutOptions(), align_,
                             job.console);
  DrawingInScene made = given;
  made.fingerprint.clear();
  made.metadata.alignment = aligner.Align(given.views, given.graph, job.console);
  return made;
}

std::vector<std::string> AlignVerb::StartsFrom(const RunOptions&) const {
  return DrawingsToStartFrom(DrawingChoice::kNewest, drawing_path());
}

void AlignVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  const std::vector<std::string> paths =
      drawing_path().empty() ? DrawingsToAlign(project.layout().output.drawing_dir, console)
                             : std::vector<std::string>{drawing_path()};
  const bool is_applied = apply_to_ == AppliesTo::kProject;
  if (is_applied) CheckAlignedProject(project, options);
  std::vector<OutputPath> outputs;
  for (const std::string& path : paths) {
    const bool is_named = !drawing_path().empty();
    outputs.push_back(is_named ? path : project.DrawingPath(fs::path(path).filename().string()));
    CheckTakesFile(outputs.back());
  }
  // Known lengths name the links that drawing_viewer shows.
  const DrawingInScene given = ReadDrawingInScene(project, paths.front());
  console->Say("drawing: " + paths.front());
  const DrawingInScene made = Apply(JobOf(project, options, console), given);
  StoreAlignment(outputs, *made.metadata.alignment);
  for (const std::string& path : paths) console->Say("Written: alignment in " + path);
  if (is_applied) WriteAlignedProject(project, options, made, console);
  console->RepeatWarnings();
}

}  // namespace limn::colmap_ext
