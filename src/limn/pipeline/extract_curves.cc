#include "limn/pipeline/extract_curves.h"

#include <atomic>
#include <filesystem>
#include <optional>
#include <utility>

#include "limn/pipeline/content_hash.h"
#include "limn/pipeline/pipeline_options.h"
#include "limn/pipeline/stage_files.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// Where the results of earlier runs are, and whether they can be used.
class Cache {
 public:
  Cache(const std::string& dir, const char* kind) : dir_(dir), kind_(kind) {}

  bool enabled() const { return !dir_.empty(); }

  std::string PathOf(const View& view) const {
    return (std::filesystem::path(dir_) / kind_ / (view.name + "." + kind_)).string();
  }

  // What `read(path, key)` gives; nothing if the file is missing, of another key, or damaged.
  template <typename Read>
  auto Find(const View& view, const std::string& key, Read&& read)
      -> decltype(read(std::string(), key)) {
    if (!enabled()) return std::nullopt;
    const std::string path = PathOf(view);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return std::nullopt;
    try {
      auto found = read(path, key);
      ++(found ? reused_ : outdated_);
      return found;
    } catch (const IoError&) {
      // A damaged cache costs time, never the run; the notice of outdated files covers it.
      ++outdated_;
      return std::nullopt;
    }
  }

  CacheUse Use() const { return {reused_, outdated_}; }

 private:
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

  EdgeMap EdgesOf(ViewId id) { return EdgesOf(id, EdgeKey(id)); }

  LinkingResult FragmentsOf(ViewId id, const LinkingOptions& linking) {
    const View& view = input_.views[id];
    const std::string edge_key = EdgeKey(id);
    const std::string key = edge_key + OptionsAsText(linking);
    if (auto found = fragments_.Find(view, key, ReadFragmentsFile)) return std::move(*found);
    LinkingResult linked = LinkEdgels(EdgesOf(id, edge_key), linking);
    if (fragments_.enabled()) WriteFragmentsFile(fragments_.PathOf(view), key, linked);
    return linked;
  }

  CacheUse EdgesUse() const { return edges_.Use(); }
  CacheUse FragmentsUse() const { return fragments_.Use(); }

 private:
  std::string EdgeKey(ViewId id) const { return input_.images.identity(id) + "\n" + edge_key_; }

  EdgeMap EdgesOf(ViewId id, const std::string& key) {
    const View& view = input_.views[id];
    if (auto found = edges_.Find(view, key, ReadEdgeMapFile)) return std::move(*found);
    EdgeMap map = DetectEdges(input_.images.read(id), edge_options_);
    if (edges_.enabled()) WriteEdgeMapFile(edges_.PathOf(view), key, map);
    return map;
  }

  const ExtractionInput& input_;
  const EdgeDetectionOptions& edge_options_;
  std::string edge_key_;
  Cache edges_{input_.cache_dir, "edges"};
  Cache fragments_{input_.cache_dir, "fragments"};
};

struct ViewCounts {
  LinkingStats linking;
  int64_t outside_lens = 0;         // of the edgels in fragments
  int64_t edgels_in_fragments = 0;  // after the lens
  int64_t fragments = 0;
};

int64_t CountEdgelsInFragments(const ImageCurves& curves) {
  int64_t count = 0;
  for (const CurveFragment& fragment : curves.fragments) {
    count += static_cast<int64_t>(fragment.edgel_ids.size());
  }
  return count;
}

StageSummary Summarize(const std::vector<ViewCounts>& views) {
  ViewCounts sum;
  for (const ViewCounts& view : views) {
    sum.linking.edgels += view.linking.edgels;
    sum.linking.edgels_unlinked += view.linking.edgels_unlinked;
    sum.linking.edgels_in_short_chains += view.linking.edgels_in_short_chains;
    sum.outside_lens += view.outside_lens;
    sum.edgels_in_fragments += view.edgels_in_fragments;
    sum.fragments += view.fragments;
  }
  StageSummary summary;
  summary.stage = "image curves";
  summary.in = {{"images", static_cast<int64_t>(views.size())}, {"edgels", sum.linking.edgels}};
  summary.kept = {{"edgels", sum.edgels_in_fragments}, {"fragments", sum.fragments}};
  summary.dropped = {{"edgels: unlinked", sum.linking.edgels_unlinked},
                     {"edgels: fragment too short", sum.linking.edgels_in_short_chains},
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
    LinkingResult linked = extractor.FragmentsOf(static_cast<ViewId>(v), linking);
    ImageCurves& curves = result.curves[v];
    curves = std::move(linked.curves);
    RemoveUnusableEdgels(ApplyLens(input.views[v].lens.get(), &curves.edge_map), &curves);
    counts[v].linking = linked.stats;
    counts[v].edgels_in_fragments = CountEdgelsInFragments(curves);
    counts[v].outside_lens = linked.stats.edgels_in_fragments - counts[v].edgels_in_fragments;
    counts[v].fragments = static_cast<int64_t>(curves.fragments.size());
  });
  result.summary = Summarize(counts);
  result.cache = extractor.FragmentsUse();
  return result;
}

}  // namespace limn
