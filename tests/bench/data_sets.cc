// SPDX-License-Identifier: BSD-3-Clause
#include "bench/data_sets.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "limn/util/errors.h"

namespace limn::bench {
namespace {

NamedBox Box(const std::string& name, double x0, double x1, double y0, double y1, double z0,
             double z1) {
  return {name, Eigen::AlignedBox3d(Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1))};
}

// Stored results of Line3D++ and of the curve sketch's program of 2010; `mcs_runs`: the file's name
// after the scene and what it means.
std::vector<PeerResult> Peers(const std::string& data_path, const std::string& scene,
                              const std::vector<std::pair<std::string, std::string>>& mcs_runs) {
  const std::string root = data_path + "/peers/";
  std::vector<PeerResult> peers = {{"Line3D++", root + "line3dpp-" + scene + ".obj.gz"}};
  for (const auto& [run, meaning] : mcs_runs) {
    peers.push_back({"2010 program, " + meaning, root + "mcs-" + scene + "-" + run + ".obj.gz"});
  }
  return peers;
}

constexpr const char* kPublished = "published thresholds, 50 inliers";
constexpr const char* kShortKept = "short curves kept, no inliers asked for";

void AddCloudOfPmvs(DataSet* set) {
  set->cloud_path = set->workspace_path + "/pmvs/models/option-all.ply";
  set->peers.push_back({"PMVS points", set->cloud_path});
}

// Mesh edges marked by hand, meters. Box A: the chairs and the floor around; box B: without it.
DataSet Pavilion(const std::string& data_path, const std::string& light) {
  const std::string root = data_path + "/pavilion";
  DataSet set;
  set.name = "pavilion-" + light;
  set.plot = "pavilion";
  set.workspace_path = root + "/" + light;
  set.truth_path = root + "/ground_truth/gt-points.txt";
  set.truth_edges_path = root + "/ground_truth/gt-edges.txt";
  set.taus = {0.01, 0.02, 0.05};
  set.boxes = {Box("A", -0.2, 3.2, -2.2, 1.9, 1.45, 2.6),
               Box("B", -0.2, 3.2, -2.2, 1.9, 1.53, 2.6)};
  set.peers = Peers(data_path, set.name, {{"short-s0", kShortKept}});
  if (light == "midday") {
    set.peers = Peers(data_path, set.name, {{"pub-s50", kPublished}, {"short-s0", kShortKept}});
    AddCloudOfPmvs(&set);
  }
  return set;
}

// Scan points near edges, in meters.
DataSet Vase(const std::string& data_path) {
  DataSet set;
  set.name = set.plot = "vase";
  set.workspace_path = data_path + "/vase";
  set.truth_path = set.workspace_path + "/ground_truth/vase-edge-gt3-017.txt.gz";
  set.taus = {0.0005, 0.001, 0.002};
  set.judge_around_truth = true;
  set.peers = Peers(data_path, set.name, {{"pub-s50", kPublished}});
  AddCloudOfPmvs(&set);
  return set;
}

DataSet Abc(const std::string& data_path, const std::string& object) {
  DataSet set;
  set.name = set.plot = "abc-" + object;
  set.workspace_path = data_path + "/abc-" + object;
  set.truth_path = set.workspace_path + "/ground_truth/curves-visible.ply";
  set.emap_truth_path = set.workspace_path + "/ground_truth/curves.ply";
  set.taus = {0.005, 0.01, 0.02};
  return set;
}

// Rendered scenes, judged in footprints. `truth` is the folder of their curves and junctions.
DataSet Rendered(const std::string& name, const std::string& workspace, const std::string& truth,
                 const NamedBox& box) {
  DataSet set;
  set.name = set.plot = name;
  set.workspace_path = workspace;
  set.truth_path = truth + "/curves-visible.ply";
  set.junctions_path = truth + "/junctions.json";
  set.dont_care_path = truth + "/dont-care.ply";
  set.taus = {1, 2, 4};
  set.in_footprints = true;
  set.boxes = {box};
  return set;
}

// `light` is the folder of the light below truth/, or empty.
DataSet Sample(const std::string& sample_path, const std::string& variant,
               const std::string& light) {
  DataSet set =
      Rendered("sample-" + variant, sample_path + "/" + variant, sample_path + "/truth/" + light,
               Box("all", -1.25, 1.25, -0.95, 0.95, 0.04, 1.05));
  if (variant == "day" || variant == "mixed") set.plot = "sample";
  return set;
}

DataSet Room(const std::string& data_path) {
  return Rendered("room", data_path + "/room", data_path + "/room/truth",
                  Box("all", -0.05, 5.05, -0.05, 4.5, -0.05, 2.65));
}

DataSet Bench(const std::string& data_path) {
  DataSet set = Rendered("bench", data_path + "/bench", data_path + "/bench/truth",
                         Box("all", -5.5, 5.7, -3.4, 3.4, 0.48, 3.4));
  set.rods_path = data_path + "/bench/truth/rods.ply";
  return set;
}

DataSet WithoutTruth(const std::string& data_path, const std::string& name) {
  DataSet set;
  set.name = set.plot = name;
  set.workspace_path = data_path + "/" + name;
  return set;
}

std::vector<std::string> Split(const std::string& names) {
  std::vector<std::string> parts;
  std::istringstream stream(names);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

}  // namespace

std::vector<DataSet> KnownDataSets(const std::string& data_path, const std::string& sample_path) {
  return {Pavilion(data_path, "midday"),
          Pavilion(data_path, "mixed"),
          Vase(data_path),
          Abc(data_path, "00000952"),
          Abc(data_path, "00004926"),
          Sample(sample_path, "day", ""),
          Sample(sample_path, "distorted", ""),
          Sample(sample_path, "evening", "evening"),
          Sample(sample_path, "lamp", "lamp"),
          Sample(sample_path, "mixed", "mixed"),
          Room(data_path),
          Bench(data_path),
          WithoutTruth(data_path, "herz-jesu-p8"),
          WithoutTruth(data_path, "desk"),
          WithoutTruth(data_path, "book")};
}

bool IsPresent(const DataSet& set) { return std::filesystem::is_directory(set.workspace_path); }

std::vector<DataSet> SelectDataSets(const std::vector<DataSet>& known, const std::string& names) {
  std::vector<DataSet> selected;
  if (names.empty()) {
    std::copy_if(known.begin(), known.end(), std::back_inserter(selected), IsPresent);
    return selected;
  }
  for (const std::string& name : Split(names)) {
    const auto set = std::find_if(known.begin(), known.end(),
                                  [&](const DataSet& candidate) { return candidate.name == name; });
    if (set == known.end()) {
      std::string message = "sets = " + name + ": must be among";
      for (const DataSet& candidate : known) message += " " + candidate.name;
      throw OptionError(message);
    }
    if (!IsPresent(*set)) throw IoError(set->workspace_path, "there is no such folder");
    selected.push_back(*set);
  }
  return selected;
}

}  // namespace limn::bench
