// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "limn/drawing/samples.h"
#include "limn/paper/merging.h"
#include "limn/topology/drawing_scene.h"

namespace limn::testing {

// Links that are curves of a sketch, to be merged and fitted. What was merged replaces them.
class MergingScene : public DrawingScene {
 public:
  using DrawingScene::DrawingScene;

  // The consistency network says that a curve runs along another one, each sample along the nearest
  // of the other.
  void RunAlong(int curve, int other) { along_.push_back({curve, other}); }

  // All others are in cluster 0.
  void PutIntoCluster(int curve, int cluster) { cluster_of_[curve] = cluster; }

  MergingCounts Merge(const PaperOptions& options = {});

  // Writes <name>.svg, the curves and below them the links, into the folder that the environment
  // variable LIMN_PICTURES names, if it does (src/limn/paper/README.md).
  void WritePicture(const std::string& name);

 private:
  SampleSet MakeSampleSet() const;
  CurveConsistency MakeNetwork(const SampleSet& samples) const;

  std::vector<std::pair<int, int>> along_;
  std::map<int, int> cluster_of_;
};

class MergingSceneTest : public ::testing::TestWithParam<SceneVariant> {
 protected:
  MergingScene scene_{GetParam()};
};

}  // namespace limn::testing
