// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/version_text.h"

#include "limn/commit.h"
#include "limn/libraries.h"
#include "limn/version.h"

namespace limn::colmap_ext {

std::string VersionText() {
  const std::string commit = LIMN_COMMIT;
  const std::string version =
      "limn " LIMN_VERSION + (commit.empty() ? std::string() : " (commit " + commit + ")");
  return version + "\nbuilt by " LIMN_COMPILER " with " LIMN_LIBRARIES;
}

std::string BuildId() { return LIMN_VERSION " " LIMN_COMMIT; }

}  // namespace limn::colmap_ext
