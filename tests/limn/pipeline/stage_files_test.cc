#include "limn/pipeline/stage_files.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "limn/io/whole_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

class StageFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("limn_stage_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / "file").string();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void Overwrite(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary) << bytes;
  }

  std::filesystem::path folder_;
  std::string path_;
};

EdgeMap MakeEdgeMap() {
  EdgeMap map;
  map.width = 64;
  map.height = 48;
  map.gradient_noise = 0.37;
  for (int i = 0; i < 5; ++i) {
    Edgel edgel;
    edgel.position_px = {10.1 + i, 20.7 - 0.3 * i};
    edgel.stored_px = edgel.position_px.cast<float>();
    edgel.tangent_rad = 0.1 * i;
    edgel.strength = 3.5f + static_cast<float>(i);
    edgel.position_sigma_px = 0.05f;
    map.edgels.push_back(edgel);
  }
  return map;
}

LinkingResult MakeLinked() {
  LinkingResult linked;
  linked.curves.edge_map = MakeEdgeMap();
  linked.curves.fragments = {{{0, 1, 2}, false}, {{4, 3}, true}};
  linked.curves.link_graph = {{0, 1, 5}, {1, 2, 4}, {3, 4, 1}};
  linked.stats.edgels = 5;
  linked.stats.fragments = 2;
  linked.stats.fragments_length_px = 12.25;
  return linked;
}

StoredSketch MakeSketch() {
  Curve3D curve;
  for (int i = 0; i < 3; ++i) {
    curve.points_in_world.emplace_back(i, 0.1 * i, -2.0);
    curve.tangents_in_world.push_back(Eigen::Vector3d::UnitX());
    curve.depth_sigma.push_back(0.01 * (i + 1));
    curve.certain.push_back(i != 1);
    const std::vector<EdgelRef> support = {{0, i}, {3, 7 + i}};
    curve.support.Append(std::span(support).first(i == 1 ? 1 : 2));
  }
  curve.anchor = {3, 2, 1};
  curve.closed = true;
  return {{{curve, Curve3D()}}, "{\"a\":1}"};
}

void ExpectSame(const EdgeMap& actual, const EdgeMap& expected) {
  EXPECT_EQ(actual.width, expected.width);
  EXPECT_EQ(actual.height, expected.height);
  EXPECT_EQ(actual.gradient_noise, expected.gradient_noise);
  ASSERT_EQ(actual.edgels.size(), expected.edgels.size());
  for (size_t i = 0; i < actual.edgels.size(); ++i) {
    EXPECT_EQ(actual.edgels[i].position_px, expected.edgels[i].position_px);
    EXPECT_EQ(actual.edgels[i].stored_px, expected.edgels[i].stored_px);
    EXPECT_EQ(actual.edgels[i].tangent_rad, expected.edgels[i].tangent_rad);
    EXPECT_EQ(actual.edgels[i].strength, expected.edgels[i].strength);
    EXPECT_EQ(actual.edgels[i].position_sigma_px, expected.edgels[i].position_sigma_px);
    EXPECT_EQ(actual.edgels[i].stored_from_virtual, expected.edgels[i].stored_from_virtual);
  }
}

TEST_F(StageFiles, EdgeMapComesBack) {
  WriteEdgeMapFile(path_, "key", MakeEdgeMap());
  const auto read = ReadEdgeMapFile(path_, "key");
  ASSERT_TRUE(read);
  ExpectSame(*read, MakeEdgeMap());
}

TEST_F(StageFiles, FragmentsComeBack) {
  const LinkingResult expected = MakeLinked();
  WriteFragmentsFile(path_, "key", expected);
  const auto read = ReadFragmentsFile(path_, "key");
  ASSERT_TRUE(read);
  ExpectSame(read->curves.edge_map, expected.curves.edge_map);
  ASSERT_EQ(read->curves.fragments.size(), 2u);
  EXPECT_EQ(read->curves.fragments[0].edgel_ids, expected.curves.fragments[0].edgel_ids);
  EXPECT_FALSE(read->curves.fragments[0].closed);
  EXPECT_TRUE(read->curves.fragments[1].closed);
  ASSERT_EQ(read->curves.link_graph.size(), 3u);
  EXPECT_EQ(read->curves.link_graph[2].a, 3);
  EXPECT_EQ(read->curves.link_graph[0].votes, 5);
  EXPECT_EQ(read->stats.edgels, 5);
  EXPECT_EQ(read->stats.fragments, 2);
  EXPECT_EQ(read->stats.fragments_length_px, 12.25);
}

TEST_F(StageFiles, SketchComesBack) {
  const StoredSketch expected = MakeSketch();
  WriteSketchFile(path_, "key", expected);
  const StoredSketch read = ReadSketchFile(path_, "key");
  EXPECT_EQ(read.options_json, expected.options_json);
  ASSERT_EQ(read.sketch.curves.size(), 2u);
  const Curve3D& curve = read.sketch.curves[0];
  const Curve3D& original = expected.sketch.curves[0];
  EXPECT_EQ(curve.points_in_world, original.points_in_world);
  EXPECT_EQ(curve.tangents_in_world, original.tangents_in_world);
  EXPECT_EQ(curve.depth_sigma, original.depth_sigma);
  EXPECT_EQ(curve.certain, original.certain);
  EXPECT_EQ(curve.support.offsets, original.support.offsets);
  EXPECT_EQ(curve.support.edgels, original.support.edgels);
  EXPECT_EQ(curve.anchor.view, 3);
  EXPECT_EQ(curve.anchor.fragment, 2);
  EXPECT_EQ(curve.anchor.begin, 1);
  EXPECT_TRUE(curve.closed);
  EXPECT_EQ(read.sketch.curves[1].size(), 0u);
}

TEST_F(StageFiles, MissingOrOtherKeyIsNoResult) {
  EXPECT_FALSE(ReadEdgeMapFile(path_, "key"));
  WriteEdgeMapFile(path_, "key", MakeEdgeMap());
  EXPECT_FALSE(ReadEdgeMapFile(path_, "other"));
  WriteFragmentsFile(path_, "key", MakeLinked());
  EXPECT_FALSE(ReadFragmentsFile(path_, "other"));
}

TEST_F(StageFiles, SketchOfOtherCurvesIsRefused) {
  EXPECT_THROW(ReadSketchFile(path_, "key"), IoError);
  WriteSketchFile(path_, "key", MakeSketch());
  EXPECT_THROW(ReadSketchFile(path_, "other"), IoError);
}

TEST_F(StageFiles, OtherKindIsRefused) {
  WriteEdgeMapFile(path_, "key", MakeEdgeMap());
  EXPECT_THROW(ReadFragmentsFile(path_, "key"), IoError);
  EXPECT_THROW(ReadSketchFile(path_, "key"), IoError);
}

TEST_F(StageFiles, EveryTruncationIsNoticed) {
  WriteSketchFile(path_, "key", MakeSketch());
  const std::string bytes = ReadWholeFile(path_);
  for (size_t size = 0; size < bytes.size(); ++size) {
    Overwrite(bytes.substr(0, size));
    EXPECT_THROW(ReadSketchFile(path_, "key"), IoError) << size;
  }
}

TEST_F(StageFiles, EveryChangedByteIsNoticed) {
  WriteSketchFile(path_, "key", MakeSketch());
  const std::string bytes = ReadWholeFile(path_);
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x11);
    Overwrite(changed);
    EXPECT_THROW(ReadSketchFile(path_, "key"), IoError) << i;
  }
}

}  // namespace
}  // namespace limn
