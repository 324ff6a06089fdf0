// SPDX-License-Identifier: BSD-3-Clause
#include "limn/pipeline/extract_curves.h"

#include <iterator>
#include <optional>
#include <utility>

#include "limn/cache/image_curves_file.h"
#include "limn/edges/given_edgels.h"
#include "limn/model/usable_edgels.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// To be raised whenever edge maps or fragments of the same photograph change, so that kept ones are
// made again.
constexpr int kEdgesVersion = 4;
constexpr int kLinkingVersion = 2;

// Of a file of edges: it is the photograph's.
void CheckSize(const EdgeMap& map, const PinholeCamera& camera, const std::string& path) {
  if (map.width == camera.width && map.height == camera.height) return;
  throw IoError(path, "the edges of an image of another size");
}

int64_t CountEdgelsInFragments(const ImageCurves& curves) {
  int64_t count = 0;
  for (const CurveFragment& fragment : curves.fragments) {
    count += static_cast<int64_t>(fragment.edgel_ids.size());
  }
  return count;
}

// Given curves: what is in none of them is linked to nothing.
ImageCurves WithUnlinked(ImageCurves curves) {
  curves.num_unlinked =
      static_cast<int>(std::ssize(curves.edge_map.edgels) - std::ssize(curves.edge_map.texture) -
                       CountEdgelsInFragments(curves));
  return curves;
}

// From photographs to edge maps and fragments in stored pixels, by way of the cache.
class Extractor {
 public:
  Extractor(const ExtractionInput& input, const EdgeDetectionOptions& edges)
      : input_(input),
        edge_options_(edges),
        edge_key_("edges, version " + std::to_string(kEdgesVersion) + "\n" + OptionsAsText(edges)) {
  }

  // By way of the cache, which keeps them too.
  EdgeMap EdgesOf(ViewId id) {
    const View& view = input_.views[id];
    const std::string key = EdgeKey(id);
    if (auto found = Find(CachedKind::kEdges, view, key)) return std::move(found->edge_map);
    ImageCurves curves;
    curves.edge_map = input_.images.given_edges ? std::move(Given(id).curves.edge_map) : Detect(id);
    Store(CachedKind::kEdges, view, key, curves);
    return std::move(curves.edge_map);
  }

  // By way of the cache. New edge maps are not kept: they are as large as the fragments.
  ImageCurves FragmentsOf(ViewId id, const LinkingOptions& linking) {
    const View& view = input_.views[id];
    const std::string edge_key = EdgeKey(id);
    const std::string key = edge_key + "linking, version " + std::to_string(kLinkingVersion) +
                            "\n" + OptionsAsText(linking);
    if (auto found = Find(CachedKind::kFragments, view, key)) return std::move(*found);
    ImageCurves curves = NewFragments(id, edge_key, linking);
    Store(CachedKind::kFragments, view, key, curves);
    return curves;
  }

 private:
  EdgeMap Detect(ViewId id) const { return DetectEdges(input_.images.read(id), edge_options_); }

  GivenEdges Given(ViewId id) const {
    GivenEdges given = input_.images.given_edges(id);
    if (!given.are_linked) MarkTexture(edge_options_.texture_density, &given.curves.edge_map);
    return given;
  }

  ImageCurves NewFragments(ViewId id, const std::string& edge_key, const LinkingOptions& linking) {
    std::optional<EdgeMap> edges;
    if (input_.images.given_edges) {
      GivenEdges given = Given(id);
      if (given.are_linked) return WithUnlinked(std::move(given.curves));
      edges = std::move(given.curves.edge_map);
    } else if (auto found = Find(CachedKind::kEdges, input_.views[id], edge_key)) {
      edges = std::move(found->edge_map);
    }
    Image image;
    if (!edges || linking.forks == ForkChoice::kHypotheses) image = input_.images.read(id);
    EdgeMap edge_map = edges ? std::move(*edges) : DetectEdges(image, edge_options_);
    return LinkEdgels(std::move(edge_map), linking, &image).curves;
  }

  std::optional<ImageCurves> Find(CachedKind kind, const View& view, const std::string& key) {
    return input_.cache->Find<ImageCurves>(kind, view.name, [&](const std::string& path) {
      std::optional<ImageCurves> found = ReadImageCurves(path, key);
      if (found) CheckSize(found->edge_map, view.camera, path);
      return found;
    });
  }

  void Store(CachedKind kind, const View& view, const std::string& key, const ImageCurves& curves) {
    input_.cache->Store(kind, view.name,
                        [&](const OutputPath& path) { WriteImageCurves(path, curves, key); });
  }

  std::string EdgeKey(ViewId id) const { return input_.images.identity(id) + "\n" + edge_key_; }

  const ExtractionInput& input_;
  const EdgeDetectionOptions& edge_options_;
  std::string edge_key_;
};

// Where the edgels of a view are.
struct ViewCounts {
  int64_t edgels = 0;
  int64_t in_texture = 0;
  int64_t not_linked = 0;   // to any other
  int64_t not_grouped = 0;  // linked, but in no fragment that is long enough
  int64_t outside_lens = 0;
  int64_t in_fragments = 0;
  int64_t fragments = 0;
};

// Before the lens.
ViewCounts CountLinked(const ImageCurves& curves) {
  ViewCounts counts;
  counts.edgels = std::ssize(curves.edge_map.edgels);
  counts.in_texture = std::ssize(curves.edge_map.texture);
  counts.not_linked = curves.num_unlinked;
  counts.not_grouped =
      counts.edgels - counts.in_texture - counts.not_linked - CountEdgelsInFragments(curves);
  return counts;
}

StageSummary Summarize(const std::vector<ViewCounts>& views) {
  ViewCounts sum;
  for (const ViewCounts& view : views) {
    sum.edgels += view.edgels;
    sum.in_texture += view.in_texture;
    sum.not_linked += view.not_linked;
    sum.not_grouped += view.not_grouped;
    sum.outside_lens += view.outside_lens;
    sum.in_fragments += view.in_fragments;
    sum.fragments += view.fragments;
  }
  StageSummary summary;
  summary.stage = "image curves";
  summary.in = {{"views", static_cast<int64_t>(views.size())}, {"edgels", sum.edgels}};
  summary.kept = {{"edgels", sum.in_fragments}, {"fragments", sum.fragments}};
  summary.dropped = {{"edgels: in dense texture", sum.in_texture},
                     {"edgels: not linked to a neighbor", sum.not_linked},
                     {"edgels: fragment too short", sum.not_grouped},
                     {"edgels: outside the lens model", sum.outside_lens}};
  return summary;
}

}  // namespace

EdgeMapsResult ExtractEdgeMaps(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                               const RunContext& context) {
  edges.Check();
  Extractor extractor(input, edges);
  const std::vector<ViewId> ids = IdsOf(input.only, input.views.size());
  input.cache->Expect(CachedKind::kEdges, ids.size());
  EdgeMapsResult result;
  result.edge_maps.resize(input.views.size());
  ParallelFor(context, "edges", ids.size(),
              [&](size_t i) { result.edge_maps[ids[i]] = extractor.EdgesOf(ids[i]); });
  if (input.images.release) input.images.release();
  int64_t num_edgels = 0;
  for (const EdgeMap& map : result.edge_maps) num_edgels += static_cast<int64_t>(map.edgels.size());
  const auto num_views = static_cast<int64_t>(ids.size());
  result.summary.stage = "edges";
  result.summary.in = {{"views", num_views}};
  result.summary.kept = {{"views", num_views}, {"edgels", num_edgels}};
  return result;
}

CurvesResult ExtractCurves(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                           const LinkingOptions& linking, const RunContext& context) {
  edges.Check();
  linking.Check();
  Extractor extractor(input, edges);
  const std::vector<ViewId> ids = IdsOf(input.only, input.views.size());
  input.cache->Expect(CachedKind::kFragments, ids.size());
  CurvesResult result;
  result.curves.resize(input.views.size());
  std::vector<ViewCounts> counts(ids.size());
  ParallelFor(context, "image curves", ids.size(), [&](size_t i) {
    const ViewId v = ids[i];
    ImageCurves& curves = result.curves[v];
    curves = extractor.FragmentsOf(v, linking);
    curves.edge_map.edgels.shrink_to_fit();
    if (input.on_fragments) input.on_fragments(v, curves);
    ViewCounts& of_view = counts[i];
    of_view = CountLinked(curves);
    RemoveUnusableEdgels(ApplyLens(input.views[v].lens.get(), &curves.edge_map), &curves);
    of_view.in_fragments = CountEdgelsInFragments(curves);
    of_view.outside_lens =
        of_view.edgels - of_view.not_linked - of_view.not_grouped - of_view.in_fragments;
    of_view.fragments = static_cast<int64_t>(curves.fragments.size());
  });
  if (input.images.release) input.images.release();
  result.summary = Summarize(counts);
  return result;
}

}  // namespace limn
