#include "colmap_ext/workspace/file_set.h"

#include <optional>

#include <sys/stat.h>

namespace limn::colmap_ext {
namespace {

std::optional<std::pair<unsigned long, unsigned long>> DeviceAndInode(const std::string& path) {
  struct stat status = {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return std::pair<unsigned long, unsigned long>(status.st_dev, status.st_ino);
}

}  // namespace

FileSet::FileSet(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (const auto file = DeviceAndInode(path)) files_.insert(*file);
  }
}

bool FileSet::Contains(const std::string& path) const {
  const auto file = DeviceAndInode(path);
  return file && files_.contains(*file);
}

}  // namespace limn::colmap_ext
