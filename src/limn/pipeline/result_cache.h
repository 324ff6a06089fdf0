#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "limn/util/errors.h"

namespace limn {

// What is kept between runs: per view, and drawings per tile.
enum class CachedKind { kEdges, kFragments, kSketch, kDrawing };
constexpr int kNumCachedKinds = static_cast<int>(CachedKind::kDrawing) + 1;

// What became of the kept results of one kind in a stage.
struct CacheUse {
  const char* what = "";   // in words: "image curves"
  const char* items = "";  // what there is one of them for: "images"
  int round = 0;           // how many stages have needed some
  int64_t total = 0;       // how many the stage needs
  int64_t reused = 0;
  int64_t outdated = 0;  // made of something else, or by another version: made again
  int64_t damaged = 0;   // cannot be read: made again
  int64_t stored = 0;
  int64_t not_stored = 0;
  std::string damage;       // file and reason of the first that was damaged, by path
  std::string write_error;  // the same of the first that could not be written

  bool IsComplete() const { return NumKept() + not_stored >= total; }
  int64_t NumKept() const { return reused + stored; }
};

// Results of earlier runs, <dir>/<kind>/<name>.bin, found again by what they were made of. A
// damaged file and one that cannot be written cost time, never the run: they are counted. All
// functions may be called from several threads.
class ResultCache {
 public:
  // An empty folder name keeps nothing.
  explicit ResultCache(std::string dir);

  const std::string& dir() const { return dir_; }
  bool IsOn() const { return !dir_.empty(); }

  // A stage begins that needs so many results of this kind: they are counted from here on.
  void Expect(CachedKind kind, size_t total);

  // `read(path)` reads a file; it returns nothing if it was made of something else, and throws
  // IoError if it is damaged. Nothing if there is no good one.
  template <typename Result>
  std::optional<Result> Find(CachedKind kind, const std::string& name,
                             const std::function<std::optional<Result>(const std::string&)>& read) {
    const std::string path = PathOf(kind, name);
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

  // `write(path)` writes a file and throws IoError if it cannot.
  void Store(CachedKind kind, const std::string& name,
             const std::function<void(const std::string&)>& write);

  CacheUse Use(CachedKind kind) const;

 private:
  std::string PathOf(CachedKind kind, const std::string& name) const;
  bool Exists(const std::string& path) const;
  void CountRead(CachedKind kind, bool is_good);
  void CountDamaged(CachedKind kind, const std::string& damage);
  CacheUse& UseOf(CachedKind kind) { return use_[static_cast<int>(kind)]; }

  std::string dir_;
  mutable std::mutex mutex_;
  std::array<CacheUse, kNumCachedKinds> use_;
};

}  // namespace limn
