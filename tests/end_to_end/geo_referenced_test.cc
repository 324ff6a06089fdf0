// SPDX-License-Identifier: BSD-3-Clause
// Models in coordinates of a UTM zone, of millions of meters.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/scene_origin.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/geometry/polyline.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

double TotalLength(const DrawingGraph& graph) {
  double sum = 0;
  for (const DrawingLink& link : graph.links) sum += Length(link.points_in_world);
  return sum;
}

// Eight small images of the sample scene.
class GeoReferenced : public ::testing::Test {
 protected:
  GeoReferenced() {
    std::string names;
    for (int i = 0; i < 8; ++i) names += "view_0" + std::to_string(i) + ".jpg\n";
    list_ = dir_.WriteFile("list.txt", names);
  }

  // Moves the model by `shift` and writes it to a folder.
  void Move(const std::string& folder, const Eigen::Vector3d& shift) {
    colmap_ext::MoveModel(shift, &model_);
    fs::create_directories(dir_ / folder);
    colmap_ext::WriteModelText(model_, dir_ / folder);
  }

  // Runs a command on a model of Move; results go to <folder>-out. What it prints.
  std::string Run(const std::string& command, const std::string& folder,
                  const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {command,
                                          "--input_path",
                                          (dir_ / folder).string(),
                                          "--image_path",
                                          LIMN_SAMPLE_DIR "/day/images",
                                          "--output_path",
                                          (dir_ / (folder + "-out")).string(),
                                          "--image_list_path",
                                          list_,
                                          "--quality",
                                          "low",
                                          "--max_image_size",
                                          "320"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const LimnRun run = RunLimn(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.out;
  }

  std::string Output(const std::string& folder, const std::string& name) const {
    return (dir_ / (folder + "-out") / name).string();
  }
  DrawingGraph Drawing(const std::string& folder) const {
    return ReadDrawingJson(Output(folder, "drawing.json")).graph;
  }

  TempDir dir_;
  std::string list_;
  // In single precision pixels (1 cm) would be lost there.
  const Eigen::Vector3d shift_{5e5, 4e6, 100};
  colmap_ext::SparseModel model_ = colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
};

// The near model is made from the far one, whose poses have lost digits (5e-10 m) already: that
// much is enough to turn ties between edgels the other way.
TEST_F(GeoReferenced, DrawingMovesWithTheModel) {
  Move("far", shift_);
  Move("near", -shift_);
  Run("automatic_drawer", "near");
  EXPECT_THAT(Run("automatic_drawer", "far"), HasSubstr("working around (500000, 4000000, 100)"));
  const DrawingGraph near = Drawing("near");
  const DrawingGraph far = Drawing("far");
  ASSERT_GT(near.links.size(), 20u);
  ASSERT_EQ(near.links.size(), far.links.size());
  Eigen::AlignedBox3d box;
  for (const DrawingNode& node : near.nodes) box.extend(node.position_in_world);
  const double tolerance = 1e-6 * box.diagonal().norm();
  for (size_t i = 0; i < near.links.size(); ++i) {
    const auto& points = near.links[i].points_in_world;
    ASSERT_EQ(points.size(), far.links[i].points_in_world.size());
    EXPECT_EQ(near.links[i].supporting_views, far.links[i].supporting_views);
    for (size_t k = 0; k < points.size(); ++k) {
      EXPECT_LT((points[k] + shift_ - far.links[i].points_in_world[k]).norm(), tolerance);
    }
  }
}

// At coordinates that are not round ties turn the other way; the drawing is as good.
TEST_F(GeoReferenced, AnyShiftGivesAsGoodADrawing) {
  Move("near", {0, 0, 0});
  Move("far", shift_ + Eigen::Vector3d(3.3, -1.7, 1.1));
  Run("automatic_drawer", "near");
  Run("automatic_drawer", "far");
  const double length = TotalLength(Drawing("near"));
  EXPECT_NEAR(TotalLength(Drawing("far")), length, 0.05 * length);
}

// Boxes are given, drawings read back, sketches and cameras written in the model's coordinates.
TEST_F(GeoReferenced, AllFilesAreInTheModelsCoordinates) {
  Move("far", shift_);
  Run("automatic_drawer", "far",
      {"--box=499999.5,500000.5,3999999.5,4000000.5,100.04,101.05", "--refine_cameras", "1"});
  const DrawingGraph inside = Drawing("far");
  ASSERT_FALSE(inside.links.empty());
  // Averaging may move what lies on the border by a few pixel footprints (1 cm each).
  for (const DrawingNode& node : inside.nodes) {
    EXPECT_LT((node.position_in_world - shift_).head<2>().cwiseAbs().maxCoeff(), 0.53);
  }
  const CurveSet sketch = ReadCurves(Output("far", "curves/swept-sketch.ply"));
  ASSERT_FALSE(sketch.polylines.empty());
  for (const Polyline3d& line : sketch.polylines) {
    EXPECT_LT((line.front() - shift_).norm(), 10);
  }
  const colmap_ext::SparseModel refined = colmap_ext::ReadModel(Output("far", "refined"));
  for (size_t i = 0; i < refined.images.size(); ++i) {
    const Rigid3d difference =
        refined.images[i].cam_from_world * Inverse(model_.images[i].cam_from_world);
    EXPECT_LT(difference.translation.norm(), 0.02);
  }
}

}  // namespace
}  // namespace limn::testing
