// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/update_scene.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "limn/belief/short_curves.h"
#include "limn/cache/curves_key.h"
#include "limn/cache/view_sketch_file.h"
#include "limn/geometry/polyline.h"
#include "limn/kinds/classify_kinds.h"
#include "limn/kinds/texture.h"
#include "limn/model/footprint.h"
#include "limn/model/scene_subset.h"
#include "limn/pipeline/scene_record.h"
#include "limn/pipeline/sketch_views.h"
#include "limn/support/edgel_index.h"
#include "limn/support/edgel_residual.h"
#include "limn/tiles/changed_places.h"
#include "limn/tiles/tile_joining.h"
#include "limn/tiles/tile_plan.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// If a larger share of the views has changed, everything is drawn: what they add to places that are
// drawn already is lost.
constexpr double kMaxChangedShare = 0.1;
// In fewer views every view is the partner of all others.
constexpr size_t kMinViews = 20;
// A link that loses this share of the views that support it is drawn again.
constexpr double kLostShare = 0.25;
// A view supports a link with this many edgels along it, at steps of a px.
constexpr int kMinSupport = 5;

std::vector<RecordedView> RecordOf(const std::vector<View>& views,
                                   const std::vector<std::string>& keys) {
  std::vector<RecordedView> recorded;
  for (size_t v = 0; v < views.size(); ++v) {
    recorded.push_back({views[v].name, keys[v]});
  }
  return recorded;
}

// Of sketches that SketchViews made with these plans; `recorded` has all views.
std::vector<RecordedSketch> SketchesOf(const PipelineInput& input,
                                       const std::vector<ImageCurves>& curves,
                                       const std::vector<ViewPlan>& plans,
                                       const std::vector<RecordedView>& recorded,
                                       const PipelineOptions& options) {
  std::vector<std::string> keys;
  for (const RecordedView& view : recorded) keys.push_back(view.key);
  std::vector<RecordedSketch> sketches;
  for (ViewId v = 0; v < std::ssize(plans); ++v) {
    if (!plans[v].is_primary) continue;
    const SketchIdentity identity =
        IdentityOfSketch(options.mode, {{input.views, curves, input.hints, input.box}},
                         options.sketch, v, plans[v], keys);
    RecordedSketch sketch = {identity.PlaceOf(v), identity.key, {}};
    for (const ViewId id : identity.views) sketch.views.push_back(recorded[id]);
    sketches.push_back(std::move(sketch));
  }
  return sketches;
}

// Which of the recorded views still exist, unchanged.
class ViewMatches {
 public:
  explicit ViewMatches(const std::vector<RecordedView>& now) {
    for (size_t v = 0; v < now.size(); ++v) {
      ids_[{now[v].name, now[v].key}] = static_cast<ViewId>(v);
    }
  }
  // -1: gone or changed.
  ViewId PresentId(const RecordedView& view) const {
    const auto found = ids_.find({view.name, view.key});
    return found == ids_.end() ? -1 : found->second;
  }
  std::vector<ViewId> PresentIds(const std::vector<RecordedView>& views) const {
    std::vector<ViewId> ids;
    for (const RecordedView& view : views) ids.push_back(PresentId(view));
    return ids;
  }

 private:
  std::map<std::pair<std::string, std::string>, ViewId> ids_;
};

bool AreAscending(std::vector<ViewId> ids) {
  std::erase(ids, -1);
  return std::ranges::is_sorted(ids);
}

// What has changed between a record and now.
struct ViewChanges {
  std::vector<ViewId> now;      // per view of the record; -1: gone or changed
  std::vector<ViewId> added;    // ascending
  std::vector<uint8_t> is_new;  // per view
  int64_t num_gone = 0;         // of the record, changed ones among them
};

ViewChanges ChangesSince(const SceneRecord& record, const ViewMatches& matches, size_t num_views) {
  ViewChanges changes;
  changes.now = matches.PresentIds(record.views);
  changes.is_new.assign(num_views, 1);
  for (const ViewId id : changes.now) {
    if (id >= 0) changes.is_new[id] = 0;
  }
  for (size_t v = 0; v < num_views; ++v) {
    if (changes.is_new[v]) changes.added.push_back(static_cast<ViewId>(v));
  }
  changes.num_gone = std::ranges::count(changes.now, -1);
  return changes;
}

// Links of the record with their remaining views, in present ids.
void RenumberSupport(const std::vector<ViewId>& now, DrawingGraph* graph) {
  for (DrawingLink& link : graph->links) {
    std::vector<ViewId> left;
    for (const ViewId view : link.supporting_views) {
      if (now[view] >= 0) left.push_back(now[view]);
    }
    link.supporting_views = std::move(left);
    link.members.clear();
  }
}

// Enters a new view where it supports links.
void AddSupport(ViewId id, const View& view, const ImageCurves& curves, const SupportGate& gate,
                const std::vector<View>& views, DrawingGraph* graph) {
  const EdgelIndex index(curves.edge_map, LinkedEdgels(curves));
  for (DrawingLink& link : graph->links) {
    const double footprint = LinkFootprint(link, views);
    if (!(footprint > 0)) continue;
    const Polyline3d points = ResampleUniform(link.points_in_world, footprint);
    int support = 0;
    for (size_t k = 0; k + 1 < points.size() && support < kMinSupport; ++k) {
      const auto px = view.Project(points[k]);
      if (!px) continue;
      const auto direction = ProjectedDirection(view, points[k], points[k + 1] - points[k]);
      support += direction && index.Best(*px, *direction, gate).has_value();
    }
    if (support < kMinSupport) continue;
    std::vector<ViewId>& supporting = link.supporting_views;
    supporting.insert(std::ranges::lower_bound(supporting, id), id);
  }
}

template <typename Item>
std::vector<Item> Part(const std::vector<Item>& items, size_t begin, size_t end) {
  return {items.begin() + static_cast<std::ptrdiff_t>(begin),
          items.begin() + static_cast<std::ptrdiff_t>(end)};
}

// Samples [begin, end) of a curve.
Curve3D Part(const Curve3D& curve, size_t begin, size_t end) {
  if (begin == 0 && end == curve.size()) return curve;
  Curve3D part;
  part.points_in_world = Part(curve.points_in_world, begin, end);
  part.tangents_in_world = Part(curve.tangents_in_world, begin, end);
  part.depth_sigma = Part(curve.depth_sigma, begin, end);
  part.certain = Part(curve.certain, begin, end);
  part.anchor = curve.anchor;
  part.anchor.begin += curve.anchor.step * static_cast<int>(begin);
  for (size_t i = begin; i < end; ++i) part.support.Append(curve.support.Of(i));
  return part;
}

// The parts of curves that are in one of the places.
CurveSketch CurvesWithin(const std::vector<ChangedPlace>& places, const CurveSketch& sketch) {
  const auto is_within = [&](const Eigen::Vector3d& point) {
    return std::ranges::any_of(
        places, [&](const ChangedPlace& place) { return place.reach.contains(point); });
  };
  CurveSketch within;
  for (const Curve3D& curve : sketch.curves) {
    const std::vector<Eigen::Vector3d>& points = curve.points_in_world;
    for (auto begin = points.begin(); begin != points.end();) {
      begin = std::find_if(begin, points.end(), is_within);
      const auto end = std::find_if_not(begin, points.end(), is_within);
      if (end - begin > 1) {
        within.curves.push_back(Part(curve, begin - points.begin(), end - points.begin()));
      }
      begin = end;
    }
  }
  return within;
}

// The part of a view's image that a box may appear in.
Eigen::AlignedBox2d ImageOf(const Eigen::AlignedBox3d& box, const View& view) {
  Eigen::AlignedBox2d image;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d in_cam =
        view.cam_from_world *
        Eigen::Vector3d(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
    if (!(in_cam.z() > 0)) return {view.region.min_px, view.region.max_px};
    image.extend(view.camera.Project(in_cam));
  }
  return image;
}

// Image curves without the edgels of fragments that are outside of all places.
ImageCurves CurvesSeenIn(const std::vector<ChangedPlace>& places, const View& view,
                         ImageCurves curves) {
  std::vector<Eigen::AlignedBox2d> images;
  for (const ChangedPlace& place : places) images.push_back(ImageOf(place.reach, view));
  const auto is_seen = [&](EdgelId id) {
    return std::ranges::any_of(images, [&](const Eigen::AlignedBox2d& image) {
      return image.contains(curves.edge_map.edgels[id].position_px);
    });
  };
  for (CurveFragment& fragment : curves.fragments) {
    if (std::ranges::none_of(fragment.edgel_ids, is_seen)) fragment.edgel_ids.clear();
  }
  return curves;
}

// Views with edgels along the curves, ascending.
std::vector<ViewId> SupportingViews(const CurveSketch& sketch) {
  std::set<ViewId> views;
  for (const Curve3D& curve : sketch.curves) {
    for (const EdgelRef& ref : curve.support.edgels) views.insert(ref.view);
  }
  return {views.begin(), views.end()};
}

class SceneUpdater {
 public:
  SceneUpdater(const PipelineInput& input, const std::vector<ImageCurves>& curves,
               const PipelineOptions& options, const RunContext& context,
               const StageObserver& on_stage_end)
      : input_(input),
        curves_(curves),
        options_(options),
        context_(context),
        on_stage_end_(on_stage_end),
        recorded_(RecordOf(input.views, ViewKeys(input.views, curves, context))),
        matches_(recorded_) {}

  std::optional<PipelineResult> Run(std::string* why_not) {
    std::optional<SceneRecord> record;
    std::vector<std::vector<Curve3D>> by_view(input_.views.size());
    try {
      record = FindRecord(RecordKey(options_, input_.box), *input_.cache);
      *why_not = record ? WhyNot(*record) : "there is no drawing made with these options";
      if (!why_not->empty()) return std::nullopt;
      KeepSketches(&record->sketches, &by_view);
    } catch (const IoError& damaged) {
      *why_not = damaged.what();
      return std::nullopt;
    }
    return Update(*std::move(record), std::move(by_view));
  }

 private:
  std::string WhyNot(const SceneRecord& record) const {
    const std::vector<ViewId> drawn = matches_.PresentIds(record.drawn_views);
    const auto num_gone = static_cast<size_t>(std::ranges::count(drawn, -1));
    const size_t num_new = input_.views.size() - (drawn.size() - num_gone);
    const size_t num_changes = std::max(num_new, num_gone);
    const size_t num_views = std::max(input_.views.size(), drawn.size());
    if (num_changes > 0 && num_views < kMinViews) {
      return "of fewer than " + std::to_string(kMinViews) +
             " images, some are new, changed or gone";
    }
    if (static_cast<double>(num_changes) > kMaxChangedShare * static_cast<double>(num_views)) {
      return std::to_string(num_changes) + " of " + std::to_string(num_views) +
             " images are new, changed or gone since everything was drawn";
    }
    if (!AreAscending(matches_.PresentIds(record.views))) return "the images are in another order";
    for (const RecordedSketch& sketch : record.sketches) {
      if (!AreAscending(matches_.PresentIds(sketch.views)))
        return "the images are in another order";
    }
    return "";
  }

  // `by_view` has the sketches of the record that are left.
  PipelineResult Update(SceneRecord record, std::vector<std::vector<Curve3D>> by_view) {
    const ViewChanges changes = ChangesSince(record, matches_, input_.views.size());
    PipelineResult result;
    AddSketches(changes.added, &record.sketches, &by_view);
    for (std::vector<Curve3D>& of_view : by_view) {
      std::ranges::move(of_view, std::back_inserter(result.sketch.curves));
    }
    const std::vector<uint8_t> lost = SupportNow(changes, &record.graph);
    const std::vector<ChangedPlace> places =
        FindChangedPlaces({input_.views, record.graph, lost, result.sketch, changes.is_new});
    on_stage_end_(Summarize(changes, places.size()));
    result.graph = std::move(record.graph);
    if (places.empty()) {
      MeasureLinks(input_.views, context_, &result.graph);
    } else {
      result.graph = DrawPlaces(places, result.sketch, std::move(result.graph));
    }
    result.new_views = changes.added;
    record.views = recorded_;
    record.graph = result.graph;
    result.keep = [record = std::move(record), key = RecordKey(options_, input_.box),
                   cache = input_.cache] { KeepRecord(record, key, cache); };
    return result;
  }

  // Gives the links present view ids. Returns which links lost too many views.
  std::vector<uint8_t> SupportNow(const ViewChanges& changes, DrawingGraph* graph) const {
    std::vector<size_t> before;
    for (const DrawingLink& link : graph->links) before.push_back(link.supporting_views.size());
    RenumberSupport(changes.now, graph);
    for (const ViewId v : changes.added) {
      AddSupport(v, input_.views[v], curves_[v], options_.drawing.Gate(), input_.views, graph);
    }
    std::vector<uint8_t> lost;
    for (size_t l = 0; l < before.size(); ++l) {
      const size_t left = graph->links[l].supporting_views.size();
      lost.push_back(left < before[l] && static_cast<double>(before[l] - left) >=
                                             kLostShare * static_cast<double>(before[l]));
    }
    return lost;
  }

  // Keeps and reads the sketches of views that are as they were. Throws IoError of the first that
  // is lost.
  void KeepSketches(std::vector<RecordedSketch>* sketches,
                    std::vector<std::vector<Curve3D>>* by_view) const {
    std::erase_if(*sketches, [&](const RecordedSketch& sketch) { return ViewOf(sketch) < 0; });
    std::vector<std::optional<IoError>> errors(sketches->size());
    ParallelFor(context_, "kept sketches", sketches->size(), [&](size_t i) {
      const RecordedSketch& sketch = (*sketches)[i];
      try {
        (*by_view)[ViewOf(sketch)] = ReadSketch(sketch).curves;
      } catch (const IoError& error) {
        errors[i].emplace(error);
      }
    });
    for (const std::optional<IoError>& error : errors) {
      if (error) throw IoError(*error);
    }
  }

  // The view now; -1 if it is gone or changed.
  ViewId ViewOf(const RecordedSketch& sketch) const {
    return matches_.PresentId(sketch.views[sketch.place]);
  }

  ViewSketch ReadSketch(const RecordedSketch& recorded) const {
    auto sketch = input_.cache->Read<ViewSketch>(
        CachedKind::kSketch, recorded.ViewName(), [&](const std::string& path) {
          return ReadViewSketch(path, ViewOf(recorded), matches_.PresentIds(recorded.views),
                                input_.views, curves_, recorded.key);
        });
    if (!sketch) {
      throw IoError(input_.cache->dir(), "has not the sketch of \"" + recorded.ViewName() +
                                             "\" that the drawing was made from");
    }
    return *std::move(sketch);
  }

  void AddSketches(const std::vector<ViewId>& added, std::vector<RecordedSketch>* sketches,
                   std::vector<std::vector<Curve3D>>* by_view) const {
    if (added.empty()) return;
    std::vector<uint8_t> is_sketched(input_.views.size(), 0);
    for (const RecordedSketch& sketch : *sketches) is_sketched[ViewOf(sketch)] = 1;
    const std::vector<ViewPlan> plans = PlanAddedViews(
        input_.views, input_.hints, added, is_sketched, options_.sketch.view_selection, context_);
    SketchResult sketch = SketchViews(
        options_.mode, {{input_.views, curves_, input_.hints, input_.box}, added, &plans},
        options_.sketch, input_.cache, context_);
    on_stage_end_(sketch.summary);
    for (Curve3D& curve : sketch.sketch.curves) {
      (*by_view)[curve.anchor.view].push_back(std::move(curve));
    }
    for (RecordedSketch& one : SketchesOf(input_, curves_, plans, recorded_, options_)) {
      sketches->push_back(std::move(one));
    }
  }

  DrawingGraph DrawPlaces(const std::vector<ChangedPlace>& places, const CurveSketch& sketch,
                          DrawingGraph old) const {
    Eigen::AlignedBox3d box;
    for (const ChangedPlace& place : places) box.extend(place.reach);
    if (input_.box) box = box.intersection(*input_.box);
    const DrawingGraph drawn = DrawCurvesOf(CurvesWithin(places, sketch), places, box);
    std::vector<TileDrawing> tiles = {{AllSpace(), std::move(old)}};
    for (const ChangedPlace& place : places) {
      tiles.front().holes.push_back(place.core);
      tiles.push_back({place.core, drawn});
    }
    return DescribeChanged(JoinTiles(std::move(tiles), input_.views).graph);
  }

  // The drawing of a part of the sketch, by what the views that show it have in these places.
  DrawingGraph DrawCurvesOf(CurveSketch sketch, const std::vector<ChangedPlace>& in,
                            const Eigen::AlignedBox3d& box) const {
    const SceneSubset scene = SubsetOf(input_.views, {}, SupportingViews(sketch));
    std::vector<ImageCurves> curves;
    for (const ViewId id : scene.ids) {
      curves.push_back(CurvesSeenIn(in, input_.views[id], curves_[id]));
    }
    RenumberViews(PlacesIn(scene.ids, input_.views.size()), &sketch.curves);
    const CurvesScene in_scene = {scene.views, curves, kNoHints, box};
    DrawingResult drawing = BuildDrawing({in_scene, sketch}, options_.drawing, context_);
    on_stage_end_(drawing.summary);
    DrawingGraph graph =
        RefineAndJudge({in_scene, drawing.graph}, options_, context_, on_stage_end_);
    for (DrawingLink& link : graph.links) {
      for (ViewId& view : link.supporting_views) view = scene.ids[view];
    }
    return graph;
  }

  // Primitives and kinds of the links that have none, since they are new or changed, and
  // confidences and doubt of all.
  DrawingGraph DescribeChanged(DrawingGraph graph) const {
    std::vector<uint8_t> changed;
    for (const DrawingLink& link : graph.links) changed.push_back(!link.primitive);
    BelieveShortCurves(&graph);
    MeasureLinks(input_.views, context_, &graph);
    graph = RefitPrimitives(graph, changed, input_.views, options_.primitives, context_);
    if (input_.images.read) TellKindsOfChanged(changed, &graph);
    DoubtShortCurves(input_.views, &graph);
    return graph;
  }

  void TellKindsOfChanged(const std::vector<uint8_t>& changed, DrawingGraph* graph) const {
    // Light, exposure and sharpness are measured on all links.
    KindsResult kinds = ClassifyKinds({input_.views, input_.images.read, *graph}, context_);
    if (input_.images.release) input_.images.release();
    for (size_t l = 0; l < graph->links.size(); ++l) {
      // What is texture or a cast shadow depends on other links, too.
      DrawingLink& link = graph->links[l];
      const DrawingLink& judged = kinds.graph.links[l];
      const bool depends = link.kind == LinkKind::kTexture || link.kind == LinkKind::kShadow ||
                           judged.kind == LinkKind::kShadow;
      if (!changed[l] && !depends) continue;
      link.kind = judged.kind;
      link.kind_confidence = judged.kind_confidence;
    }
    MarkTexture(input_.views, graph);
  }

  StageSummary Summarize(const ViewChanges& changes, size_t num_places) const {
    const auto num_new = static_cast<int64_t>(changes.added.size());
    const auto num_views = static_cast<int64_t>(input_.views.size());
    StageSummary summary;
    summary.stage = "update";
    summary.in = {{"images", num_views + changes.num_gone}};
    summary.kept = {{"images: unchanged", num_views - num_new},
                    {"images: new or changed", num_new},
                    {"places drawn again", static_cast<int64_t>(num_places)}};
    summary.dropped = {{"images: gone, or as they were before they changed", changes.num_gone}};
    return summary;
  }

  const PipelineInput& input_;
  const std::vector<ImageCurves>& curves_;
  const PipelineOptions& options_;
  const RunContext& context_;
  const StageObserver& on_stage_end_;
  std::vector<RecordedView> recorded_;  // in present order
  ViewMatches matches_;
};

// Empty if drawings made with these options can be brought up to date.
std::string WhyNeverUpdated(const PipelineOptions& options) {
  if (options.mode == SketchMode::kOriginal) {
    return "mode = " + std::string(SketchModeName(options.mode)) +
           ": this sketch is not made view by view";
  }
  if (options.IsPaper()) return "Drawing.method = paper: keeps its drawings together";
  if (options.refine_cameras == CameraRefinement::kOn) {
    return "refine_cameras = 1: takes all views together";
  }
  if (options.regularize) return "regularize = 1: takes all links together";
  return "";
}

}  // namespace

bool IsUpdatable(const PipelineOptions& options) { return WhyNeverUpdated(options).empty(); }

void CheckUpdatable(const PipelineOptions& options) {
  const std::string reason = WhyNeverUpdated(options);
  if (!reason.empty()) {
    throw OptionError(reason + ", and its drawings cannot be brought up to date");
  }
}

std::function<void()> RecordWriter(const PipelineInput& input,
                                   const std::vector<ImageCurves>& curves,
                                   const std::vector<ViewPlan>& plans, const DrawingGraph& graph,
                                   const PipelineOptions& options, const RunContext& context) {
  if (!input.cache->IsOn() || !IsUpdatable(options)) return [] {};
  const std::vector<RecordedView> views =
      RecordOf(input.views, ViewKeys(input.views, curves, context));
  SceneRecord record = {views, SketchesOf(input, curves, plans, views, options), views, graph};
  return [record = std::move(record), key = RecordKey(options, input.box), cache = input.cache] {
    KeepRecord(record, key, cache);
  };
}

std::optional<PipelineResult> UpdateScene(const PipelineInput& input,
                                          std::vector<ImageCurves>* curves,
                                          const PipelineOptions& options, const RunContext& context,
                                          const StageObserver& on_stage_end, std::string* why_not) {
  CheckUpdatable(options);
  std::optional<PipelineResult> result =
      SceneUpdater(input, *curves, options, context, on_stage_end).Run(why_not);
  if (result) result->curves = std::move(*curves);
  return result;
}

}  // namespace limn
