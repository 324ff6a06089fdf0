// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/tiled_scene.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "limn/cache/content_hash.h"
#include "limn/cache/curves_key.h"
#include "limn/cache/stage_file.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/json_drawing_writer.h"
#include "limn/kinds/classify_kinds.h"
#include "limn/pipeline/sketch_views.h"
#include "limn/tiles/tile_joining.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// To be raised whenever the drawing of the same tile changes, so that kept ones are made again.
constexpr int kTileVersion = 9;

std::string TileName(size_t index) { return "tile-" + std::to_string(index + 1); }

std::string HintsKey(const SceneHints& hints) {
  ContentHash hash;
  hash.AddNumber(hints.points.size());
  for (const ScenePoint& point : hints.points) {
    for (const double value : point.position_in_world) hash.AddNumber(value);
    hash.AddNumbers(point.views);
  }
  return hash.Hex();
}

std::string TileKey(const SceneSubset& scene, const std::vector<ImageCurves>& curves,
                    const Eigen::AlignedBox3d& reach, PipelineOptions options,
                    const RunContext& context) {
  // What comes after the tiles, and what views and reach tell already.
  options.primitives = {};
  options.regularize = false;
  options.regularity = {};
  options.surfaces = {};
  options.tiles = {};
  return "tile, version " + std::to_string(kTileVersion) + "." + std::to_string(kSketchVersion) +
         "\n" + OptionsAsJson(options) + "\nhints " + HintsKey(scene.hints) + "\nbox " +
         BoxKey(reach) + "\n" + CurvesKey(scene.views, curves, context);
}

std::vector<std::string> NamesOf(const std::vector<View>& views) {
  std::vector<std::string> names;
  for (const View& view : views) names.push_back(view.name);
  return names;
}

// Of those with these indices, the tiles whose views can triangulate something.
std::vector<int> Drawable(const TiledInput& input, std::vector<int> tiles) {
  std::erase_if(tiles, [&](int index) {
    std::vector<View> views;
    for (const ViewId view : input.tiles[index].views) views.push_back(input.views[view]);
    return !WhyNothingIsTriangulated(views).empty();
  });
  return tiles;
}

class TileDrawer {
 public:
  TileDrawer(const TiledInput& input, const PipelineOptions& options, const RunContext& context,
             const StageObserver& on_stage_end)
      : input_(input), options_(options), context_(context), on_stage_end_(on_stage_end) {
    options.Check();
  }

  // Supporting views are ids in the whole scene. Throws InputError if the tile is not drawable.
  DrawingGraph Draw(size_t index) const {
    const SceneSubset scene = SubsetOf(input_.views, input_.hints, input_.tiles[index].views);
    DrawingGraph graph = DrawSubset(index, scene);
    for (DrawingLink& link : graph.links) {
      for (ViewId& view : link.supporting_views) view = scene.ids[view];
    }
    return graph;
  }

 private:
  DrawingGraph DrawSubset(size_t index, const SceneSubset& scene) const {
    const auto report = [&](StageSummary summary) {
      summary.stage +=
          ", tile " + std::to_string(index + 1) + "/" + std::to_string(input_.tiles.size());
      on_stage_end_(summary);
    };
    const CurvesResult image_curves = input_.curves_of(scene);
    report(image_curves.summary);
    const Eigen::AlignedBox3d& reach = input_.tiles[index].reach;
    const std::string key = TileKey(scene, image_curves.curves, reach, options_, context_);
    if (auto kept = Find(index, scene, key)) return *std::move(kept);
    const CurvesScene curves = {scene.views, image_curves.curves, scene.hints, reach};
    const DrawnCurves drawn =
        DrawCurves(curves, options_, input_.cache, context_, report, TileName(index));
    DrawingGraph graph = RefineAndJudge({curves, drawn.drawing.graph}, options_, context_, report);
    Keep(index, scene, key, graph);
    return graph;
  }

  std::optional<DrawingGraph> Find(size_t index, const SceneSubset& scene,
                                   const std::string& key) const {
    return input_.cache->Find<DrawingGraph>(
        CachedKind::kDrawing, TileName(index),
        [&](const std::string& path) -> std::optional<DrawingGraph> {
          const auto text = ReadStageFile(path, StageKind::kDrawing, key);
          if (!text) return std::nullopt;
          DrawingFile file = ParseDrawingJson(path, *text);
          if (file.metadata.view_names != NamesOf(scene.views)) return std::nullopt;
          return std::move(file.graph);
        });
  }

  void Keep(size_t index, const SceneSubset& scene, const std::string& key,
            const DrawingGraph& graph) const {
    input_.cache->Store(CachedKind::kDrawing, TileName(index), [&](const OutputPath& path) {
      std::ostringstream text;
      WriteDrawingJson(graph, {NamesOf(scene.views)}, text);
      WriteStageFile(path, StageKind::kDrawing, key, text.str());
    });
  }

  const TiledInput& input_;
  const PipelineOptions& options_;
  const RunContext& context_;
  const StageObserver& on_stage_end_;
};

StageSummary Summarize(const TiledInput& input, size_t num_drawn, const JoinedTiles& joined,
                       int64_t links_in) {
  std::vector<uint8_t> is_used(input.views.size(), 0);
  for (const Tile& tile : input.tiles) {
    for (const ViewId view : tile.views) is_used[view] = 1;
  }
  const auto num_used = static_cast<int64_t>(std::count(is_used.begin(), is_used.end(), 1));
  const auto num_links = static_cast<int64_t>(joined.graph.links.size());
  StageSummary summary;
  summary.stage = "joining tiles";
  summary.in = {{"tiles", static_cast<int64_t>(input.tiles.size())},
                {"views", static_cast<int64_t>(input.views.size())},
                {"links of the tiles", links_in}};
  summary.kept = {{"views", num_used},
                  {"links", num_links},
                  {"links joined at borders", joined.joined},
                  {"ends left open at borders", joined.open_ends}};
  summary.dropped = {
      {"tiles: nothing to triangulate", static_cast<int64_t>(input.tiles.size() - num_drawn)},
      {"views: not needed by any tile", static_cast<int64_t>(input.views.size()) - num_used},
      {"links: short, and open at a border", joined.stubs}};
  return summary;
}

}  // namespace

std::function<CurvesResult(const SceneSubset&)> CurvesFromImages(const PipelineInput& input,
                                                                 const PipelineOptions& options,
                                                                 const RunContext& context) {
  return [input, &options, &context](const SceneSubset& scene) {
    ImageSource images = {[&](ViewId view) { return input.images.read(scene.ids[view]); },
                          [&](ViewId view) { return input.images.identity(scene.ids[view]); }};
    if (input.images.given_edges) {
      images.given_edges = [&](ViewId view) { return input.images.given_edges(scene.ids[view]); };
    }
    images.release = input.images.release;
    return ExtractCurves({scene.views, images, input.cache}, options.edges, options.linking,
                         context);
  };
}

DrawingGraph DrawTiles(const TiledInput& input, const PipelineOptions& options,
                       const RunContext& context, const StageObserver& on_stage_end) {
  const TileDrawer drawer(input, options, context, on_stage_end);
  const std::vector<int> tiles = Drawable(input, ItemsOf({}, input.tiles.size()));
  input.cache->Expect(CachedKind::kDrawing, tiles.size());
  std::vector<TileDrawing> drawings;
  int64_t num_links = 0;
  for (const int tile : tiles) {
    drawings.push_back({input.tiles[tile].core, drawer.Draw(tile)});
    num_links += static_cast<int64_t>(drawings.back().graph.links.size());
  }
  JoinedTiles joined = JoinTiles(std::move(drawings), input.views);
  on_stage_end(Summarize(input, tiles.size(), joined, num_links));
  return DescribeLinks(std::move(joined.graph), input.views, input.read_image, options, context,
                       on_stage_end);
}

void MakeShardTiles(const TiledInput& input, const PipelineOptions& options, const Shard& shard,
                    const RunContext& context, const StageObserver& on_stage_end) {
  const TileDrawer drawer(input, options, context, on_stage_end);
  const std::vector<int> tiles = Drawable(input, ItemsOf(shard, input.tiles.size()));
  input.cache->Expect(CachedKind::kDrawing, tiles.size());
  for (const int tile : tiles) drawer.Draw(tile);
  CheckKept(*input.cache, CachedKind::kDrawing);
}

}  // namespace limn
