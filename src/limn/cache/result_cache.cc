// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/result_cache.h"

#include <filesystem>
#include <utility>

namespace limn {
namespace {

constexpr const char* kFolders[kNumCachedKinds] = {"edges", "fragments", "sketch", "drawing",
                                                   "scene"};
constexpr const char* kWhats[kNumCachedKinds] = {"edge maps", "image curves", "sketches",
                                                 "drawings", "drawings"};
constexpr const char* kItems[kNumCachedKinds] = {"images", "images", "views", "tiles", "scenes"};

// Which is first must not depend on the threads.
void KeepFirst(const std::string& text, std::string* first) {
  if (first->empty() || text < *first) *first = text;
}

CacheUse NothingYet(CachedKind kind) {
  CacheUse use;
  use.what = kWhats[static_cast<int>(kind)];
  use.items = kItems[static_cast<int>(kind)];
  return use;
}

}  // namespace

ResultCache::ResultCache(OutputPath dir) : dir_(std::move(dir)) {
  for (int kind = 0; kind < kNumCachedKinds; ++kind) {
    use_[kind] = NothingYet(static_cast<CachedKind>(kind));
  }
}

OutputPath ResultCache::PathOf(CachedKind kind, const std::string& name) const {
  const char* folder = kFolders[static_cast<int>(kind)];
  return dir_ / folder / (name + ".bin");
}

bool ResultCache::Exists(const std::string& path) const {
  std::error_code ignored;
  return IsOn() && std::filesystem::exists(path, ignored);
}

void ResultCache::Expect(CachedKind kind, size_t total) {
  const std::lock_guard lock(mutex_);
  const int round = UseOf(kind).round + 1;
  UseOf(kind) = NothingYet(kind);
  UseOf(kind).round = round;
  UseOf(kind).total = static_cast<int64_t>(total);
}

void ResultCache::CountRead(CachedKind kind, bool is_good) {
  const std::lock_guard lock(mutex_);
  ++(is_good ? UseOf(kind).reused : UseOf(kind).outdated);
}

void ResultCache::CountDamaged(CachedKind kind, const std::string& damage) {
  const std::lock_guard lock(mutex_);
  ++UseOf(kind).damaged;
  KeepFirst(damage, &UseOf(kind).damage);
}

void ResultCache::Store(CachedKind kind, const std::string& name,
                        const std::function<void(const OutputPath&)>& write) {
  if (!IsOn()) return;
  try {
    write(PathOf(kind, name));
    const std::lock_guard lock(mutex_);
    ++UseOf(kind).stored;
  } catch (const IoError& error) {
    const std::lock_guard lock(mutex_);
    ++UseOf(kind).not_stored;
    KeepFirst(error.what(), &UseOf(kind).write_error);
  }
}

CacheUse ResultCache::Use(CachedKind kind) const {
  const std::lock_guard lock(mutex_);
  return use_[static_cast<int>(kind)];
}

}  // namespace limn
