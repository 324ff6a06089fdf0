// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace limn::colmap_ext {

// The image that each thread has decoded last, for images that are read in several parts: a loop
// over the views gives most parts of an image to one thread, one after the other. Thread-safe.
template <typename Pixels>
class LastDecoded {
 public:
  // What `decode` returns for this path. `is_last_use`: this thread does not keep it any longer.
  std::shared_ptr<const Pixels> Get(const std::string& path, bool is_last_use,
                                    const std::function<Pixels()>& decode) {
    std::shared_ptr<const Pixels> pixels = Take(path);
    if (!pixels) pixels = std::make_shared<const Pixels>(decode());
    if (!is_last_use) Keep({path, pixels});
    return pixels;
  }

  // Threads outlive a loop: call this at its end, or every thread keeps its image.
  void Clear() {
    const std::lock_guard lock(mutex_);
    entries_.clear();
  }

 private:
  struct Entry {
    std::string path;
    std::shared_ptr<const Pixels> pixels;
  };

  // Null if this thread has another one, which is dropped before the next is decoded.
  std::shared_ptr<const Pixels> Take(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const auto taken = entries_.extract(std::this_thread::get_id());
    return taken && taken.mapped().path == path ? taken.mapped().pixels : nullptr;
  }

  void Keep(Entry entry) {
    const std::lock_guard lock(mutex_);
    entries_[std::this_thread::get_id()] = std::move(entry);
  }

  std::mutex mutex_;
  std::map<std::thread::id, Entry> entries_;
};

}  // namespace limn::colmap_ext
