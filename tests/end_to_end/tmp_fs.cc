// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/tmp_fs.h"

#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

namespace limn::testing {

TmpFs::TmpFs(std::filesystem::path folder, size_t bytes) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
  is_mounted_ = Run("mount -t tmpfs -o size=" + std::to_string(bytes) + " tmpfs ");
}

TmpFs::~TmpFs() {
  if (is_mounted_) Run("umount ");
}

void TmpFs::Resize(size_t bytes) const {
  EXPECT_TRUE(Run("mount -o remount,size=" + std::to_string(bytes) + " "));
}

bool TmpFs::Run(const std::string& command) const {
  return std::system((command + "'" + folder_.string() + "' 2> /dev/null").c_str()) == 0;
}

}  // namespace limn::testing
