// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace limn::testing {

// A small file system in memory, mounted on a folder, which is made, during the lifetime of the
// object. Only root may mount.
class TmpFs {
 public:
  TmpFs(std::filesystem::path folder, size_t bytes);
  ~TmpFs();
  TmpFs(const TmpFs&) = delete;
  TmpFs& operator=(const TmpFs&) = delete;

  bool is_mounted() const { return is_mounted_; }
  void Resize(size_t bytes) const;

 private:
  bool Run(const std::string& command) const;

  std::filesystem::path folder_;
  bool is_mounted_ = false;
};

}  // namespace limn::testing
