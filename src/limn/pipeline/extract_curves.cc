#include "limn/pipeline/extract_curves.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>
#include <utility>

#include "limn/io/image_curves_file.h"
#include "limn/pipeline/content_hash.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Where the results of earlier runs are, and whether they can be used.
class Cache {
 public:
  Cache(const std::string& dir, const char* kind) : dir_(dir), kind_(kind) {}

  // Nothing if there is no file, or it was made from something else, or is damaged.
  std::optional<ImageCurves> Find(const View& view, const std::string& key) {
    const std::string path = PathOf(view);
    std::error_code ignored;
    if (dir_.empty() || !std::filesystem::exists(path, ignored)) return std::nullopt;
    try {
      std::optional<ImageCurves> found = ReadImageCurves(path, key);
      ++(found ? reused_ : outdated_);
      return found;
    } catch (const IoError&) {
      // A damaged cache costs time, never the run; it is counted with the outdated files.
      ++outdated_;
      return std::nullopt;
    }
  }

  void Store(const View& view, const std::string& key, const ImageCurves& curves) const {
    if (!dir_.empty()) WriteImageCurves(PathOf(view), curves, key);
  }

  CacheUse Use() const { return {reused_, outdated_}; }

 private:
  std::string PathOf(const View& view) const {
    return (std::filesystem::path(dir_) / kind_ / (view.name + ".bin")).string();
  }

  std::string dir_;
  const char* kind_;
  std::atomic<int64_t> reused_ = 0;
  std::atomic<int64_t> outdated_ = 0;
};

// From photographs to edge maps and fragments in stored pixels, by way of the cache.
class Extractor {
 public:
  Extractor(const ExtractionInput& input, const EdgeDetectionOptions& edges)
      : input_(input), edge_options_(edges), edge_key_(OptionsAsText(edges)) {}

  // By way of the cache, which keeps them too.
  EdgeMap EdgesOf(ViewId id) {
    const View& view = input_.views[id];
    const std::string key = EdgeKey(id);
    if (auto found = edges_.Find(view, key)) return std::move(found->edge_map);
    ImageCurves curves;
    curves.edge_map = DetectEdges(input_.images.read(id), edge_options_);
    edges_.Store(view, key, curves);
    return std::move(curves.edge_map);
  }

  // By way of the cache. New edge maps are not kept: they are as large as the fragments.
  ImageCurves FragmentsOf(ViewId id, const LinkingOptions& linking) {
    const View& view = input_.views[id];
    const std::string edge_key = EdgeKey(id);
    const std::string key = edge_key + OptionsAsText(linking);
    if (auto found = fragments_.Find(view, key)) return std::move(*found);
    auto edges = edges_.Find(view, edge_key);
    ImageCurves curves = LinkEdgels(edges ? std::move(edges->edge_map)
                                          : DetectEdges(input_.images.read(id), edge_options_),
                                    linking)
                             .curves;
    fragments_.Store(view, key, curves);
    return curves;
  }

  CacheUse EdgesUse() const { return edges_.Use(); }
  CacheUse FragmentsUse() const { return fragments_.Use(); }

 private:
  std::string EdgeKey(ViewId id) const { return input_.images.identity(id) + "\n" + edge_key_; }

  const ExtractionInput& input_;
  const EdgeDetectionOptions& edge_options_;
  std::string edge_key_;
  Cache edges_{input_.cache_dir, "edges"};
  Cache fragments_{input_.cache_dir, "fragments"};
};

// Where the edgels of a view are.
struct ViewCounts {
  int64_t edgels = 0;
  int64_t not_linked = 0;   // in no link of the link graph
  int64_t not_grouped = 0;  // linked, but in no fragment that is long enough
  int64_t outside_lens = 0;
  int64_t in_fragments = 0;
  int64_t fragments = 0;
};

int64_t CountEdgelsInFragments(const ImageCurves& curves) {
  int64_t count = 0;
  for (const CurveFragment& fragment : curves.fragments) {
    count += static_cast<int64_t>(fragment.edgel_ids.size());
  }
  return count;
}

// Before the lens.
ViewCounts CountLinked(const ImageCurves& curves) {
  ViewCounts counts;
  const size_t num_edgels = curves.edge_map.edgels.size();
  std::vector<bool> linked(num_edgels, false);
  for (const EdgelLink& link : curves.link_graph) linked[link.a] = linked[link.b] = true;
  for (const CurveFragment& fragment : curves.fragments) {
    for (const EdgelId id : fragment.edgel_ids) linked[id] = true;
  }
  counts.edgels = static_cast<int64_t>(num_edgels);
  counts.not_linked = std::count(linked.begin(), linked.end(), false);
  counts.not_grouped = counts.edgels - counts.not_linked - CountEdgelsInFragments(curves);
  return counts;
}

StageSummary Summarize(const std::vector<ViewCounts>& views) {
  ViewCounts sum;
  for (const ViewCounts& view : views) {
    sum.edgels += view.edgels;
    sum.not_linked += view.not_linked;
    sum.not_grouped += view.not_grouped;
    sum.outside_lens += view.outside_lens;
    sum.in_fragments += view.in_fragments;
    sum.fragments += view.fragments;
  }
  StageSummary summary;
  summary.stage = "image curves";
  summary.in = {{"images", static_cast<int64_t>(views.size())}, {"edgels", sum.edgels}};
  summary.kept = {{"edgels", sum.in_fragments}, {"fragments", sum.fragments}};
  summary.dropped = {{"edgels: not linked to a neighbour", sum.not_linked},
                     {"edgels: fragment too short", sum.not_grouped},
                     {"edgels: outside the lens model", sum.outside_lens}};
  return summary;
}

// The usable runs of a fragment. Of a closed one the last run may continue in the first.
std::vector<CurveFragment> UsableRuns(const CurveFragment& fragment,
                                      const std::vector<bool>& usable) {
  const auto& ids = fragment.edgel_ids;
  const size_t size = ids.size();
  size_t first_gap = 0;
  while (first_gap < size && usable[ids[first_gap]]) ++first_gap;
  if (first_gap == size) return {fragment};
  // Start a closed fragment at a gap, so that no run passes the end.
  const size_t start = fragment.closed ? first_gap : 0;
  std::vector<CurveFragment> runs;
  CurveFragment run;
  for (size_t k = 0; k <= size; ++k) {
    const EdgelId id = k < size ? ids[(start + k) % size] : kInvalidEdgel;
    if (id != kInvalidEdgel && usable[id]) {
      run.edgel_ids.push_back(id);
      continue;
    }
    if (run.edgel_ids.size() >= 2) runs.push_back(run);
    run.edgel_ids.clear();
  }
  return runs;
}

template <typename T>
std::string_view BytesOf(const T* first, size_t count) {
  return {reinterpret_cast<const char*>(first), count * sizeof(T)};
}

void AddView(const View& view, ContentHash* hash) {
  const PinholeCamera& camera = view.camera;
  const Rigid3d& pose = view.cam_from_world;
  hash->Add(view.name);
  for (const double value : {camera.fx, camera.fy, camera.cx, camera.cy}) {
    hash->Add(BytesOf(&value, 1));
  }
  hash->Add(BytesOf(pose.rotation.coeffs().data(), 4));
  hash->Add(BytesOf(pose.translation.data(), 3));
}

void AddCurves(const ImageCurves& curves, ContentHash* hash) {
  for (const Edgel& edgel : curves.edge_map.edgels) hash->Add(BytesOf(edgel.position_px.data(), 2));
  for (const CurveFragment& fragment : curves.fragments) {
    const size_t size = fragment.edgel_ids.size();
    hash->Add(BytesOf(&size, 1));
    hash->Add(BytesOf(fragment.edgel_ids.data(), size));
  }
}

}  // namespace

std::string CurvesKey(const std::vector<View>& views, const std::vector<ImageCurves>& curves) {
  ContentHash hash;
  for (const View& view : views) AddView(view, &hash);
  for (const ImageCurves& of_view : curves) AddCurves(of_view, &hash);
  return hash.Hex();
}

void RemoveUnusableEdgels(const std::vector<bool>& usable, ImageCurves* curves) {
  std::vector<CurveFragment> fragments;
  for (const CurveFragment& fragment : curves->fragments) {
    for (CurveFragment& run : UsableRuns(fragment, usable)) fragments.push_back(std::move(run));
  }
  curves->fragments = std::move(fragments);
  std::erase_if(curves->link_graph,
                [&](const EdgelLink& link) { return !usable[link.a] || !usable[link.b]; });
}

EdgeMapsResult ExtractEdgeMaps(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                               const RunContext& context) {
  edges.Check();
  Extractor extractor(input, edges);
  EdgeMapsResult result;
  result.edge_maps.resize(input.views.size());
  ParallelFor(context, "edges", input.views.size(),
              [&](size_t v) { result.edge_maps[v] = extractor.EdgesOf(static_cast<ViewId>(v)); });
  int64_t num_edgels = 0;
  for (const EdgeMap& map : result.edge_maps) num_edgels += static_cast<int64_t>(map.edgels.size());
  const auto num_images = static_cast<int64_t>(input.views.size());
  result.summary.stage = "edges";
  result.summary.in = {{"images", num_images}};
  result.summary.kept = {{"images", num_images}, {"edgels", num_edgels}};
  result.cache = extractor.EdgesUse();
  return result;
}

CurvesResult ExtractCurves(const ExtractionInput& input, const EdgeDetectionOptions& edges,
                           const LinkingOptions& linking, const RunContext& context) {
  edges.Check();
  linking.Check();
  Extractor extractor(input, edges);
  CurvesResult result;
  result.curves.resize(input.views.size());
  std::vector<ViewCounts> counts(input.views.size());
  ParallelFor(context, "image curves", input.views.size(), [&](size_t v) {
    ImageCurves& curves = result.curves[v];
    curves = extractor.FragmentsOf(static_cast<ViewId>(v), linking);
    ViewCounts& of_view = counts[v];
    of_view = CountLinked(curves);
    RemoveUnusableEdgels(ApplyLens(input.views[v].lens.get(), &curves.edge_map), &curves);
    of_view.in_fragments = CountEdgelsInFragments(curves);
    of_view.outside_lens =
        of_view.edgels - of_view.not_linked - of_view.not_grouped - of_view.in_fragments;
    of_view.fragments = static_cast<int64_t>(curves.fragments.size());
  });
  result.summary = Summarize(counts);
  result.cache = extractor.FragmentsUse();
  return result;
}

}  // namespace limn
