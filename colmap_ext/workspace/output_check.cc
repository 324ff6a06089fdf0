#include "colmap_ext/workspace/output_check.h"

#include <cerrno>
#include <cstring>
#include <system_error>

#include <unistd.h>

#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace fs = std::filesystem;

void CheckWritable(const fs::path& folder) {
  std::error_code error;
  fs::path existing = fs::absolute(folder);
  while (!fs::exists(fs::symlink_status(existing, error)) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  std::string reason;
  if (!fs::is_directory(existing, error)) {
    reason = existing.string() + " is no folder";
  } else if (access(existing.c_str(), W_OK | X_OK) != 0) {
    reason = existing.string() + ": " + std::strerror(errno);
  }
  if (reason.empty()) return;
  throw IoError(folder.string(),
                "results cannot be written here (" + reason + "): choose another --output_path");
}

}  // namespace limn::colmap_ext
