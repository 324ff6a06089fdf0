#include "limn/io/atomic_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "limn/util/errors.h"

namespace limn {
namespace {

// Removes the temporary file unless it has been renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::string path) : path_(std::move(path)) {}
  ~TemporaryFile() {
    if (path_.empty()) return;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

  void RenameTo(const std::string& path) {
    std::error_code error;
    std::filesystem::rename(path_, path, error);
    if (error) throw IoError(path, "cannot rename " + path_ + " to it: " + error.message());
    path_.clear();
  }

 private:
  std::string path_;
};

void MakeParentFolder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError(folder.string(), "cannot create the folder: " + error.message());
}

}  // namespace

void WriteFileAtomically(const std::string& path, const std::function<void(std::ostream&)>& write) {
  MakeParentFolder(path);
  TemporaryFile temporary(path + ".tmp");
  errno = 0;
  std::ofstream out(temporary.path(), std::ios::binary | std::ios::trunc);
  if (!out) throw IoError(temporary.path(), std::string("cannot write: ") + std::strerror(errno));
  write(out);
  out.close();
  if (!out) throw IoError(temporary.path(), std::string("cannot write: ") + std::strerror(errno));
  temporary.RenameTo(path);
}

void WriteFileAtomically(const std::string& path, std::string_view bytes) {
  WriteFileAtomically(path, [&](std::ostream& out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace limn
