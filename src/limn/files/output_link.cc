// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/output_link.h"

#include <cerrno>
#include <cstring>
#include <string>

#include <unistd.h>

#include "limn/files/writable_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

bool SaysNoLinks(int reason) {
  return reason == EPERM || reason == EOPNOTSUPP || reason == ENOSYS || reason == EINVAL;
}

// The path itself, which may be a link, in a folder without links.
fs::path PlaceOf(const fs::path& path) {
  const fs::path whole = fs::absolute(path).lexically_normal();
  const fs::path plain = whole.has_filename() ? whole : whole.parent_path();
  return fs::canonical(plain.parent_path()) / plain.filename();
}

}  // namespace

bool MakeLink(const fs::path& target, const OutputPath& link) {
  const WritableFolder folder = WritableFolder::Make(link.Folder());
  const auto there = folder.StatusOf(link.Name());
  if (there && there->kind == FileKind::kFolder) {
    throw IoError(link.string(), "is a folder, not the link that is to be made: remove it");
  }
  folder.Remove(link.Name());
  const fs::path text = PlaceOf(target).lexically_relative(fs::canonical(folder.path()));
  if (symlinkat(text.c_str(), folder.descriptor(), link.Name().c_str()) == 0) return true;
  const int reason = errno;
  if (SaysNoLinks(reason)) return false;
  throw IoError(link.string(), std::string("cannot be made: ") + std::strerror(reason));
}

}  // namespace limn
