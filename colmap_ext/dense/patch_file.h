#pragma once

#include <array>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace limn::colmap_ext {

// An oriented patch of PMVS.
struct Patch {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double photometric_score = 0;           // mean normalised cross correlation
  std::array<double, 2> scales = {1, 1};  // of PMVS's search for depth and angle
  // PMVS numbers of the images that see it, the reference image first, and that may see it.
  std::vector<int> images;
  std::vector<int> more_images;
};

// Reads a .patch file of PMVS2 (PATCHS and PATCHA records), one patch after the other. Throws
// IoError naming the line: no patch file, too short, numbers that are not finite, negative counts.
void ReadPatchFile(const std::string& path, const std::function<void(const Patch&)>& visit);

// Writes one that PMVS2's tools read.
void WritePatchFile(const std::vector<Patch>& patches, std::ostream& out);

// The names of the images by PMVS number: bundle.rd.out.list.txt in the folder above that of the
// file, if it is there. Empty: the numbers are those of the model's file order.
std::vector<std::string> ReadPmvsImageNames(const std::string& file_in_models);

}  // namespace limn::colmap_ext
