// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cameras/camera_rounds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "limn/cameras/camera_fit.h"
#include "limn/cameras/camera_landmarks.h"
#include "limn/cameras/camera_part.h"
#include "limn/cameras/camera_uncertainty.h"
#include "limn/geometry/median_point.h"
#include "limn/model/shrunk.h"
#include "limn/refinement/curve_fit.h"
#include "limn/refinement/edge_links.h"
#include "limn/refinement/edgel_matches.h"
#include "limn/refinement/scene_unit.h"
#include "limn/topology/edit_topology.h"
#include "limn/util/angles.h"
#include "limn/util/median.h"

namespace limn {
namespace {

// Of the curves, in one fit, about.
constexpr size_t kMaxLines = 60'000;
// Of the samples of links in small pictures, px: there are few.
constexpr double kSmallSpacingPx = 1.5;
// Optics are off if curves gain from the first round that frees them, with more evidence
// (EvidenceOfOptics).
constexpr double kLeastEvidence = 100;
// Gate within which the motion of rows is measured, and scale of its loss, in multiples of those of
// the options: what rows are off must not be left out.
constexpr double kReachOfRows = 2;
// Gates within which a part that is off is looked for, and then moves.
constexpr double kReachesOfPart[] = {4, 4, 2, 1};
// A part is off if its motion gains this share of the cost, and each of its unknowns that of so
// many links (algorithm/cameras.md#parts).
constexpr double kLeastGainOfPart = 0.03;
constexpr double kLinksPerUnknownOfPart = 1;
constexpr double kLeastOfAlone = 0.4;
constexpr double kLinksPerUnknownOfMoved = 0.5;  // if it has moved before: what is left of it
// A body belongs to the other side of a part if it shows so many times as many edgels of the
// drawing there, and so many.
constexpr double kMoreShown = 1.1;
constexpr int kLeastShown = 30;

class CameraRounds {
 public:
  // `edges` instead of the graph of the input, in the unit of the scene.
  CameraRounds(const CameraRoundsInput& input, const DrawingGraph& edges,
               const RefinementOptions& options, const RunContext& context, PictureLevel* level,
               CameraScene* scene)
      : input_(input),
        options_(options),
        context_(context),
        level_(*level),
        scene_(*scene),
        given_poses_(BodyPoses(scene->given, scene->mounts)) {
    if (level_.factor > 1) options_.sample_spacing_px = kSmallSpacingPx;
    SeeCurves();
    control_ = MakeControlGraph(edges, small_views_, options.control_spacing_px);
    // A view that is off supports no link, or the wrong ones.
    std::vector<ViewId> all(scene_.views.size());
    std::iota(all.begin(), all.end(), 0);
    for (ControlLink& link : control_.links) link.views = all;
  }

  CameraRoundsResult Run() {
    result_.of_view.resize(scene_.views.size());
    if (input_.moves_parts) {
      if (input_.part_of_drawing) ExchangeBodies(*input_.part_of_drawing);
      if (!result_.part) MovePart();
      if (result_.part) return std::move(result_);
    }
    for (size_t i = 0; i < input_.reaches.size(); ++i) {
      const bool is_last = i + 1 == input_.reaches.size();
      const Outcome outcome = Round({.reach = input_.reaches[i],
                                     .with_certainty = is_last && !input_.optics_reaches.empty()});
      if (i > 0) continue;
      result_.gain = outcome.gain;
      result_.num_links = outcome.num_links;
    }
    if (input_.part_of_drawing && level_.factor == 1) LookForPart();
    if (input_.measures_rows && !HaveOtherOptics()) MeasureRows(input_.reaches.back());
    if (!input_.optics_reaches.empty()) RefineOptics();
    if (input_.measures_rows && HaveOtherOptics()) MeasureRows(input_.optics_reaches.back());
    return std::move(result_);
  }

 private:
  struct RoundInput {
    double reach = 1;
    bool with_certainty = false;
    CameraPart* part = nullptr;  // which alone moves; empty: is looked for
  };
  struct Outcome {
    bool has_moved = false;
    size_t num_links = 0;
    double gain = 0;
    double gain_of_curves = 0;
    double evidence_of_optics = 0;
  };

  bool HaveOtherOptics() const {
    return !std::ranges::equal(scene_.views, scene_.given, {}, &View::calibration,
                               &View::calibration);
  }

  void RefineOptics() {
    per_px_ = ParametersPerPx(scene_.given);
    const CameraScene posed = scene_;
    const bool are_refined = HaveOtherOptics();
    const CameraRoundsResult of_poses = result_;
    for (size_t i = 0; i < input_.optics_reaches.size(); ++i) {
      const Outcome outcome = Round({.reach = input_.optics_reaches[i], .with_certainty = true});
      if (i > 0 || are_refined) continue;
      result_.optics_are_off =
          outcome.gain_of_curves > 0 && outcome.evidence_of_optics > kLeastEvidence;
      if (result_.optics_are_off) continue;
      scene_ = posed;
      result_ = of_poses;
      return;
    }
  }

  // The curves through the lenses as they are now.
  void SeeCurves() {
    small_views_ = ShrunkViews(scene_.views, level_.factor);
    if (curves_ && std::ranges::equal(scene_.views, seen_through_, {}, &View::lens)) return;
    edgels_.clear();  // before there are new ones
    curves_ = &CurvesSeenNow(scene_, context_, &level_);
    edgels_ = BuildViewEdgels(*curves_, context_);
    seen_through_.clear();
    for (const View& view : scene_.views) seen_through_.push_back(view.lens);
  }

  // Moves the part of the cameras that is off, if there is one.
  void MovePart() {
    CameraPart part;
    const std::vector<View> before = scene_.views;
    for (const double reach : kReachesOfPart) {
      if (!Round({.reach = reach, .part = &part}).has_moved) break;
    }
    if (part.empty()) return;
    const Eigen::Vector3d middle =
        MedianPoint({control_.position.begin(), control_.position.end()});
    result_.part = PartThatMoved(part, scene_, before, middle);
  }

  // That which is off in spite of all; moves nothing.
  void LookForPart() {
    CameraPart part;
    CameraScene scene = scene_;
    CameraRoundsResult result = result_;
    const bool is_off = Round({.reach = kReachesOfPart[0], .part = &part}).has_moved;
    scene_ = std::move(scene);
    result_ = std::move(result);
    if (is_off) result_.part_left = ViewsOf(part, scene_.mounts);
  }

  // What was farther off than the gate did not count when the part was found.
  void ExchangeBodies(const MovedPart& moved) {
    CameraPart part(scene_.mounts.NumBodies(), 0);
    for (const ViewId v : moved.views) part[BodyOf(v)] = 1;
    const std::vector<View> there = OnOtherSide(part, moved.motion, scene_);
    const std::vector<int> shown = EdgelsPerBody(scene_.views);
    const std::vector<int> shown_there = EdgelsPerBody(there);
    std::vector<uint8_t> changes(part.size(), 0);
    for (size_t body = 0; body < part.size(); ++body) {
      changes[body] = !scene_.mounts.held[body] && shown_there[body] >= kLeastShown &&
                      shown_there[body] > kMoreShown * shown[body];
      part[body] ^= changes[body];
    }
    for (size_t v = 0; v < scene_.views.size(); ++v) {
      if (changes[BodyOf(v)]) scene_.views[v].cam_from_world = there[v].cam_from_world;
    }
    small_views_ = ShrunkViews(scene_.views, level_.factor);
    if (std::ranges::count(changes, 1) > 0) {
      result_.part = {ViewsOf(part, scene_.mounts), moved.motion};
    }
  }

  // Matched along the drawing as these views, which have other poses, see it. Each by itself: few
  // of them may be on the right side.
  std::vector<int> EdgelsPerBody(const std::vector<View>& views) {
    small_views_ = ShrunkViews(views, level_.factor);
    RefinementOptions options = options_;
    options.min_views = 1;
    Match(1, options, &control_);
    std::vector<int> counts(scene_.mounts.NumBodies(), 0);
    ForPulls([&](EdgelPull* pull) { ++counts[BodyOf(pull->ref.view)]; });
    return counts;
  }

  int BodyOf(size_t view) const { return scene_.mounts.of_view[view].body; }

  // Nothing has moved, and nothing is gained, without a solution.
  Outcome Round(const RoundInput& round) {
    if (has_fitted_) FitCurvesAgain();
    Match(round.reach, &control_);
    MeasureResiduals();
    const LandmarkInput input = {scene_.views, *curves_, level_.factor, per_px_,
                                 round.reach * options_.robust_residual_px};
    std::vector<Landmark> landmarks = CurveLandmarks(input, control_, kMaxLines);
    PointLandmarks of_points = LandmarksOfPoints(input, scene_.points);
    const size_t num_on_curves = landmarks.size();
    std::ranges::move(of_points.landmarks, std::back_inserter(landmarks));
    if (landmarks.empty()) return {};
    const Eigen::Vector3d middle = MiddleOf(landmarks);
    CameraFitInput fit_input = InputOfFit(middle);
    fit_input.with_covariance = round.with_certainty;
    if (round.part) fit_input.part = {middle, *round.part};
    const auto fit = FitCameras(fit_input, context_, &landmarks);
    if (!fit) return {};
    Outcome outcome;
    outcome.has_moved = true;
    outcome.num_links = std::ranges::count(control_.links, false, &ControlLink::frozen);
    if (num_on_curves > 0) outcome.gain = std::max(fit->gain, fit->gain_of_curves);
    outcome.gain_of_curves = fit->gain_of_curves;
    if (round.part && round.part->empty()) {
      if (!IsOff(outcome, InputOfFit(middle), landmarks)) return {};
      *round.part = fit->part;
    }
    has_fitted_ = true;
    for (size_t i = 0; i < of_points.points.size(); ++i) {
      SeenPoint& point = scene_.points[of_points.points[i]];
      point.position = landmarks[num_on_curves + i].position;
      point.is_fitted = true;
    }
    if (!per_px_.empty()) ShiftPulls(input, fit_input, *fit);
    TakePoses(*fit);
    TakeOptics(*fit);
    result_.uncertainty.reset();
    if (fit->covariance) {
      outcome.evidence_of_optics = EvidenceOfOptics(*fit->covariance, fit->parameters);
      MeasureCertainty(*fit->covariance, middle);
    }
    return outcome;
  }

  // Whether a part is, by what its motion gains.
  bool IsOff(const Outcome& of_part, const CameraFitInput& all, std::vector<Landmark> landmarks) {
    const double gain_in_links = of_part.gain * static_cast<double>(of_part.num_links);
    const double least = input_.part_of_drawing ? kLinksPerUnknownOfMoved : kLinksPerUnknownOfPart;
    if (of_part.gain < kLeastGainOfPart || gain_in_links < least * kPartUnknowns) return false;
    if (input_.part_of_drawing) return true;
    const auto alone = FitCameras(all, context_, &landmarks);
    return !alone || of_part.gain > kLeastOfAlone * std::max(alone->gain, alone->gain_of_curves);
  }

  // Under the cameras of the last round.
  void FitCurvesAgain() {
    FitCurves(small_views_, options_, context_, false, &control_);
    control_.start = control_.position;
    SeeCurves();
  }

  void Match(double reach, ControlGraph* control) { Match(reach, options_, control); }

  void Match(double reach, const RefinementOptions& options, ControlGraph* control) {
    const TopologyInput images = {
        small_views_,
        *curves_,
        edgels_,
        {reach * options.max_distance_px, 1.0, options.max_angle_deg * kDeg}};
    MatchEdgels(images, options, context_, control);
    FreezeUnshown(control);
  }

  template <typename Visit>
  void ForPulls(const Visit& visit) {
    for (ControlLink& link : control_.links) {
      if (link.frozen) continue;
      for (FitSample& sample : link.samples) {
        for (EdgelPull& pull : sample.pulls) visit(&pull);
      }
    }
  }

  void MeasureResiduals() {
    std::vector<std::vector<double>> residuals(result_.of_view.size());
    ForPulls([&](EdgelPull* pull) {
      const double factor = ViewPxPerPicturePx(scene_.views[pull->ref.view], level_.factor);
      residuals[pull->ref.view].push_back(factor * std::abs(pull->residual_px));
    });
    for (size_t v = 0; v < residuals.size(); ++v) {
      result_.of_view[v].num_edgels = static_cast<int>(residuals[v].size());
      result_.of_view[v].residual_px = Median(std::move(residuals[v]));
    }
  }

  static Eigen::Vector3d MiddleOf(const std::vector<Landmark>& landmarks) {
    std::vector<Eigen::Vector3d> positions;
    for (const Landmark& landmark : landmarks) positions.push_back(landmark.position);
    return MedianPoint(positions);
  }

  CameraFitInput InputOfFit(const Eigen::Vector3d& middle) const {
    CameraFitInput input = {scene_.views, scene_.mounts, given_poses_, {}, {}};
    for (const Rigid3d& pose : given_poses_) {
      input.distances.push_back(std::max((pose * middle).norm(), 1e-6));
    }
    for (size_t v = 0; v < scene_.views.size(); ++v) {
      const int camera = scene_.views[v].camera_index;
      const auto per_px = per_px_.find(camera);
      if (per_px == per_px_.end() || input.parameters.contains(camera)) continue;
      const Eigen::VectorXd change =
          scene_.views[v].calibration->Parameters() - scene_.given[v].calibration->Parameters();
      // Parameters without effect never change.
      input.parameters[camera] =
          (per_px->second.array() > 0).select(change.cwiseQuotient(per_px->second), 0.0);
    }
    return input;
  }

  // The fit of the curves sees lenses as they were: edgels move instead.
  void ShiftPulls(const LandmarkInput& input, const CameraFitInput& before,
                  const CameraFitResult& fit) {
    ForPulls([&](EdgelPull* pull) {
      const int camera = scene_.views[pull->ref.view].camera_index;
      const auto parameters = fit.parameters.find(camera);
      if (parameters == fit.parameters.end()) return;
      const double shift_px =
          EdgelByParameters(input, *pull) * (parameters->second - before.parameters.at(camera));
      const Eigen::Vector2d& across = pull->line.across;
      pull->line.position_px -= shift_px / across.squaredNorm() * across;
    });
  }

  void TakePoses(const CameraFitResult& fit) {
    for (size_t v = 0; v < scene_.views.size(); ++v) {
      const CameraMount& mount = scene_.mounts.of_view[v];
      scene_.views[v].cam_from_world = mount.view_from_body * fit.body_poses[mount.body];
      small_views_[v].cam_from_world = scene_.views[v].cam_from_world;
    }
  }

  void TakeOptics(const CameraFitResult& fit) {
    for (size_t v = 0; v < scene_.views.size(); ++v) {
      View& view = scene_.views[v];
      const auto parameters = fit.parameters.find(view.camera_index);
      if (parameters == fit.parameters.end()) continue;
      const Optics optics = view.calibration->WithParameters(
          scene_.given[v].calibration->Parameters() +
          parameters->second.cwiseProduct(per_px_.at(view.camera_index)));
      SetOptics(optics, &view);
    }
  }

  // Under the cameras as they are now. The curves stay matched as they are, with the given reach.
  void MeasureRows(double matched_reach) {
    if (matched_reach == kReachOfRows) return MeasureRows(control_);
    SeeCurves();
    ControlGraph control = control_;
    Match(kReachOfRows, &control);
    MeasureRows(control);
  }

  void MeasureRows(const ControlGraph& control) {
    const std::map<int, Eigen::VectorXd> none;
    const LandmarkInput input = {scene_.views, *curves_, 1, none,
                                 kReachOfRows * options_.robust_residual_px};
    std::vector<Landmark> landmarks = CurveLandmarks(input, control, kMaxLines);
    std::ranges::move(LandmarksOfPoints(input, scene_.points).landmarks,
                      std::back_inserter(landmarks));
    result_.rows = MeasureRowMotion(scene_.views, landmarks, context_);
  }

  // Of the image of the middle of the scene.
  void MeasureCertainty(CameraCovariance covariance, const Eigen::Vector3d& middle) {
    result_.uncertainty = {std::move(covariance), 1, scene_.mounts, per_px_};
    for (size_t v = 0; v < scene_.views.size(); ++v) {
      CameraEvidence& evidence = result_.of_view[v];
      if (evidence.num_edgels == 0) continue;  // the hold says nothing of the scene
      evidence.certain_by_px =
          CertainByPx(*result_.uncertainty, scene_.views, static_cast<ViewId>(v), middle);
    }
  }

  const CameraRoundsInput& input_;
  RefinementOptions options_;
  const RunContext& context_;
  PictureLevel& level_;
  CameraScene& scene_;
  const std::vector<Rigid3d> given_poses_;
  std::map<int, Eigen::VectorXd> per_px_;
  std::vector<View> small_views_;
  std::vector<std::shared_ptr<const LensMap>> seen_through_;  // with these curves
  const std::vector<ImageCurves>* curves_ = nullptr;          // of the level
  std::vector<std::unique_ptr<ViewEdgels>> edgels_;
  ControlGraph control_;
  bool has_fitted_ = false;
  CameraRoundsResult result_;
};

}  // namespace

CameraRoundsResult RefineCamerasByDrawing(const CameraRoundsInput& input,
                                          const RefinementOptions& options,
                                          const RunContext& context, PictureLevel* level,
                                          CameraScene* scene) {
  // Ceres has absolute constants.
  const double unit = SceneUnit(scene->views, input.graph);
  DrawingGraph edges = Scaled(input.graph, 1 / unit);
  RemoveLinks(AreEdges(edges), &edges);
  CameraScene scaled = Scaled(std::move(*scene), 1 / unit);
  CameraRoundsInput scaled_input = input;
  if (auto& part = scaled_input.part_of_drawing) part->motion.translation() /= unit;
  CameraRoundsResult result =
      CameraRounds(scaled_input, edges, options, context, level, &scaled).Run();
  *scene = Scaled(std::move(scaled), unit);
  if (result.part) result.part->motion.translation() *= unit;
  if (result.uncertainty) {
    result.uncertainty->shift_unit = unit;
    result.uncertainty->mounts = scene->mounts;
  }
  return result;
}

}  // namespace limn
