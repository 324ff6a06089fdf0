// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/output_folder.h"

#include <string>

#include "colmap_ext/workspace/output_check.h"
#include "limn/files/atomic_file.h"
#include "limn/files/writable_folder.h"

namespace limn::colmap_ext {
namespace {

enum class Depth { kOne, kAll };

// The folders beside that of curves, which commands write.
constexpr const char* kFolders[] = {"refined", "with-curves", "sparse-with-curves"};

// Other folders of temporary names may be being written by commands that hold no lock.
const std::string kTemporaryProject = "aligned" + std::string(kTemporarySuffix);

void RemoveTemporaryFilesIn(const WritableFolder& folder, Depth depth) {
  for (const std::string& name : folder.Names()) {
    if (name == kTemporaryProject) {
      folder.RemoveAll(name);
    } else if (name.ends_with(kTemporarySuffix)) {
      folder.Remove(name);
    }
    const auto inner = depth == Depth::kAll ? folder.Enter(name) : std::nullopt;
    if (inner) RemoveTemporaryFilesIn(*inner, depth);
  }
}

// Those that a killed run has left behind. Only while no other run writes here.
void RemoveTemporaryFiles(const OutputLayout& output) {
  const auto remove_in = [](const OutputPath& folder, Depth depth) {
    if (const auto found = WritableFolder::Find(folder)) RemoveTemporaryFilesIn(*found, depth);
  };
  remove_in(output.Drawing(), Depth::kOne);
  for (const char* folder : kFolders) remove_in(output.Drawing() / folder, Depth::kOne);
  remove_in(output.Curves(), Depth::kAll);
}

void CheckLinks(const OutputLayout& output) {
  for (const char* folder : kFolders) WritableFolder::Find(output.Drawing() / folder);  // throws
  CheckHoldsNoLinks(output.Curves());
}

}  // namespace

OutputFolder::OutputFolder(const OutputLayout& output, const RunOptions& options, Console* console)
    : output_(output) {
  CheckWritable(output.Drawing());
  CheckWritable(output.Curves());
  CheckLinks(output);
  if (!options.is_locked_by_rank_zero) {
    const bool is_alone = options.shard.empty();
    lock_.emplace(output.Curves(), is_alone ? LockMode::kExclusive : LockMode::kShared);
    if (is_alone) RemoveTemporaryFiles(output);
  }
  cache_ = std::make_shared<ResultCache>(CurvesPath("cache"));
  console->SetCache(cache_);
}

OutputPath OutputFolder::DrawingPath(const std::string& name) const {
  return output_.Drawing() / name;
}

OutputPath OutputFolder::CurvesPath(const std::string& name) const {
  return output_.Curves() / name;
}

}  // namespace limn::colmap_ext
