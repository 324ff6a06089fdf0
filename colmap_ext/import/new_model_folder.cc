// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/new_model_folder.h"

#include <system_error>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/files/atomic_file.h"
#include "limn/files/temporary_path.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

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
  if (!fs::is_directory(folder, ignored)) throw IoError(folder.string(), "is not a folder");
  if (HoldsModel(folder)) {
    throw IoError(folder.string(), "holds a model already; it is not overwritten");
  }
  if (!fs::is_empty(folder, ignored)) {
    throw IoError(folder.string(),
                  "the folder is not empty; a model is written to a new or empty one");
  }
}

void WriteNewModel(const SparseModel& model, const fs::path& folder, ModelFlavor flavor,
                   const std::function<void(const OutputPath&)>& write_more) {
  CheckNewModelFolder(folder);
  const fs::path path = Plain(folder);
  TemporaryPath temporary(OutputPath(path) + kTemporarySuffix, &MakeEmptyFolder);
  WriteModel(model, flavor, temporary.path());
  if (write_more) write_more(temporary.path());
  // Replaces an empty folder, fails on any other.
  if (const std::error_code error = temporary.RenameTo(path.filename().string())) {
    throw IoError(path.string(),
                  "cannot rename " + temporary.path().string() + " to it: " + error.message());
  }
}

}  // namespace limn::colmap_ext
