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
  // What `decode` returns for this path. `is_last_use`: it is not kept any longer.
  std::shared_ptr<const Pixels> Get(const std::string& path, bool is_last_use,
                                    const std::function<Pixels()>& decode) {
    Entry& entry = OfThisThread();
    if (entry.path != path) {
      entry = {};
      entry = {path, std::make_shared<const Pixels>(decode())};
    }
    return is_last_use ? std::exchange(entry, {}).pixels : entry.pixels;
  }

 private:
  struct Entry {
    std::string path;
    std::shared_ptr<const Pixels> pixels;
  };

  // Only this thread uses it; it stays where it is.
  Entry& OfThisThread() {
    const std::lock_guard lock(mutex_);
    return entries_[std::this_thread::get_id()];
  }

  std::mutex mutex_;
  std::map<std::thread::id, Entry> entries_;
};

}  // namespace limn::colmap_ext
