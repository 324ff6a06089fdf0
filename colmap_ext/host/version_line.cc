#include "colmap_ext/host/version_line.h"

#include "limn/commit.h"
#include "limn/version.h"

namespace limn::colmap_ext {

std::string VersionLine() {
  const std::string commit = LIMN_COMMIT;
  const std::string version = "limn " LIMN_VERSION;
  return commit.empty() ? version : version + " (commit " + commit + ")";
}

}  // namespace limn::colmap_ext
