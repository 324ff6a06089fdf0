// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/tiff_directory.h"

#include <algorithm>
#include <set>
#include <vector>

namespace limn::colmap_ext {
namespace {

constexpr size_t kMaxDirectories = 64;
constexpr uint64_t kMaxEntries = UINT16_MAX;

// Numbers of a TIFF file in its order of bytes; zero behind the end.
class TiffStream {
 public:
  explicit TiffStream(std::istream& in) : in_(in) {
    Seek(0);
    const uint64_t order = Read(2);
    is_little_ = order == 0x4949;
    const uint64_t version = Read(2);
    is_tiff_ = (is_little_ || order == 0x4D4D) && (version == 42 || version == 43);
    is_big_ = version == 43;
  }

  bool IsTiff() const { return is_tiff_; }
  bool IsBig() const { return is_big_; }
  bool IsLittle() const { return is_little_; }
  int OffsetBytes() const { return is_big_ ? 8 : 4; }
  uint64_t FirstOffsetAt() const { return is_big_ ? 8 : 4; }

  void Seek(uint64_t offset) {
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(std::min<uint64_t>(offset, INT64_MAX)));
  }
  bool IsGood() const { return in_.good(); }
  uint64_t Tell() { return static_cast<uint64_t>(std::max<std::streamoff>(in_.tellg(), 0)); }

  uint64_t Read(int num_bytes) {
    unsigned char bytes[8] = {};
    in_.read(reinterpret_cast<char*>(bytes), num_bytes);
    if (!in_) return 0;
    uint64_t value = 0;
    for (int i = 0; i < num_bytes; ++i) {
      value = value << 8 | bytes[is_little_ ? num_bytes - 1 - i : i];
    }
    return value;
  }

 private:
  std::istream& in_;
  bool is_little_ = false;
  bool is_big_ = false;
  bool is_tiff_ = false;
};

int BytesOfType(uint64_t type) {
  constexpr int kBytes[] = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
  return type < std::size(kBytes) ? kBytes[type] : 0;
}

struct Entry {
  uint64_t tag = 0, type = 0, count = 0;
  uint64_t values_at = 0;
};

Entry ReadEntry(TiffStream* in) {
  Entry entry;
  entry.tag = in->Read(2);
  entry.type = in->Read(2);
  entry.count = in->Read(in->OffsetBytes());
  entry.values_at = in->Tell();
  const int bytes = BytesOfType(entry.type);
  const uint64_t inlined = static_cast<uint64_t>(in->OffsetBytes());
  if (bytes > 0 && entry.count > inlined / bytes) entry.values_at = in->Read(in->OffsetBytes());
  return entry;
}

// At most `max_count` of the whole numbers of an entry.
std::vector<uint64_t> ValuesOf(const Entry& entry, size_t max_count, TiffStream* in) {
  std::vector<uint64_t> values;
  const int bytes = BytesOfType(entry.type);
  if (bytes == 0) return values;
  in->Seek(entry.values_at);
  while (values.size() < std::min<uint64_t>(entry.count, max_count)) {
    values.push_back(in->Read(bytes));
    if (!in->IsGood()) return {};
  }
  return values;
}

enum Tag : uint64_t {
  kSubfileType = 254,
  kWidth = 256,
  kHeight = 257,
  kBits = 258,
  kPhotometric = 262,
  kOrientation = 274,
  kSubDirectories = 330,
  kExtraSamples = 338
};

struct Directory {
  TiffDirectory picture;
  bool is_picture = true;
  std::vector<uint64_t> next;  // directories that it leads to
};

void TakeEntry(const Entry& entry, TiffStream* in, Directory* directory) {
  const auto first = [&]() -> uint64_t {
    const std::vector<uint64_t> values = ValuesOf(entry, 1, in);
    return values.empty() ? 0 : values[0];
  };
  const auto side = [&] { return static_cast<int>(std::min<uint64_t>(first(), INT32_MAX)); };
  TiffDirectory& picture = directory->picture;
  switch (entry.tag) {
    case kSubfileType: {
      constexpr uint64_t kTransparencyMask = 4;
      directory->is_picture = (first() & kTransparencyMask) == 0;
      break;
    }
    case kWidth:
      picture.size.width = side();
      break;
    case kHeight:
      picture.size.height = side();
      break;
    case kBits:
      picture.bits = side();
      break;
    case kPhotometric: {
      constexpr uint64_t kColorFilterArray = 32803, kLinearRaw = 34892;
      picture.is_raw = first() == kColorFilterArray || first() == kLinearRaw;
      break;
    }
    case kOrientation: {
      const uint64_t value = first();
      if (value < 1 || value > 8) break;
      picture.orientation = static_cast<int>(value);
      picture.orientation_offset = entry.values_at;
      break;
    }
    case kSubDirectories:
      directory->next = ValuesOf(entry, kMaxDirectories, in);
      break;
    case kExtraSamples: {
      constexpr uint64_t kUnspecified = 0;
      picture.has_alpha = entry.count > 0 && first() != kUnspecified;
      break;
    }
    default:
      break;
  }
}

Directory ReadDirectory(uint64_t offset, TiffStream* in) {
  Directory directory;
  directory.picture.offset = offset;
  in->Seek(offset);
  const uint64_t count = std::min(in->Read(in->IsBig() ? 8 : 2), kMaxEntries);
  const uint64_t begin = in->Tell();
  const auto entry_bytes = static_cast<uint64_t>(4 + 2 * in->OffsetBytes());
  for (uint64_t i = 0; i < count && in->IsGood(); ++i) {
    in->Seek(begin + i * entry_bytes);
    const Entry entry = ReadEntry(in);
    if (in->IsGood()) TakeEntry(entry, in, &directory);
  }
  in->Seek(begin + count * entry_bytes);
  directory.next.push_back(in->Read(in->OffsetBytes()));
  return directory;
}

bool IsLarger(const TiffDirectory& a, const TiffDirectory& b) {
  return a.size.NumPixels() > b.size.NumPixels();
}

}  // namespace

std::optional<TiffDirectory> LargestTiffDirectory(std::istream& in) {
  TiffStream stream(in);
  if (!stream.IsTiff()) return std::nullopt;
  stream.Seek(stream.FirstOffsetAt());
  std::vector<uint64_t> open = {stream.Read(stream.OffsetBytes())};
  std::set<uint64_t> seen;
  TiffDirectory picture, raw;
  while (!open.empty() && seen.size() < kMaxDirectories) {
    const uint64_t offset = open.front();
    open.erase(open.begin());
    if (offset == 0 || !seen.insert(offset).second) continue;
    Directory directory = ReadDirectory(offset, &stream);
    directory.picture.is_first = seen.size() == 1;
    open.insert(open.end(), directory.next.begin(), directory.next.end());
    if (!directory.is_picture) continue;
    TiffDirectory& largest = directory.picture.is_raw ? raw : picture;
    if (IsLarger(directory.picture, largest)) largest = directory.picture;
  }
  constexpr double kPreviewShare = .9;
  const bool is_raw = picture.size.width < kPreviewShare * raw.size.width;
  const TiffDirectory& chosen = is_raw ? raw : picture;
  if (chosen.size.width <= 0 || chosen.size.height <= 0) return std::nullopt;
  return chosen;
}

int TiffOrientation(std::istream& in) {
  TiffStream stream(in);
  if (!stream.IsTiff()) return 1;
  stream.Seek(stream.FirstOffsetAt());
  return ReadDirectory(stream.Read(stream.OffsetBytes()), &stream).picture.orientation;
}

std::string WithFirstDirectory(std::string bytes, const TiffDirectory& directory) {
  const bool is_little = bytes.starts_with('I');
  const bool is_big = bytes.size() > 3 && bytes[is_little ? 2 : 3] == 43;
  const auto put = [&](size_t at, uint64_t value, size_t num_bytes) {
    if (at + num_bytes > bytes.size()) return;
    for (size_t i = 0; i < num_bytes; ++i) {
      bytes[at + (is_little ? i : num_bytes - 1 - i)] = static_cast<char>(value >> (8 * i));
    }
  };
  put(is_big ? 8 : 4, directory.offset, is_big ? 8 : 4);
  if (directory.orientation_offset > 0) put(directory.orientation_offset, 1, 2);
  return bytes;
}

}  // namespace limn::colmap_ext
