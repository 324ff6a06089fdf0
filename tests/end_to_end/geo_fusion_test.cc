// SPDX-License-Identifier: BSD-3-Clause
// drawing_fuser in coordinates of a UTM zone, of millions of meters.
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/dense_files/patch_file.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/scene_origin.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/fusion_scene.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Six cameras, the plane under them and a drawing, twice: near the origin, and the same far away.
class GeoFusion : public ::testing::Test {
 protected:
  GeoFusion() {
    colmap_ext::SparseModel model = colmap_ext::ReadModel(LIMN_CORPUS_DIR "/base/sparse");
    AddRig(&model);
    // The poses far away have lost digits; the near ones are made from them.
    Move(shift_, &model);
    Write("far", model, shift_);
    Move(-shift_, &model);
    Write("near", model, Eigen::Vector3d::Zero());
  }

  // Of its only camera.
  static void AddRig(colmap_ext::SparseModel* model) {
    const colmap_ext::SensorId camera = {colmap_ext::kCameraSensor, model->cameras.front().id};
    model->rigs = {{1, {{camera, true, {}}}}};
    for (const colmap_ext::ModelImage& image : model->images) {
      model->frames.push_back({image.id, 1, image.cam_from_world, {{camera, image.id}}});
    }
  }

  static void Move(const Eigen::Vector3d& shift, colmap_ext::SparseModel* model) {
    colmap_ext::MoveModel(shift, model);
    for (size_t i = 0; i < model->frames.size(); ++i) {
      model->frames[i].rig_from_world = model->images[i].cam_from_world;
    }
  }

  void Write(const std::string& folder, const colmap_ext::SparseModel& model,
             const Eigen::Vector3d& shift) {
    fs::create_directories(dir_ / folder / "sparse");
    colmap_ext::WriteModelText(model, dir_ / folder / "sparse");
    WritePlaneDrawing(dir_ / folder / "drawing.json", model, shift);
    WritePlaneDepthMaps(dir_ / folder / "stereo", model, 0.25, "geometric", shift);
    const auto write = [&](const std::string& name, const std::string& bytes) {
      dir_.WriteFile(folder + "/" + name, bytes);
    };
    write("double.ply", PlanePly({.type = "double"}, shift));
    write("pmvs/models/option.patch", PlanePatches({0, 2, 4}, shift));
    write("meshed.ply", PlaneMesh(shift));
  }

  // Fuses both drawings with dense results of this kind. What the far run prints.
  std::string Fuse(const std::string& type, const std::string& path) {
    std::string out;
    for (const std::string folder : {"near", "far"}) {
      const LimnRun run =
          RunLimn({"drawing_fuser", "--input_path", (dir_ / folder / "sparse").string(),
                   "--image_path", LIMN_SAMPLE_DIR "/day/images", "--drawing_path",
                   (dir_ / folder / "drawing.json").string(), "--output_path",
                   Output(folder, "").string(), "--dense_type", type, "--dense_path",
                   (dir_ / folder / path).string(), "--max_image_size", "160"});
      EXPECT_EQ(run.exit_code, 0) << run.err;
      out = run.out;
    }
    return out;
  }

  fs::path Output(const std::string& folder, const std::string& name) const {
    return dir_ / (folder + "-out") / name;
  }

  // The classes are those of the near drawing; no coordinate has changed.
  void ExpectSameClasses() const {
    ExpectPlaneClasses(Output("near", "drawing-fused.json"));
    ExpectPlaneClasses(Output("far", "drawing-fused.json"));
    const DrawingGraph near = ReadDrawingJson(Output("near", "drawing-fused.json").string()).graph;
    const DrawingGraph far = ReadDrawingJson(Output("far", "drawing-fused.json").string()).graph;
    const DrawingGraph drawn = PlaneDrawing(shift_);
    ASSERT_EQ(far.links.size(), drawn.links.size());
    ASSERT_EQ(near.links.size(), drawn.links.size());
    for (size_t i = 0; i < far.links.size(); ++i) {
      EXPECT_EQ(far.links[i].points_in_world, drawn.links[i].points_in_world);
      EXPECT_EQ(near.links[i].points_in_world, PlaneDrawing().links[i].points_in_world);
      ASSERT_TRUE(far.links[i].dense && near.links[i].dense);
      EXPECT_EQ(far.links[i].dense->dense_class, near.links[i].dense->dense_class);
      EXPECT_NEAR(far.links[i].dense->added_share, near.links[i].dense->added_share, 1e-6);
      EXPECT_NEAR(far.links[i].dense->occluded_share, near.links[i].dense->occluded_share, 1e-6);
    }
  }

  // The same points of curves as near the origin, all moved.
  void ExpectSparseModelMoved() const {
    const auto near = colmap_ext::ReadModel(Output("near", "sparse-with-curves"));
    const auto far = colmap_ext::ReadModel(Output("far", "sparse-with-curves"));
    EXPECT_EQ(far.rigs.size(), 1u);
    EXPECT_EQ(far.frames.size(), far.images.size());
    EXPECT_TRUE(far.warnings.empty());
    ASSERT_GT(near.points.size(), 60u + 10);  // the model has 60
    ASSERT_EQ(far.points.size(), near.points.size());
    for (size_t i = 0; i < far.points.size(); ++i) {
      EXPECT_LT((near.points[i].position + shift_ - far.points[i].position).norm(), 1e-6);
      EXPECT_EQ(near.points[i].track.size(), far.points[i].track.size());
      EXPECT_EQ(near.points[i].color, far.points[i].color);
    }
  }

  TempDir dir_;
  const Eigen::Vector3d shift_{5e5, 4e6, 100};
};

TEST_F(GeoFusion, DepthMaps) {
  EXPECT_THAT(Fuse("depth_maps", "stereo"), HasSubstr("working around (500000, 4000000, 100)"));
  ExpectSameClasses();
  ExpectSparseModelMoved();
}

TEST_F(GeoFusion, CloudInDoublePrecision) {
  EXPECT_THAT(Fuse("fused", "double.ply"), HasSubstr("positions have steps of 0.25"));
  ExpectSameClasses();
  ExpectSparseModelMoved();
}

TEST_F(GeoFusion, Patches) {
  Fuse("pmvs", "pmvs/models/option.patch");
  ExpectSameClasses();
  ExpectSparseModelMoved();
  std::vector<Eigen::Vector3d> near;
  const auto read = [&](const std::string& folder, const auto& visit) {
    colmap_ext::ReadPatchFile(Output(folder, "pmvs-with-curves.patch").string(), visit);
  };
  read("near", [&](const colmap_ext::Patch& patch) { near.push_back(patch.position); });
  EXPECT_GT(near.size(), PlanePoints().size());
  size_t index = 0;
  read("far", [&](const colmap_ext::Patch& patch) {
    ASSERT_LT(index, near.size());
    EXPECT_LT((near[index++] + shift_ - patch.position).norm(), 1e-6);
  });
  EXPECT_EQ(index, near.size());
}

TEST_F(GeoFusion, Mesh) {
  Fuse("mesh", "meshed.ply");
  ExpectSameClasses();
  ExpectSparseModelMoved();
}

}  // namespace
}  // namespace limn::testing
