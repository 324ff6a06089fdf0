// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "limn/files/output_path.h"
#include "limn/util/errors.h"

namespace limn {

// Results stored between runs: per view, drawings per tile, and that of the scene.
enum class CachedKind { kEdges, kFragments, kSketch, kDrawing, kScene };
constexpr int kNumCachedKinds = static_cast<int>(CachedKind::kScene) + 1;

// How a stage used the stored results of one kind.
struct CacheUse {
  const char* what = "";   // name for users: "image curves"
  const char* items = "";  // one result per: "images"
  int round = 0;           // number of stages that needed some
  int64_t total = 0;       // number that the stage needs
  int64_t reused = 0;
  int64_t outdated = 0;  // from other input or another version: made again
  int64_t damaged = 0;   // unreadable: made again
  int64_t stored = 0;
  int64_t not_stored = 0;
  std::string damage;       // file and reason of the first damaged one, by path
  std::string write_error;  // the same of the first that could not be written

  bool IsComplete() const { return NumKept() + not_stored >= total; }
  int64_t NumKept() const { return reused + stored; }
};

// Results of earlier runs in <dir>/<kind>/<name>.bin, valid if they were made from the same input.
// Files that are damaged or cannot be written cost time but never make the run fail; they are
// counted. Thread-safe.
class ResultCache {
 public:
  // An empty folder name stores nothing.
  explicit ResultCache(OutputPath dir);

  const std::string& dir() const { return dir_.string(); }
  bool IsOn() const { return !dir().empty(); }

  // Call it when a stage begins that needs `total` results of this kind; resets their counts.
  void Expect(CachedKind kind, size_t total);

  // `read(path)` reads a file; it returns nothing if the file was made from other input, and throws
  // IoError if it is damaged. Returns nothing if there is no valid file.
  template <typename Result>
  std::optional<Result> Find(CachedKind kind, const std::string& name,
                             const std::function<std::optional<Result>(const std::string&)>& read) {
    const std::string path = PathOf(kind, name).string();
    if (!Exists(path)) return std::nullopt;
    try {
      std::optional<Result> found = read(path);
      CountRead(kind, found.has_value());
      return found;
    } catch (const IoError& error) {
      CountDamaged(kind, error.what());
      return std::nullopt;
    }
  }

  // The same, not counted. Throws IoError if the file is damaged.
  template <typename Result>
  std::optional<Result> Read(
      CachedKind kind, const std::string& name,
      const std::function<std::optional<Result>(const std::string&)>& read) const {
    const std::string path = PathOf(kind, name).string();
    return Exists(path) ? read(path) : std::nullopt;
  }

  // `write(path)` writes a file and throws IoError if it cannot.
  void Store(CachedKind kind, const std::string& name,
             const std::function<void(const OutputPath&)>& write);

  CacheUse Use(CachedKind kind) const;

 private:
  OutputPath PathOf(CachedKind kind, const std::string& name) const;
  bool Exists(const std::string& path) const;
  void CountRead(CachedKind kind, bool is_good);
  void CountDamaged(CachedKind kind, const std::string& damage);
  CacheUse& UseOf(CachedKind kind) { return use_[static_cast<int>(kind)]; }

  OutputPath dir_;
  mutable std::mutex mutex_;
  std::array<CacheUse, kNumCachedKinds> use_;
};

}  // namespace limn
