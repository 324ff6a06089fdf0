#include "colmap_ext/import/new_model_folder.h"

#include <system_error>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// Removes the temporary folder at the end, if it is still there.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(fs::path path) : path_(std::move(path)) {
    std::error_code error;
    fs::remove_all(path_, error);
    fs::create_directories(path_, error);
    if (error) throw IoError(path_.string(), "cannot create the folder: " + error.message());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Without a slash at the end, which would make the temporary folder one inside.
fs::path Plain(const fs::path& folder) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(folder, error);
  if (error) throw IoError(folder.string(), error.message());
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

void CheckNewModelFolder(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return;
  if (!fs::is_directory(folder, ignored)) throw IoError(folder.string(), "is no folder");
  if (HoldsModel(folder)) {
    throw IoError(folder.string(), "holds a model already; it is not overwritten");
  }
  if (!fs::is_empty(folder, ignored)) {
    throw IoError(folder.string(),
                  "the folder is not empty; a model is written to a new or empty one");
  }
}

void WriteNewModel(const SparseModel& model, const fs::path& folder, ModelFlavor flavor) {
  CheckNewModelFolder(folder);
  const fs::path path = Plain(folder);
  const TemporaryFolder temporary(path.string() + ".tmp");
  if (flavor == ModelFlavor::kText) {
    WriteModelText(model, temporary.path());
  } else {
    WriteModelBinary(model, temporary.path());
  }
  // Replaces an empty folder, fails on any other.
  std::error_code error;
  fs::rename(temporary.path(), path, error);
  if (error) {
    throw IoError(path.string(),
                  "cannot rename " + temporary.path().string() + " to it: " + error.message());
  }
}

}  // namespace limn::colmap_ext
