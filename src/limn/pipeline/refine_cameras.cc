// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/refine_cameras.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "limn/geometry/median_point.h"
#include "limn/geometry/polyline.h"
#include "limn/kinds/smooth_outlines.h"
#include "limn/model/camera_rays.h"
#include "limn/model/footprint.h"
#include "limn/model/shrunk.h"
#include "limn/pipeline/drawing_stages.h"
#include "limn/util/return_memory.h"

namespace limn {
namespace {

// Longer sides of pictures, px, above which smaller ones are made: the smallest ones, in which
// cameras may be off by tens of stored pixels, and those of the first look.
constexpr int kSmallestSidePx = 80;
constexpr int kFirstSidePx = 160;
// Any side of any of them, px.
constexpr int kLeastPx = 16;
// Unused border of small pictures, px.
constexpr double kSmallMarginPx = 4;
// Cameras are off if this share of the cost is gained (CameraFitResult::gain), and an unknown of
// theirs explains that of so many links (algorithm/cameras.md#whether-it-is-needed).
constexpr double kGainOfOff = 0.1;
constexpr double kLinksPerUnknown = 0.15;
// Lost cameras draw few links. This gain tells without them.
constexpr double kClearGain = 0.3;
// Cameras that move by more than this, px of a small picture, may be lost: they begin with the
// smallest. Pictures are drawn again until they move by less than kSettledPx, or so often.
constexpr double kLostPx = 1.2;
constexpr double kSettledPx = 0.7;
constexpr int kMaxDrawings = 6;
// Of parts that are off, at a level, which is drawn again each time. Then cameras move alone.
constexpr int kMaxPartMoves = 3;
// Cameras of a part move alike: this much of the farthest move, at least.
constexpr double kLeastOfPartMove = 0.2;
// With better cameras more of the images is drawn. If it is less than this share, they are not.
constexpr double kLeastSeen = 0.97;
// Once a part has moved as one, less than this: lines that were drawn twice are drawn once.
constexpr double kLeastSeenWithPart = 0.9;
// A drawing that shows less than this share of the edgels on image curves may be an accident.
constexpr double kLeastShown = 0.05;

// Gates of the rounds with one drawing.
const std::vector<double> kCheckReaches = {2};
const std::vector<double> kFirstReaches = {3, 2, 1};
const std::vector<double> kReaches = {2, 1};
// Of the pictures as stored, before optics join in: these must not explain what poses will.
const std::vector<double> kStoredReaches = {2, 1, 1};
const std::vector<double> kLastReaches = {1, 1, 1};
// With optics.
const std::vector<double> kOnce = {1};
const std::vector<double> kTwice = {1, 1};

// The largest power of two by which pictures can be shrunk.
int FactorOf(const std::vector<View>& views, int least_side_px) {
  int longest_px = 0;
  int shortest_px = std::numeric_limits<int>::max();
  for (const View& view : views) {
    const auto [shorter, longer] = std::minmax(view.camera.width, view.camera.height);
    longest_px = std::max(longest_px, static_cast<int>(std::lround(longer / view.scale)));
    shortest_px = std::min(shortest_px, static_cast<int>(std::lround(shorter / view.scale)));
  }
  int factor = 1;
  while (2 * factor * least_side_px <= longest_px && 2 * factor * kLeastPx <= shortest_px) {
    factor *= 2;
  }
  return factor;
}

// Length of the links in all images that support them.
double SeenPx(const DrawingGraph& graph, const std::vector<View>& views) {
  double sum_px = 0;
  for (const DrawingLink& link : graph.links) {
    const double footprint = LinkFootprint(link, views);
    if (!(footprint > 0)) continue;
    const auto num_views = static_cast<double>(link.supporting_views.size());
    sum_px += num_views * Length(link.points_in_world) / footprint;
  }
  return sum_px;
}

// Whether a drawing that shows so much of the images says something about their cameras.
bool IsEnough(double seen_px, const PictureLevel& level, const std::vector<View>& views) {
  double curves_px = 0;
  for (size_t v = 0; v < views.size(); ++v) {
    size_t num_edgels = 0;
    for (const CurveFragment& fragment : level.curves[v].fragments) {
      num_edgels += fragment.edgel_ids.size();
    }
    curves_px += ViewPxPerPicturePx(views[v], level.factor) * static_cast<double>(num_edgels);
  }
  return seen_px > kLeastShown * curves_px;
}

// Mean over the views.
double MeanViewPxPerPicturePx(const std::vector<View>& views, int factor) {
  double sum = 0;
  for (const View& view : views) sum += ViewPxPerPicturePx(view, factor);
  return sum / static_cast<double>(views.size());
}

}  // namespace

CameraRefiner::CameraRefiner(const CameraRefinementInput& input, std::vector<ImageCurves> curves,
                             const PipelineOptions& options, const RunContext& context)
    : input_(input),
      options_(options),
      context_(context),
      stored_{1, std::move(curves)},
      scene_(MakeCameraScene(input.views, input.hints, input.mounts)),
      held_(HeldViews(input.mounts)),
      first_factor_(FactorOf(input.views, kFirstSidePx)) {}

void CameraRefiner::RefineBySmallPictures() {
  first_images_.resize(input_.views.size());
  LookAtSmallPictures();
  first_images_.clear();
  ReturnFreedMemory();
}

void CameraRefiner::LookAtSmallPictures() {
  PictureLevel first = Extract(first_factor_);
  const FirstLook look = DrawAndRefine(kReaches, &first);
  if (!look.are_off) return ReturnToGiven();
  if (look.moved_px > kLostPx && !look.is_part) {
    ReturnToGiven();
    for (int factor = FactorOf(input_.views, kSmallestSidePx); factor > first_factor_;
         factor /= 2) {
      SettleAt(factor);
    }
  }
  Settle(&first);
  const double seen_px = SeenPx(graph_, scene_.views);
  if (!ShowsEnough(seen_px, look.seen_px, first)) return ReturnToGiven();
  for (int factor = first_factor_ / 2; factor > 1; factor /= 2) SettleAt(factor);
  RefineAsStored({graph_, kStoredReaches, kOnce});
}

bool CameraRefiner::RefineByDrawing(const DrawingGraph& graph) {
  graph_ = graph;
  const double seen_px = SeenPx(graph, scene_.views);
  if (given_px_ == 0) given_px_ = seen_px;
  if (have_moved_) {
    if (!ShowsEnough(seen_px, given_px_, stored_)) {
      ReturnToGiven();
      return false;
    }
    RefineAsStored({.graph = graph,
                    .reaches = last_.part ? kStoredReaches : kLastReaches,
                    .optics_reaches = kTwice,
                    .measures_rows = true,
                    .moves_parts = num_part_moves_ < kMaxPartMoves,
                    .part_of_drawing = part_});
    return last_.part.has_value();
  }
  if (!IsEnough(seen_px, stored_, scene_.views)) return false;
  if (options_.refine_cameras == CameraRefinement::kAuto) {
    CameraRoundsResult check = Refine({.graph = graph,
                                       .reaches = kCheckReaches,
                                       .optics_reaches = kOnce,
                                       .measures_rows = true,
                                       .moves_parts = true},
                                      &stored_);
    if (!check.part) ReturnToGiven();
    if (!AreOff(check) && !check.optics_are_off) return false;
    rows_ = {};  // wrong cameras look much like moving ones
    if (check.part) {
      TakeResult(std::move(check));
      return true;
    }
  }
  RefineAsStored(
      {.graph = graph, .reaches = kStoredReaches, .optics_reaches = kOnce, .moves_parts = true});
  return true;
}

// Compared with the drawing that the given cameras make.
bool CameraRefiner::ShowsEnough(double seen_px, double given_px, const PictureLevel& level) const {
  const double least = part_ ? kLeastSeenWithPart : kLeastSeen;
  return seen_px >= least * given_px && IsEnough(seen_px, level, scene_.views);
}

void CameraRefiner::ReturnToGiven() {
  scene_ = MakeCameraScene(input_.views, input_.hints, input_.mounts);
  have_moved_ = false;
  part_.reset();
  first_part_.clear();
}

void CameraRefiner::RefineAsStored(const CameraRoundsInput& input) {
  TakeResult(Refine(input, &stored_));
}

void CameraRefiner::TakeResult(CameraRoundsResult result) {
  last_ = std::move(result);
  if (last_.part) ++num_part_moves_;
  have_moved_ = true;
  FixGauge();
}

std::vector<ImageCurves> CameraRefiner::TakeCurves() {
  return std::move(&Curves() == &stored_.curves ? stored_.curves : stored_.seen);
}

// Smaller pictures, with their curves whatever the lenses.
PictureLevel CameraRefiner::Extract(int factor) {
  if (factor == 1) return stored_;
  std::vector<View> views = ShrunkViews(input_.views, factor);
  for (View& view : views) view.lens = nullptr;
  ImageSource images = input_.images;
  EdgeDetectionOptions edges = options_.edges;
  images.read = [&](ViewId id) { return ReadShrunk(id, factor); };
  edges.margin_px = std::min(edges.margin_px, kSmallMarginPx);
  ResultCache none("");
  CurvesResult extracted = ExtractCurves({views, images, &none}, edges, options_.linking, context_);
  return {factor, std::move(extracted.curves)};
}

// Pictures smaller than those of the first look are made of these.
Image CameraRefiner::ReadShrunk(ViewId id, int factor) {
  std::optional<Image>& first = first_images_[id];
  if (first && factor % first_factor_ == 0) return Shrunk(*first, factor / first_factor_);
  const Image image = input_.images.read(id);
  if (!first) first = Shrunk(image, first_factor_);
  return Shrunk(image, factor);
}

// With the cameras as they are now.
void CameraRefiner::Draw(PictureLevel* level) {
  const std::vector<View> views = ShrunkViews(scene_.views, level->factor);
  const std::vector<ImageCurves>& curves = CurvesSeenNow(scene_, context_, level);
  PipelineOptions options = options_;
  options.mode = SketchMode::kSweep;
  const SceneHints hints = HintsOf(scene_, input_.hints, scene_.views);
  ResultCache none("");
  const CurvesScene scene = {views, curves, hints, input_.box};
  const DrawnCurves drawn = DrawCurves(scene, options, &none, context_, [](const StageSummary&) {});
  // No camera agrees with another one on an outline; they are left out of fits.
  graph_ = FindSmoothOutlines({scene, drawn.drawing.graph, /*fit_bodies=*/false}, context_).graph;
}

CameraRoundsResult CameraRefiner::Refine(const CameraRoundsInput& input, PictureLevel* level) {
  CameraRoundsResult rounds =
      RefineCamerasByDrawing(input, options_.refinement, context_, level, &scene_);
  if (input.measures_rows) rows_ = rounds.rows;
  if (!rounds.part) return rounds;
  if (!part_) first_part_ = rounds.part->views;
  part_ = rounds.part;
  return rounds;
}

CameraRefiner::FirstLook CameraRefiner::DrawAndRefine(const std::vector<double>& reaches,
                                                      PictureLevel* level, bool moves_parts) {
  Draw(level);
  const std::vector<View> before = scene_.views;
  const double seen_px = SeenPx(graph_, before);
  const CameraRoundsResult rounds = Refine(
      {.graph = graph_, .reaches = reaches, .moves_parts = moves_parts, .part_of_drawing = part_},
      level);
  const Gauge gauge = FindGauge(before, scene_.views, MiddleOfScene(), held_);
  return {AreOff(rounds), rounds.part.has_value(),
          gauge.typical_move_px / MeanViewPxPerPicturePx(before, level->factor), seen_px};
}

// By the first of the rounds.
bool CameraRefiner::AreOff(const CameraRoundsResult& rounds) const {
  const auto num_links = static_cast<double>(rounds.num_links);
  const auto num_unknowns = 6.0 * static_cast<double>(std::ranges::count(input_.mounts.held, 0));
  return rounds.part.has_value() || rounds.gain > kClearGain ||
         (rounds.gain > kGainOfOff && rounds.gain * num_links > kLinksPerUnknown * num_unknowns);
}

void CameraRefiner::SettleAt(int factor) {
  PictureLevel level = Extract(factor);
  Settle(&level);
}

void CameraRefiner::Settle(PictureLevel* level) {
  FirstLook look = DrawAndRefine(kFirstReaches, level);
  for (int i = 1; i < kMaxDrawings && (look.is_part || look.moved_px > kSettledPx); ++i) {
    look = DrawAndRefine(look.is_part ? kFirstReaches : kReaches, level, i < kMaxPartMoves);
  }
}

Eigen::Vector3d CameraRefiner::MiddleOfScene() const {
  std::vector<Eigen::Vector3d> places;
  for (const DrawingLink& link : graph_.links) {
    places.insert(places.end(), link.points_in_world.begin(), link.points_in_world.end());
  }
  for (const SeenPoint& point : scene_.points) {
    if (point.sights.size() >= 2) places.push_back(point.position);
  }
  return places.empty() ? Eigen::Vector3d::Zero() : MedianPoint(places);
}

// The given views with these poses and optics.
std::vector<View> CameraRefiner::Refined(const std::vector<View>& moved) const {
  std::vector<View> refined = input_.views;
  ParallelFor(context_, "cameras", refined.size(), [&](size_t v) {
    const View& view = moved[v];
    if (view.calibration != refined[v].calibration) {
      refined[v] = WithOptics(std::move(refined[v]), {view.camera, view.lens, view.calibration});
    }
    refined[v].cam_from_world = view.cam_from_world;
  });
  return refined;
}

// Back to the frame of the given cameras.
void CameraRefiner::FixGauge() {
  // A principal point that moves turns its camera, but not its rays.
  std::vector<View> by_rays = scene_.views;
  for (size_t v = 0; v < by_rays.size(); ++v) {
    by_rays[v] = WithRaysInOpticsOf(input_.views[v], std::move(by_rays[v]));
  }
  gauge_ = FindGauge(input_.views, by_rays, MiddleOfScene(), held_);
  const Eigen::Affine3d& to_given = gauge_.given_from_refined;
  if (part_) part_->motion = to_given * part_->motion * to_given.inverse();
  const double scale = std::cbrt(gauge_.given_from_refined.linear().determinant());
  for (CameraMount& mount : scene_.mounts.of_view) mount.view_from_body.translation *= scale;
  if (last_.uncertainty) {
    last_.uncertainty->shift_unit *= scale;
    last_.uncertainty->mounts = scene_.mounts;
  }
  scene_.views = InGivenFrame(input_.views, scene_.views, gauge_, held_);
  for (SeenPoint& point : scene_.points) {
    if (point.is_fitted) point.position = gauge_.given_from_refined * point.position;
  }
}

// Where nothing is held, moving a part is moving the others: the smaller side is told. A camera
// that is off alone may have taken others along, which have come back.
std::vector<ViewId> CameraRefiner::ToldPart() const {
  if (first_part_.empty()) return {};
  const bool tells_others = held_.empty() && 2 * first_part_.size() > input_.views.size();
  std::vector<uint8_t> is_told(input_.views.size(), tells_others ? 1 : 0);
  for (const ViewId v : first_part_) is_told[v] = tells_others ? 0 : 1;
  double most_px = 0;
  for (size_t v = 0; v < is_told.size(); ++v) {
    if (is_told[v]) most_px = std::max(most_px, gauge_.moves_px[v]);
  }
  std::vector<ViewId> part;
  for (size_t v = 0; v < is_told.size(); ++v) {
    const bool moved_along = gauge_.moves_px[v] >= kLeastOfPartMove * most_px;
    if (is_told[v] && moved_along) part.push_back(static_cast<ViewId>(v));
  }
  return part.size() > 1 ? part : std::vector<ViewId>();
}

RefinedCameras CameraRefiner::Cameras() const {
  RefinedCameras cameras;
  cameras.median_move_px = gauge_.typical_move_px;
  cameras.views = Refined(scene_.views);
  for (size_t v = 0; v < cameras.views.size(); ++v) {
    const CameraEvidence& evidence = last_.of_view[v];
    const ViewSkew skew = rows_.of_view.empty() ? ViewSkew() : rows_.of_view[v];
    cameras.of_view.push_back({gauge_.moves_px[v], evidence.num_edgels, evidence.residual_px,
                               evidence.certain_by_px, skew.px, skew.sigma_px});
  }
  cameras.part = ToldPart();
  for (const FarMove& move : gauge_.moved_far) {
    const bool is_in_part = std::ranges::count(cameras.part, move.view) > 0;
    if (!is_in_part) cameras.of_view[move.view].is_misfit = true;
  }
  cameras.uncertainty = last_.uncertainty;
  cameras.part_left = last_.part_left;
  cameras.hints = HintsOf(scene_, input_.hints, cameras.views);
  return cameras;
}

}  // namespace limn
