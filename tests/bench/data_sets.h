// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace limn::bench {

// Where a reconstruction is judged.
struct NamedBox {
  std::string name;
  // None: everywhere.
  std::optional<Eigen::AlignedBox3d> region;
};

// What another program made of a data set: curves or points in a file.
struct PeerResult {
  std::string program;
  std::string path;
};

// A COLMAP workspace and what is known of its scene. Empty paths: there is none.
struct DataSet {
  std::string name;  // fit for a file name
  // Data sets of the same plot share a picture.
  std::string plot;
  std::string workspace_path;
  std::string truth_path;
  std::string truth_edges_path;
  std::string junctions_path;
  std::string dont_care_path;
  // True center lines of rods.
  std::string rods_path;
  // The truth that EMAP's protocol takes, hidden edges included.
  std::string emap_truth_path;
  // A point cloud of PMVS to be drawn beside the drawing.
  std::string cloud_path;
  // Distances at which curves count as found, in the model's unit or in footprints.
  std::vector<double> taus;
  bool in_footprints = false;
  // Boxes to judge in; the first is the one that is plotted.
  std::vector<NamedBox> boxes = {{"all", std::nullopt}};
  // Judge also in the box around the truth and 5 % of its diagonal on every side.
  bool judge_around_truth = false;
  // May be missing.
  std::vector<PeerResult> peers;
};

// All data sets that quality is followed on, present or not: those below `data_path` (see its
// README.md) and the variants of the sample scene below `sample_path`.
std::vector<DataSet> KnownDataSets(const std::string& data_path, const std::string& sample_path);

// Whether its workspace is there.
bool IsPresent(const DataSet& set);

// Those named in `names` (with commas between them), or all that are present if `names` is empty.
// Throws OptionError for a name that is none, IoError for a set that is asked for and missing.
std::vector<DataSet> SelectDataSets(const std::vector<DataSet>& known, const std::string& names);

}  // namespace limn::bench
