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

}  // namespace limn
