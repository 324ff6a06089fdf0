#include "limn/files/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>

#include <sys/stat.h>
#include <unistd.h>

#include "limn/files/temporary_path.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxNameBytes = 255;

// Several processes may write the same file at the same time, on several hosts.
std::string RandomName() {
  thread_local std::random_device device;
  std::string name;
  for (int i = 0; i < 2; ++i) {
    for (unsigned rest = device(), k = 0; k < 8; ++k, rest >>= 4) {
      name += "0123456789abcdef"[rest & 15];
    }
  }
  return name;
}

// Beside `path`. Its name does not contain that of `path`, which may be as long as names can be.
fs::path TemporaryFor(const fs::path& path) {
  return path.parent_path() / (RandomName() + std::string(kTemporarySuffix));
}

// Owner and permissions of the file that will be replaced, if there is one.
void TakeModeOf(const std::string& path, const fs::path& temporary) {
  struct stat old;
  if (lstat(path.c_str(), &old) != 0 || !S_ISREG(old.st_mode)) return;
  // Only root may give files away.
  (void)!chown(temporary.c_str(), old.st_uid, old.st_gid);
  (void)!chmod(temporary.c_str(), old.st_mode & 0777);
}

void MakeParentFolder(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder.string(), "cannot create the folder: " + error.message());
}

// The first that is there, of the folder of a file and those above it.
fs::path NearestAbove(const fs::path& path) {
  std::error_code ignored;
  fs::path folder = fs::absolute(path).parent_path();
  while (folder.has_relative_path() && !fs::exists(fs::symlink_status(folder, ignored))) {
    folder = folder.parent_path();
  }
  return folder;
}

// /dev/stdout may lead to a regular file, but stands among devices.
bool IsAmongDevices(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(fs::absolute(path).parent_path(), ignored);
  return folder == "/dev" || folder.string().starts_with("/proc/");
}

}  // namespace

void CheckTakesFile(const std::string& path) {
  std::error_code ignored;
  if (fs::path(path).filename().string().size() > kMaxNameBytes) {
    throw IoError(path, "cannot write: the name of the file is longer than 255 bytes");
  }
  const fs::path folder = NearestAbove(path);
  if (!fs::is_directory(folder, ignored)) {
    throw IoError(path, "cannot write: " + folder.string() + " is not a folder");
  }
  const fs::file_status there = fs::status(path, ignored);
  if (fs::is_directory(there)) throw IoError(path, "cannot write: is a folder, not a file");
  if (fs::is_other(there) || IsAmongDevices(path)) {
    throw IoError(path, "cannot write: is a device or a pipe, or leads to one, and no file");
  }
}

void WriteFileAtomically(const std::string& path, const std::function<void(std::ostream&)>& write) {
  CheckTakesFile(path);
  std::optional<TemporaryPath> temporary;  // removed after errno was read
  std::ofstream out;
  // An exception at the first byte that cannot be written: the reason is still in errno, and the
  // rest is not made in vain.
  out.exceptions(std::ios::failbit | std::ios::badbit);
  try {
    // The folder, too, is made here: after AbandonWrites, nothing may be made any more.
    temporary.emplace(TemporaryFor(path), [&](const fs::path& made) {
      MakeParentFolder(path);
      errno = 0;
      out.open(made, std::ios::binary | std::ios::trunc);
    });
    TakeModeOf(path, temporary->path());
    write(out);
    out.close();
  } catch (const std::ios_base::failure&) {
    throw IoError(path, std::string("cannot write: ") + std::strerror(errno));
  }
  const std::error_code error = temporary->RenameTo(path);
  if (error) throw IoError(path, "cannot write: " + error.message());
}

void WriteFileAtomically(const std::string& path, std::string_view bytes) {
  WriteFileAtomically(path, [&](std::ostream& out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace limn
