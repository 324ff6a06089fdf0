// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/latest_stage.h"

#include <mutex>

namespace limn {
namespace {

std::mutex latest_stage_mutex;
std::string latest_stage;

}  // namespace

std::string LatestStage() {
  const std::lock_guard lock(latest_stage_mutex);
  return latest_stage;
}

void SetLatestStage(const char* stage) {
  const std::lock_guard lock(latest_stage_mutex);
  latest_stage = stage;
}

std::string OutOfMemoryText(const std::string& before_options) {
  const std::string stage = LatestStage();
  if (stage.empty()) return "out of memory";
  return "out of memory in the stage \"" + stage + "\": lower " + before_options +
         "max_image_size, " + before_options + "num_threads or " + before_options +
         "Tiles.max_views";
}

}  // namespace limn
