// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/writable_folder.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "limn/files/call_error.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr int kFolderFlags = O_PATH | O_DIRECTORY | O_CLOEXEC;

std::string Join(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

std::vector<std::string> PartsOf(const OutputPath& folder) {
  std::vector<std::string> parts;
  for (const fs::path& part : folder.below()) {
    if (part == ".." || part.is_absolute()) {
      throw IoError(folder.string(), "cannot write: this leads out of the output folder");
    }
    if (!part.empty() && part != ".") parts.push_back(part.string());
  }
  return parts;
}

[[noreturn]] void RefuseFile(const std::string& path) {
  throw IoError(path, "is not a folder: choose another --output_path");
}

// The name in the folder could not be opened, for the reason errno.
[[noreturn]] void RefuseWay(const WritableFolder& folder, const std::string& name, int reason) {
  const std::string path = Join(folder.path(), name);
  const auto status = folder.StatusOf(name);
  if (status && status->kind == FileKind::kLink) RefuseLink(path);
  if (status && status->kind != FileKind::kFolder) RefuseFile(path);
  throw IoError(path, std::string("cannot be opened: ") + std::strerror(reason));
}

// Those of the user may be links. Not open if it is missing.
FileDescriptor OpenNamed(const fs::path& named) {
  FileDescriptor folder(open(named.c_str(), kFolderFlags));
  if (folder.IsOpen() || errno == ENOENT) return folder;
  if (errno == ENOTDIR) RefuseFile(named.string());
  throw IoError(named.string(), std::string("cannot be opened: ") + std::strerror(errno));
}

// The nearest above that is there. Throws IoError if it is no folder.
fs::path NearestNamed(const fs::path& named) {
  std::error_code ignored;
  fs::path folder = fs::absolute(named, ignored);
  while (!fs::exists(fs::symlink_status(folder, ignored)) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  if (!fs::is_directory(folder, ignored)) RefuseFile(folder.string());
  return folder;
}

void MakeNamed(const fs::path& named) {
  std::error_code error;
  fs::create_directories(named, error);
  if (error) throw IoError(named.string(), "cannot create the folder: " + error.message());
}

void CheckNoLinksIn(const WritableFolder& folder) {
  for (const std::string& name : folder.Names()) {
    const auto status = folder.StatusOf(name);
    const bool is_link = status && status->kind == FileKind::kLink;
    if (is_link && !name.ends_with(kTemporarySuffix)) RefuseLink(Join(folder.path(), name));
    if (!status || status->kind != FileKind::kFolder) continue;
    if (const auto inner = folder.Enter(name)) CheckNoLinksIn(*inner);
  }
}

}  // namespace

void RefuseLink(const std::string& link) {
  std::error_code ignored;
  throw IoError(link, "is a link to " + fs::read_symlink(link, ignored).string() +
                          ", and nothing is written through links in an output folder: remove it, "
                          "or choose another --output_path");
}

WritableFolder WritableFolder::Descend(const OutputPath& folder,
                                       std::vector<std::string>* missing) {
  std::vector<std::string> parts = PartsOf(folder);
  WritableFolder at(OpenNamed(folder.named()), folder.named().string());
  size_t i = 0;
  for (; at.descriptor_.IsOpen() && i < parts.size(); ++i) {
    FileDescriptor next(openat(at.descriptor(), parts[i].c_str(), kFolderFlags | O_NOFOLLOW));
    if (!next.IsOpen() && errno == ENOENT) break;
    if (!next.IsOpen()) RefuseWay(at, parts[i], errno);
    at = WritableFolder(std::move(next), Join(at.path_, parts[i]));
  }
  missing->assign(parts.begin() + static_cast<std::ptrdiff_t>(i), parts.end());
  return at;
}

WritableFolder WritableFolder::Make(const OutputPath& folder) {
  // One for each part that is missing, and more: another process may remove a folder between the
  // attempt to make it and the look at it.
  const size_t max_attempts = 100 + PartsOf(folder).size();
  for (size_t attempt = 0; attempt < max_attempts; ++attempt) {
    std::vector<std::string> missing;
    WritableFolder at = Descend(folder, &missing);
    if (!at.descriptor_.IsOpen()) {
      MakeNamed(folder.named());
    } else if (missing.empty()) {
      return at;
    } else if (mkdirat(at.descriptor(), missing.front().c_str(), 0777) != 0 && errno != EEXIST &&
               errno != ENOENT) {
      throw IoError(Join(at.path_, missing.front()),
                    std::string("cannot create the folder: ") + std::strerror(errno));
    }
  }
  throw IoError(folder.string(), "cannot create the folder: it is removed again and again");
}

std::optional<WritableFolder> WritableFolder::Find(const OutputPath& folder) {
  std::vector<std::string> missing;
  WritableFolder at = Descend(folder, &missing);
  if (!at.descriptor_.IsOpen() || !missing.empty()) return std::nullopt;
  return at;
}

WritableFolder WritableFolder::Nearest(const OutputPath& folder) {
  std::vector<std::string> missing;
  WritableFolder at = Descend(folder, &missing);
  if (at.descriptor_.IsOpen()) return at;
  const fs::path named = NearestNamed(folder.named());
  return {OpenNamed(named), named.string()};
}

std::optional<FileStatus> WritableFolder::StatusOf(const std::string& name) const {
  return StatusInFolder(descriptor(), name);
}

std::vector<std::string> WritableFolder::Names() const {
  FileDescriptor readable(openat(descriptor(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!readable.IsOpen()) return {};
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(fdopendir(readable.number()), &closedir);
  if (!entries) return {};
  readable.Release();
  std::vector<std::string> names;
  while (const dirent* entry = readdir(entries.get())) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  return names;
}

std::optional<WritableFolder> WritableFolder::Enter(const std::string& name) const {
  FileDescriptor inner(openat(descriptor(), name.c_str(), kFolderFlags | O_NOFOLLOW));
  if (!inner.IsOpen()) return std::nullopt;
  return WritableFolder(std::move(inner), Join(path_, name));
}

std::error_code WritableFolder::WhyNoFile() const {
  return ErrorOf(faccessat(descriptor(), ".", W_OK | X_OK, 0));
}

std::error_code WritableFolder::Remove(const std::string& name) const {
  return ErrorOf(unlinkat(descriptor(), name.c_str(), 0));
}

std::error_code WritableFolder::RemoveEmptyFolder(const std::string& name) const {
  return ErrorOf(unlinkat(descriptor(), name.c_str(), AT_REMOVEDIR));
}

std::error_code WritableFolder::RemoveAll(const std::string& name) const {
  const auto inner = Enter(name);
  if (!inner) return Remove(name);
  for (const std::string& below : inner->Names()) inner->RemoveAll(below);
  return RemoveEmptyFolder(name);
}

void CheckHoldsNoLinks(const OutputPath& folder) {
  if (const auto found = WritableFolder::Find(folder)) CheckNoLinksIn(*found);
}

void RemoveFile(const OutputPath& path) {
  const auto folder = WritableFolder::Find(path.Folder());
  const std::error_code error = folder ? folder->Remove(path.Name()) : std::error_code();
  if (!error || error == std::errc::no_such_file_or_directory) return;
  throw IoError(path.string(), "cannot be removed: " + error.message());
}

}  // namespace limn
