#include "limn/pipeline/stage_files.h"

#include <algorithm>
#include <filesystem>
#include <type_traits>

#include <zlib.h>

#include "limn/io/atomic_file.h"
#include "limn/io/whole_file.h"
#include "limn/pipeline/stage_bytes.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

// A file is magic, version, key, CRC-32 of the content, content. Raise the version whenever a
// content, or what an algorithm makes of the same options, changes.
constexpr uint32_t kVersion = 1;
constexpr char kEdgeMapMagic[] = "LIMNedge";
constexpr char kFragmentsMagic[] = "LIMNfrag";
constexpr char kSketchMagic[] = "LIMNskch";
constexpr size_t kMagicSize = 8;

uint32_t Checksum(std::string_view bytes) {
  uLong crc = crc32(0, nullptr, 0);
  while (!bytes.empty()) {
    const auto chunk = static_cast<uInt>(std::min<size_t>(bytes.size(), 1u << 30));
    crc = crc32(crc, reinterpret_cast<const Bytef*>(bytes.data()), chunk);
    bytes.remove_prefix(chunk);
  }
  return static_cast<uint32_t>(crc);
}

void WriteStageFile(const std::string& path, const char* magic, const std::string& key,
                    const std::string& content) {
  ByteSink head;
  head.Put(kVersion);
  head.PutText(key);
  head.Put(Checksum(content));
  WriteFileAtomically(path, std::string(magic, kMagicSize) + head.bytes() + content);
}

enum class HeadMatch { kSame, kOtherVersion, kOtherKey };

// Reads up to the content and checks it; the source is then at the first byte of the content.
HeadMatch ReadHead(const char* magic, const std::string& key, ByteSource* source) {
  for (size_t i = 0; i < kMagicSize; ++i) {
    if (source->Get<char>() != magic[i]) source->Fail(std::string("not a file of kind ") + magic);
  }
  if (source->Get<uint32_t>() != kVersion) return HeadMatch::kOtherVersion;
  const bool same_key = source->GetText() == key;
  const auto checksum = source->Get<uint32_t>();
  if (Checksum(source->Rest()) != checksum) source->Fail("the checksum does not match");
  return same_key ? HeadMatch::kSame : HeadMatch::kOtherKey;
}

void PutEdgeMap(const EdgeMap& map, ByteSink* sink) {
  sink->Put(map.width);
  sink->Put(map.height);
  sink->Put(map.gradient_noise);
  sink->Put(map.num_outside_lens);
  sink->Put(static_cast<uint64_t>(map.edgels.size()));
  for (const Edgel& edgel : map.edgels) {
    sink->Put(edgel.position_px.x());
    sink->Put(edgel.position_px.y());
    sink->Put(edgel.tangent_rad);
    sink->Put(edgel.strength);
    sink->Put(edgel.position_sigma_px);
  }
}

EdgeMap GetEdgeMap(ByteSource* source) {
  constexpr size_t kEdgelSize = 3 * sizeof(double) + 2 * sizeof(float);
  EdgeMap map;
  map.width = source->Get<int>();
  map.height = source->Get<int>();
  map.gradient_noise = source->Get<double>();
  map.num_outside_lens = source->Get<int>();
  map.edgels.resize(source->TakeCount(kEdgelSize));
  for (Edgel& edgel : map.edgels) {
    edgel.position_px.x() = source->Get<double>();
    edgel.position_px.y() = source->Get<double>();
    edgel.tangent_rad = source->Get<double>();
    edgel.strength = source->Get<float>();
    edgel.position_sigma_px = source->Get<float>();
    edgel.stored_px = edgel.position_px.cast<float>();
  }
  return map;
}

// The counts in the order of the struct.
template <typename Stats, typename Visit>
void VisitStats(Stats& stats, Visit&& visit) {
  for (auto* count :
       {&stats.edgels, &stats.edgels_in_fragments, &stats.edgels_unlinked,
        &stats.edgels_in_short_chains, &stats.curvelets, &stats.graph_links, &stats.bridged_gaps,
        &stats.corner_breaks, &stats.junction_breaks, &stats.short_chains, &stats.fragments}) {
    visit(*count);
  }
  visit(stats.fragments_length_px);
}

void PutPoints(const std::vector<Eigen::Vector3d>& points, ByteSink* sink) {
  const double* first = points.empty() ? nullptr : points.front().data();
  sink->PutArray(std::span<const double>(first, 3 * points.size()));
}

std::vector<Eigen::Vector3d> GetPoints(ByteSource* source) {
  const std::vector<double> numbers = source->GetArray<double>();
  if (numbers.size() % 3 != 0) source->Fail("coordinates do not come in threes");
  std::vector<Eigen::Vector3d> points(numbers.size() / 3);
  for (size_t i = 0; i < points.size(); ++i) {
    points[i] = Eigen::Vector3d(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
  }
  return points;
}

void PutCurve(const Curve3D& curve, ByteSink* sink) {
  PutPoints(curve.points_in_world, sink);
  PutPoints(curve.tangents_in_world, sink);
  sink->PutArray(std::span<const double>(curve.depth_sigma));
  sink->PutArray(std::span<const uint8_t>(curve.certain));
  sink->Put(curve.anchor.view);
  sink->Put(curve.anchor.fragment);
  sink->Put(curve.anchor.begin);
  sink->PutArray(std::span<const uint32_t>(curve.support.offsets));
  sink->PutArray(std::span<const EdgelRef>(curve.support.edgels));
  sink->Put(static_cast<uint8_t>(curve.closed));
}

bool IsConsistent(const Curve3D& curve) {
  const size_t size = curve.size();
  const auto& offsets = curve.support.offsets;
  return curve.tangents_in_world.size() == size && curve.depth_sigma.size() == size &&
         curve.certain.size() == size && offsets.size() == size + 1 && offsets.front() == 0 &&
         offsets.back() == curve.support.edgels.size() &&
         std::is_sorted(offsets.begin(), offsets.end());
}

Curve3D GetCurve(ByteSource* source) {
  Curve3D curve;
  curve.points_in_world = GetPoints(source);
  curve.tangents_in_world = GetPoints(source);
  curve.depth_sigma = source->GetArray<double>();
  curve.certain = source->GetArray<uint8_t>();
  curve.anchor.view = source->Get<ViewId>();
  curve.anchor.fragment = source->Get<int>();
  curve.anchor.begin = source->Get<int>();
  curve.support.offsets = source->GetArray<uint32_t>();
  curve.support.edgels = source->GetArray<EdgelRef>();
  curve.closed = source->Get<uint8_t>() != 0;
  if (!IsConsistent(curve)) source->Fail("the lists of a curve differ in length");
  return curve;
}

// The bytes of a cache file if it exists.
std::optional<std::string> ReadIfPresent(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  return ReadWholeFile(path);
}

}  // namespace

void WriteEdgeMapFile(const std::string& path, const std::string& key, const EdgeMap& edge_map) {
  ByteSink sink;
  PutEdgeMap(edge_map, &sink);
  WriteStageFile(path, kEdgeMapMagic, key, sink.bytes());
}

std::optional<EdgeMap> ReadEdgeMapFile(const std::string& path, const std::string& key) {
  const std::optional<std::string> bytes = ReadIfPresent(path);
  if (!bytes) return std::nullopt;
  ByteSource source(path, *bytes);
  if (ReadHead(kEdgeMapMagic, key, &source) != HeadMatch::kSame) return std::nullopt;
  EdgeMap map = GetEdgeMap(&source);
  source.ExpectEnd();
  return map;
}

void WriteFragmentsFile(const std::string& path, const std::string& key,
                        const LinkingResult& linked) {
  ByteSink sink;
  PutEdgeMap(linked.curves.edge_map, &sink);
  sink.Put(static_cast<uint64_t>(linked.curves.fragments.size()));
  for (const CurveFragment& fragment : linked.curves.fragments) {
    sink.PutArray(std::span<const EdgelId>(fragment.edgel_ids));
    sink.Put(static_cast<uint8_t>(fragment.closed));
  }
  sink.PutArray(std::span<const EdgelLink>(linked.curves.link_graph));
  VisitStats(linked.stats, [&](const auto& count) { sink.Put(count); });
  WriteStageFile(path, kFragmentsMagic, key, sink.bytes());
}

std::optional<LinkingResult> ReadFragmentsFile(const std::string& path, const std::string& key) {
  const std::optional<std::string> bytes = ReadIfPresent(path);
  if (!bytes) return std::nullopt;
  ByteSource source(path, *bytes);
  if (ReadHead(kFragmentsMagic, key, &source) != HeadMatch::kSame) return std::nullopt;
  LinkingResult linked;
  linked.curves.edge_map = GetEdgeMap(&source);
  linked.curves.fragments.resize(source.TakeCount(sizeof(uint64_t) + 1));
  for (CurveFragment& fragment : linked.curves.fragments) {
    fragment.edgel_ids = source.GetArray<EdgelId>();
    fragment.closed = source.Get<uint8_t>() != 0;
  }
  linked.curves.link_graph = source.GetArray<EdgelLink>();
  VisitStats(linked.stats,
             [&](auto& count) { count = source.Get<std::remove_reference_t<decltype(count)>>(); });
  source.ExpectEnd();
  return linked;
}

void WriteSketchFile(const std::string& path, const std::string& key, const StoredSketch& stored) {
  ByteSink sink;
  sink.PutText(stored.options_json);
  sink.Put(static_cast<uint64_t>(stored.sketch.curves.size()));
  for (const Curve3D& curve : stored.sketch.curves) PutCurve(curve, &sink);
  WriteStageFile(path, kSketchMagic, key, sink.bytes());
}

StoredSketch ReadSketchFile(const std::string& path, const std::string& key) {
  const std::string bytes = ReadWholeFile(path);
  ByteSource source(path, bytes);
  switch (ReadHead(kSketchMagic, key, &source)) {
    case HeadMatch::kSame:
      break;
    case HeadMatch::kOtherVersion:
      throw IoError(path, "was written by another version of limn: run curve_sketcher again");
    case HeadMatch::kOtherKey:
      throw IoError(path,
                    "was made from other images, cameras or edge and linking options: "
                    "run curve_sketcher again");
  }
  StoredSketch stored;
  stored.options_json = source.GetText();
  stored.sketch.curves.resize(source.TakeCount(sizeof(uint64_t)));
  for (Curve3D& curve : stored.sketch.curves) curve = GetCurve(&source);
  source.ExpectEnd();
  return stored;
}

}  // namespace limn
