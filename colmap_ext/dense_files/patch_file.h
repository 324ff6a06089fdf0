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
  std::array<double, 2> scales = {1, 1};  // of PMVS's search for depth and angle
  // PMVS numbers of the images that see it, the reference image first, and that may see it.
  std::vector<int> images;
  std::vector<int> more_images;
};

// Reads a .patch file of PMVS2 (PATCHS and PATCHA records), one patch after the other. Throws
// IoError naming the line: no patch file, too short, numbers that are not finite, negative counts
// or image numbers.
void ReadPatchFile(const std::string& path, const std::function<void(const Patch&)>& visit);

// Write one that PMVS2's tools read: the header, then so many patches.
void WritePatchHeader(uint64_t num_patches, std::ostream& out);
void WritePatch(const Patch& patch, std::ostream& out);

// Per view its number in the PMVS folder that the file of patches or points lies in (in models/);
// -1 if it has none. Without the folder's list of images the numbers are those of the model's file
// order.
std::vector<int> PmvsNumbers(const std::filesystem::path& file_in_models,
                             const std::vector<View>& views);

}  // namespace limn::colmap_ext
