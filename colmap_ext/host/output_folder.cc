#include "colmap_ext/host/output_folder.h"

#include <filesystem>
#include <system_error>

#include "colmap_ext/workspace/output_check.h"
#include "limn/files/atomic_file.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

void RemoveTemporaryFilesIn(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().filename().string().ends_with(kTemporarySuffix)) {
      fs::remove(entry.path(), ignored);
    }
  }
}

// Those that a killed run has left behind. Only while no other run writes here.
void RemoveTemporaryFiles(const OutputLayout& output) {
  std::error_code ignored;
  for (const char* folder : {"", "refined", "with-curves", "sparse-with-curves"}) {
    RemoveTemporaryFilesIn(output.drawing_dir / folder);
  }
  RemoveTemporaryFilesIn(output.curves_dir);
  for (const auto& entry : fs::recursive_directory_iterator(output.curves_dir, ignored)) {
    if (entry.is_directory(ignored)) RemoveTemporaryFilesIn(entry.path());
  }
}

}  // namespace

OutputFolder::OutputFolder(const OutputLayout& output, const RunOptions& options, Console* console)
    : output_(output) {
  CheckWritable(output.drawing_dir);
  CheckWritable(output.curves_dir);
  CheckLinkedCurves(output.curves_dir);
  if (!options.is_locked_by_rank_zero) {
    const bool is_alone = options.shard.empty();
    lock_.emplace(output.curves_dir, is_alone ? LockMode::kExclusive : LockMode::kShared);
    if (is_alone) RemoveTemporaryFiles(output);
  }
  cache_ = std::make_shared<ResultCache>(CurvesPath("cache"));
  console->SetCache(cache_);
}

std::string OutputFolder::DrawingPath(const std::string& name) const {
  return (output_.drawing_dir / name).string();
}

std::string OutputFolder::CurvesPath(const std::string& name) const {
  return (output_.curves_dir / name).string();
}

}  // namespace limn::colmap_ext
