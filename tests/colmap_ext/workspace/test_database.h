// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace limn::testing {

// The versions of COLMAP whose databases have different priors (4.2 has those of 4.1).
enum class DatabaseVersion { k3_8, k3_10, k3_12, k4_1 };

constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();

struct StoredPrior {
  std::string image;
  Eigen::Vector3d position = Eigen::Vector3d::Constant(kNotGiven);
  int coordinate_system = 0;  // 0: WGS84, 1: Cartesian, -1: undefined
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Constant(kNotGiven);
  Eigen::Vector3d gravity = Eigen::Vector3d::Constant(kNotGiven);
};

// Writes the tables of a database that hold priors, with what this version of COLMAP stores. In
// 4.1 image ids have no order, and a prior of another sensor stands beside each.
void WriteDatabase(const std::filesystem::path& path, DatabaseVersion version,
                   const std::vector<StoredPrior>& priors);

// Runs SQL on a database, which is made if it does not exist.
void RunSql(const std::filesystem::path& path, const std::string& sql);

}  // namespace limn::testing
