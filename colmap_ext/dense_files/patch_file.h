// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limn/model/view.h"

namespace limn::colmap_ext {

// An oriented patch of PMVS.
struct Patch {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double photometric_score = 0;           // mean normalized cross correlation
  std::array<double, 2> scales = {1, 1};  // of PMVS's search in depth and angle
  // PMVS numbers of the images that see it, the reference image first, and of those that may see
  // it.
  std::vector<int> images;
  std::vector<int> more_images;
};

// Reads a PMVS2 .patch file (PATCHS and PATCHA records), one patch at a time. Throws IoError with
// the line: not a patch file, too short, non-finite numbers, negative counts or image numbers.
void ReadPatchFile(const std::string& path, const std::function<void(const Patch&)>& visit);

// Write a file for PMVS2's tools: the header, then `num_patches` patches.
void WritePatchHeader(uint64_t num_patches, std::ostream& out);
void WritePatch(const Patch& patch, std::ostream& out);

// Per view its number in the PMVS folder that contains the file (in models/); -1 if it has none. If
// the folder has no list of images, the numbers are the indices of the images in the model file.
std::vector<int> PmvsNumbers(const std::filesystem::path& file_in_models,
                             const std::vector<View>& views);

}  // namespace limn::colmap_ext
