// SPDX-License-Identifier: BSD-3-Clause
// Edits made by hand, applied to the drawing of some small images and to one that was drawn anew.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"
#include "end_to_end/small_scene.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

Json PlaceAsJson(const Eigen::Vector3d& place) { return {place.x(), place.y(), place.z()}; }

Json RefAsJson(const DrawingLink& link, int id) {
  Json points = Json::array();
  for (const Eigen::Vector3d& point :
       ResampleUniform(link.points_in_world, Length(link.points_in_world) / 14.999)) {
    points.push_back(PlaceAsJson(point));
  }
  return {{"id", id}, {"closed", link.closed}, {"points", points}};
}

// The drawing of the small scene, and the options that its commands share.
class DrawingEditor : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene_ = new SmallScene;
    const LimnRun run = RunLimn(scene_->Arguments());
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  static void TearDownTestSuite() { delete scene_; }

  DrawingEditor() : given_(ReadDrawingJson(drawing_path_).graph) {
    for (LinkId id = 0; id < static_cast<LinkId>(given_.links.size()); ++id) {
      if (!given_.links[id].closed) by_length_.push_back(id);
    }
    std::ranges::stable_sort(by_length_, std::greater{},
                             [&](LinkId id) { return Length(given_.links[id].points_in_world); });
  }

  Json Ref(LinkId id) const { return RefAsJson(given_.links[id], id); }
  Eigen::Vector3d Middle(LinkId id) const {
    const Polyline3d& points = given_.links[id].points_in_world;
    return points[points.size() / 2];
  }

  std::string WriteEdits(const Json& edits) {
    const Json file = {{"format", "limn_edits"}, {"format_version", 1}, {"edits", edits}};
    return dir_.WriteFile("edits.json", file.dump());
  }

  // Into a folder of the test's own.
  LimnRun Edit(const std::string& edits_path, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = scene_->Arguments();
    arguments[0] = "drawing_editor";
    *(std::ranges::find(arguments, "--output_path") + 1) = Output();
    arguments.insert(arguments.end(), {"--edits", edits_path, "--drawing_path", drawing_path_});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunLimn(arguments);
  }

  std::string Output() const { return (dir_ / "edited").string(); }
  DrawingGraph Result() const { return ReadDrawingJson(Output() + "/drawing.json").graph; }

  static SmallScene* scene_;
  TempDir dir_;
  std::string drawing_path_ = (*scene_ / "drawing.json").string();
  DrawingGraph given_;
  std::vector<LinkId> by_length_;  // longest first, open ones
};
SmallScene* DrawingEditor::scene_ = nullptr;

TEST_F(DrawingEditor, AppliesEditsAndLeavesTheRestAsItWas) {
  const LinkId split = by_length_[0], painted = by_length_[1], deleted = by_length_[2];
  const Eigen::Vector3d end = given_.links[painted].points_in_world.back();
  const LimnRun run = Edit(
      WriteEdits({{{"edit", "split"}, {"link", Ref(split)}, {"at", PlaceAsJson(Middle(split))}},
                  {{"edit", "set_kind"}, {"links", {Ref(painted)}}, {"kind", "paint"}},
                  {{"edit", "delete"}, {"links", {Ref(deleted)}}},
                  {{"edit", "delete"}, {"links", {Ref(deleted)}}},
                  {{"edit", "dimension"},
                   {"from", {{"link", Ref(split)}, {"at", PlaceAsJson(Middle(split))}}},
                   {"to", {{"link", Ref(painted)}, {"at", PlaceAsJson(end)}}},
                   {"shift", {0, 0, 0.1}}}}));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("edits: 5; applied 4, in part 0, not found 1"));
  EXPECT_THAT(run.out, HasSubstr("WARNING: edits[3] (delete): not found: no link runs along it"));
  for (const char* name :
       {"drawing.ply", "drawing.obj", "curves/tracks.txt", "curves/overlays/view_03.jpg.png"}) {
    EXPECT_TRUE(fs::exists(fs::path(Output()) / name)) << name;
  }
  const DrawingGraph edited = Result();
  ASSERT_EQ(edited.links.size(), given_.links.size());  // one more, and one less
  for (LinkId id = 0; id < static_cast<LinkId>(given_.links.size()); ++id) {
    if (id == split || id == deleted) continue;
    const DrawingLink& before = given_.links[id];
    const DrawingLink& after = edited.links[id - (id > deleted)];
    EXPECT_EQ(after.points_in_world, before.points_in_world) << id;
    EXPECT_EQ(after.sigma, before.sigma) << id;
    EXPECT_EQ(after.kind, id == painted ? LinkKind::kPaint : before.kind) << id;
    EXPECT_EQ(after.primitive.has_value(), before.primitive.has_value()) << id;
  }
  for (const LinkId id : {split - (split > deleted), static_cast<int>(edited.links.size()) - 1}) {
    EXPECT_TRUE(edited.links[id].primitive) << id;
    EXPECT_GE(edited.links[id].supporting_views.size(), 3u) << id;
  }
  ASSERT_EQ(edited.dimensions.size(), 1u);
  EXPECT_EQ(edited.dimensions[0].to, end);
}

TEST_F(DrawingEditor, ARefusedFileWritesNothing) {
  Json ref = Ref(by_length_[0]);
  ref["points"].back() = {0, 0};
  const std::string path = WriteEdits(Json::array({{{"edit", "delete"}, {"links", {ref}}}}));
  const auto before = ReadTree(dir_.path());
  const LimnRun run = Edit(path);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err,
            "ERROR: " + path + ": edits[0].links[0].points[15]: a list of 3 numbers expected\n");
  EXPECT_EQ(Edit("").exit_code, 1);
  EXPECT_EQ(ReadTree(dir_.path()), before);
}

TEST_F(DrawingEditor, DoesNotReplaceOtherEditsUnasked) {
  const auto kind = [&](const char* name) {
    return WriteEdits(
        Json::array({{{"edit", "set_kind"}, {"links", {Ref(by_length_[0])}}, {"kind", name}}}));
  };
  ASSERT_EQ(Edit(kind("paint")).exit_code, 0);
  ASSERT_EQ(Edit(kind("paint")).exit_code, 0);
  const LimnRun refused = Edit(kind("shadow"));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, AllOf(StartsWith("ERROR: "), HasSubstr("--overwrite 1")));
  EXPECT_EQ(Edit(kind("shadow"), {"--overwrite", "1"}).exit_code, 0);
  EXPECT_EQ(Result().links[by_length_[0]].kind, LinkKind::kShadow);
}

TEST_F(DrawingEditor, MostEditsFitASceneThatWasDrawnAnew) {
  const SmallScene other;
  const LimnRun drawn = RunLimn(other.Arguments({"--DrawingRefinement.num_rounds", "2"}));
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  const DrawingGraph anew = ReadDrawingJson((other / "drawing.json").string()).graph;
  Json edits = Json::array();
  for (int k = 0; k < 20; ++k) {
    edits.push_back({{"edit", "set_kind"}, {"links", {Ref(by_length_[k])}}, {"kind", "shadow"}});
  }
  drawing_path_ = (other / "drawing.json").string();
  const LimnRun run = Edit(WriteEdits(edits));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const DrawingGraph edited = Result();
  ASSERT_EQ(edited.links.size(), anew.links.size());
  int num_shadows = 0;
  for (size_t l = 0; l < anew.links.size(); ++l) {
    EXPECT_EQ(edited.links[l].points_in_world, anew.links[l].points_in_world) << l;
    num_shadows +=
        edited.links[l].kind == LinkKind::kShadow && edited.links[l].kind_confidence == 1;
  }
  EXPECT_GE(num_shadows, 14) << run.out;
}

}  // namespace
}  // namespace limn::testing
