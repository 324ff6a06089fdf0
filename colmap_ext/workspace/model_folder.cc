// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/model_folder.h"

#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/workspace/pmvs_model.h"

namespace limn::colmap_ext {
namespace {

bool IsPmvs(const std::filesystem::path& folder) {
  return !HoldsColmapModel(folder) && HoldsPmvsModel(folder);
}

}  // namespace

bool HoldsModel(const std::filesystem::path& folder) {
  return HoldsColmapModel(folder) || HoldsPmvsModel(folder);
}

std::string MissingModelFile(const std::filesystem::path& folder) {
  return HoldsPmvsModel(folder) ? "" : MissingColmapFile(folder);
}

uint64_t CountRegisteredImages(const std::filesystem::path& folder) {
  return IsPmvs(folder) ? CountPmvsImages(folder) : CountColmapImages(folder);
}

SparseModel ReadModel(const std::filesystem::path& folder) {
  return IsPmvs(folder) ? ReadPmvsModel(folder) : ReadColmapModel(folder);
}

}  // namespace limn::colmap_ext
