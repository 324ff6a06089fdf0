// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// A folder with a sparse model: COLMAP's files (model.h), or else a PMVS folder (pmvs_model.h).

bool HoldsModel(const std::filesystem::path& folder);

// MissingColmapFile; empty for a PMVS folder.
std::string MissingModelFile(const std::filesystem::path& folder);

// Number of registered images, without reading them. Throws IoError.
uint64_t CountRegisteredImages(const std::filesystem::path& folder);

// Throws IoError.
SparseModel ReadModel(const std::filesystem::path& folder);

}  // namespace limn::colmap_ext
