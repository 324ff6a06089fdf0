// SPDX-License-Identifier: BSD-3-Clause
// All commands on eight small images of the sample scene.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/read_curves.h"
#include "limn/model/link_selection.h"
#include "limn/viewer/viewer_page.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class SmallRun : public ::testing::Test {
 protected:
  SmallRun() {
    std::string names;
    for (int i = 0; i < 8; ++i) names += "view_0" + std::to_string(i) + ".jpg\n";
    list_ = dir_.WriteFile("list.txt", names);
  }

  // What it prints.
  std::string Run(const std::string& command, const std::string& output,
                  const std::vector<std::string>& more = {}) const {
    return RunIn(LIMN_SAMPLE_DIR "/day", command, output, more);
  }

  std::string RunIn(const fs::path& workspace, const std::string& command,
                    const std::string& output, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {command,
                                          "--workspace_path",
                                          workspace.string(),
                                          "--output_path",
                                          (dir_ / output).string(),
                                          "--image_list_path",
                                          list_,
                                          "--quality",
                                          "low",
                                          "--max_image_size",
                                          "320"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const LimnRun run = RunLimn(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    return run.out;
  }

  fs::path Output(const std::string& output, const std::string& name) const {
    return dir_ / output / name;
  }

  TempDir dir_;
  std::string list_;
};

// All outputs but the options of the run, which name threads and paths.
std::map<std::string, std::string> Results(const fs::path& folder) {
  auto files = ReadTree(folder);
  EXPECT_EQ(files.erase("curves/project.ini"), 1u);
  files.erase("drawing.html");  // its report has times
  return files;
}

// Mean over the links of a drawing.
double ResidualPx(const std::string& path) {
  const DrawingGraph graph = ReadDrawingJson(path).graph;
  double sum = 0;
  for (const DrawingLink& link : graph.links) sum += link.residual_px;
  return sum / static_cast<double>(graph.links.size());
}

TEST_F(SmallRun, AutomaticDrawerWritesEverything) {
  EXPECT_THAT(
      Run("automatic_drawer", "out"),
      HasSubstr("8 images are shrunk to 320 px, finer detail is not drawn: --max_image_size "
                "-1 uses all of their pixels, 4.0 times as many"));
  for (const char* name :
       {"drawing.ply", "drawing.json", "drawing.obj", "curves/swept-sketch.bin",
        "curves/swept-sketch.ply", "curves/tracks.txt", "curves/overlays/view_03.jpg.png",
        "curves/cache/fragments/view_03.jpg.bin"}) {
    EXPECT_TRUE(fs::exists(Output("out", name))) << name;
  }

  // ReadDrawingJson validates the graph.
  const DrawingFile drawing = ReadDrawingJson(Output("out", "drawing.json").string());
  EXPECT_GT(drawing.graph.links.size(), 20u);
  EXPECT_EQ(drawing.metadata.view_names.size(), 8u);
  // Without outlines of smooth bodies and tentative links.
  const size_t num_exported = Selected(drawing.graph, {}).links.size();
  for (const char* name : {"drawing.ply", "drawing.obj"}) {
    EXPECT_EQ(ReadCurves(Output("out", name).string()).polylines.size(), num_exported) << name;
  }
}

TEST_F(SmallRun, ProjectFileRepeatsTheRun) {
  Run("automatic_drawer", "first");
  const LimnRun again =
      RunLimn({"automatic_drawer", "--project_path", Output("first", "curves/project.ini").string(),
               "--output_path", (dir_ / "again").string()});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(Results(dir_ / "again"), Results(dir_ / "first"));
}

TEST_F(SmallRun, StepByStepGivesTheSameDrawing) {
  Run("automatic_drawer", "automatic");
  Run("edge_extractor", "steps");
  Run("curve_linker", "steps");
  Run("curve_sketcher", "steps");
  Run("curve_drawer", "steps");
  Run("drawing_refiner", "steps");
  EXPECT_GT(fs::remove_all(Output("steps", "curves/cache/edges")), 8u);
  // For updates, which only the main job does.
  EXPECT_EQ(fs::remove_all(Output("automatic", "curves/cache/scene")), 2u);
  EXPECT_TRUE(ReadTree(dir_ / "steps") == Results(dir_ / "automatic"));
}

TEST_F(SmallRun, RefinedCamerasAreAModelOfTheirOwn) {
  const std::vector<std::string> refine = {"--refine_cameras", "1"};
  Run("automatic_drawer", "out", refine);
  for (const char* name : {"refined/cameras.bin", "refined/images.bin", "refined/points3D.bin"}) {
    EXPECT_TRUE(fs::exists(Output("out", name))) << name;
  }
  const colmap_ext::SparseModel given = colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
  const colmap_ext::SparseModel refined = colmap_ext::ReadModel(dir_ / "out/refined");
  ASSERT_EQ(refined.images.size(), given.images.size());
  EXPECT_EQ(refined.points.size(), given.points.size());
  // The given poses are exact; images of 320 px do not tell better than a few mm at 3 m.
  for (size_t i = 0; i < given.images.size(); ++i) {
    const auto& before = given.images[i].cam_from_world;
    const auto& after = refined.images[i].cam_from_world;
    EXPECT_LT((before.translation - after.translation).norm(), 0.02);
    const bool is_view = given.images[i].name < "view_08";
    EXPECT_EQ(before.translation != after.translation, is_view) << given.images[i].name;
  }
  // The share of the cameras is in both.
  for (const DrawingLink& link :
       ReadDrawingJson(Output("out", "drawing.json").string()).graph.links) {
    if (link.depth_sigma < 0) continue;
    EXPECT_GT(link.depth_sigma, 0.999 * *std::ranges::min_element(link.sigma));
  }
  const LimnRun refused =
      RunLimn({"automatic_drawer", "--input_path", (dir_ / "out/refined").string(), "--image_path",
               LIMN_SAMPLE_DIR "/day/images", "--output_path", (dir_ / "out").string(),
               "--image_list_path", list_, "--refine_cameras", "1"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("refine_cameras = 1: "));
}

// The first two images as those of one frame of a rig, the others of frames of their own.
colmap_ext::SparseModel WithRig(colmap_ext::SparseModel model) {
  using namespace colmap_ext;
  model.cameras.push_back(model.cameras.front());
  model.cameras.back().id = 2;
  const auto find = [&](const std::string& name) -> ModelImage& {
    return *std::find_if(model.images.begin(), model.images.end(),
                         [&](const ModelImage& image) { return image.name == name; });
  };
  const ModelImage& left = find("view_00.jpg");
  ModelImage& right = find("view_01.jpg");
  right.camera_id = 2;
  const Rigid3d right_from_left = right.cam_from_world * Inverse(left.cam_from_world);
  model.rigs = {{1, {{{kCameraSensor, 1}, true, {}}, {{kCameraSensor, 2}, true, right_from_left}}}};
  for (const ModelImage& image : model.images) {
    if (&image == &right) continue;
    Frame frame = {image.id, 1, image.cam_from_world, {{{kCameraSensor, 1}, image.id}}};
    if (&image == &left) frame.data.push_back({{kCameraSensor, 2}, right.id});
    model.frames.push_back(frame);
  }
  return model;
}

TEST_F(SmallRun, RefinedCamerasKeepTheirRig) {
  const colmap_ext::SparseModel plain = colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
  const colmap_ext::SparseModel given = WithRig(plain);
  for (const auto& [name, model] : {std::pair("plain", &plain), {"rigged", &given}}) {
    fs::create_directories(dir_ / name);
    colmap_ext::WriteModelBinary(*model, dir_ / name);
  }
  const auto run = [&](const std::string& model) {
    return Run("automatic_drawer", "out",
               {"--refine_cameras", "1", "--input_path", (dir_ / model).string(), "--image_path",
                LIMN_SAMPLE_DIR "/day/images", "--overwrite", "1"});
  };
  run("rigged");
  const colmap_ext::SparseModel refined = colmap_ext::ReadModel(dir_ / "out/refined");
  EXPECT_TRUE(refined.warnings.empty());
  ASSERT_EQ(refined.rigs.size(), 1u);
  ASSERT_EQ(refined.frames.size(), given.frames.size());
  EXPECT_EQ(refined.frames.front().data.size(), given.frames.front().data.size());
  const auto translation = [](const colmap_ext::SparseModel& model) {
    return model.rigs[0].sensors[1].sensor_from_rig.translation;
  };
  // The scale of the whole is that of all given poses.
  EXPECT_LT((translation(refined) - translation(given)).norm(), 0.01 * translation(given).norm());
  // A model without rigs leaves none behind.
  run("plain");
  EXPECT_FALSE(fs::exists(Output("out", "refined/rigs.bin")));
  EXPECT_FALSE(fs::exists(Output("out", "refined/frames.bin")));
}

// Frames of two cameras with the same center, the right one upside down: view_00.jpg and
// turned_00.png, and so on. The right photographs are moved by `shift_px` to the right in even
// frames, and to the left in odd ones, which no rig explains.
void WriteTurnedRig(int num_frames, int shift_px, const fs::path& folder) {
  using namespace colmap_ext;
  SparseModel model = ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
  std::sort(model.images.begin(), model.images.end(),
            [](const ModelImage& a, const ModelImage& b) { return a.name < b.name; });
  model.images.resize(num_frames);
  const auto width = static_cast<double>(model.cameras[0].width);
  const auto height = static_cast<double>(model.cameras[0].height);
  Camera turned = model.cameras[0];
  turned.id = 2;
  turned.params[2] = width - turned.params[2];
  turned.params[3] = height - turned.params[3];
  model.cameras.push_back(turned);
  const Rigid3d half_turn = {Eigen::Quaterniond(0, 0, 0, 1), Eigen::Vector3d::Zero()};
  const SensorId left = {kCameraSensor, 1}, right = {kCameraSensor, 2};
  model.rigs = {{1, {{left, true, {}}, {right, true, half_turn}}}};
  fs::create_directories(folder / "images");
  for (int f = 0; f < num_frames; ++f) {
    const double shift = f % 2 == 0 ? shift_px : -shift_px;
    ModelImage image = model.images[f];
    const cv::Mat photo = cv::imread(LIMN_SAMPLE_DIR "/day/images/" + image.name);
    cv::imwrite((folder / "images" / image.name).string(), photo);
    model.frames.push_back(
        {image.id, 1, image.cam_from_world, {{left, image.id}, {right, 100 + image.id}}});
    image.id += 100;
    image.camera_id = 2;
    image.name = "turned_" + image.name.substr(5, 2) + ".png";
    image.cam_from_world = half_turn * image.cam_from_world;
    for (Observation& observation : image.observations) {
      observation.position = Eigen::Vector2d(width + shift, height) - observation.position;
    }
    cv::Mat turned_photo;
    const cv::Matx23d map(-1, 0, width - 1 + shift, 0, -1, height - 1);
    cv::warpAffine(photo, turned_photo, map, photo.size(), cv::INTER_NEAREST, cv::BORDER_REPLICATE);
    cv::imwrite((folder / "images" / image.name).string(), turned_photo);
    model.images.push_back(image);
  }
  for (ModelPoint& point : model.points) {
    std::erase_if(point.track, [&](const TrackElement& element) {
      return std::none_of(model.frames.begin(), model.frames.end(),
                          [&](const Frame& frame) { return frame.id == element.image_id; });
    });
    const std::vector<TrackElement> of_left = point.track;
    for (const TrackElement& element : of_left) {
      point.track.push_back({element.image_id + 100, element.observation});
    }
  }
  fs::create_directories(folder / "sparse");
  WriteModelBinary(model, folder / "sparse");
}

// Even where the photographs would rather have it otherwise.
TEST_F(SmallRun, ImagesOfAFrameStayTogether) {
  constexpr int kNumFrames = 6;
  WriteTurnedRig(kNumFrames, 4, dir_ / "turned");
  const LimnRun run =
      RunLimn({"automatic_drawer", "--workspace_path", (dir_ / "turned").string(), "--quality",
               "low", "--max_image_size", "320", "--page", "0", "--refine_cameras", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto given = colmap_ext::ReadModel(dir_ / "turned/sparse");
  const auto refined = colmap_ext::ReadModel(dir_ / "turned/refined");
  EXPECT_TRUE(refined.warnings.empty());
  EXPECT_EQ(refined.frames.size(), size_t{kNumFrames});
  EXPECT_NE(refined.images[0].cam_from_world.translation,
            given.images[0].cam_from_world.translation);
  for (int f = 0; f < kNumFrames; ++f) {
    const Rigid3d right_from_left =
        refined.images[kNumFrames + f].cam_from_world * Inverse(refined.images[f].cam_from_world);
    EXPECT_LT(right_from_left.translation.norm(), 1e-6);
  }
}

// Cameras that are a pixel off.
colmap_ext::SparseModel WithTurns(colmap_ext::SparseModel model) {
  for (size_t i = 0; i < model.images.size(); ++i) {
    Rigid3d turn;
    turn.rotation = Eigen::AngleAxisd(i % 2 == 0 ? 0.003 : -0.003, Eigen::Vector3d::UnitX());
    model.images[i].cam_from_world = turn * model.images[i].cam_from_world;
  }
  return model;
}

// The drawing fits the refined model that was written, and not the
// one that was read.
TEST_F(SmallRun, DrawingFitsTheRefinedModel) {
  const auto model = WithTurns(colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse"));
  fs::create_directories(dir_ / "wrong");
  colmap_ext::WriteModelText(model, dir_ / "wrong");
  const auto with_model = [&](const std::string& folder, std::vector<std::string> more) {
    more.insert(more.end(), {"--input_path", (dir_ / folder).string(), "--image_path",
                             LIMN_SAMPLE_DIR "/day/images"});
    return more;
  };
  Run("automatic_drawer", "out", with_model("wrong", {"--refine_cameras", "1"}));
  const std::string drawing = Output("out", "drawing.json").string();
  const auto residual_px = [&](const std::string& output, const std::string& folder) {
    Run("drawing_refiner", output, with_model(folder, {"--drawing_path", drawing}));
    return ResidualPx(Output(output, "drawing.json").string());
  };
  const double before = residual_px("before", "wrong");
  const double after = residual_px("after", "out/refined");
  EXPECT_LT(after, 0.8 * before);
  EXPECT_NEAR(after, ResidualPx(drawing), 0.1 * after);
}

// A workspace with the photographs of the sample scene and cameras that are a pixel off.
fs::path WrongWorkspace(const TempDir& dir) {
  const auto model = WithTurns(colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse"));
  fs::create_directories(dir / "wrong/sparse");
  colmap_ext::WriteModelBinary(model, dir / "wrong/sparse");
  fs::create_directory_symlink(LIMN_SAMPLE_DIR "/day/images", dir / "wrong/images");
  return dir / "wrong";
}

TEST_F(SmallRun, CommandsThatContinueTakeTheRefinedCameras) {
  const fs::path wrong = WrongWorkspace(dir_);
  const auto run = [&](const std::string& command, std::vector<std::string> more = {},
                       const std::string& output = "out") {
    more.insert(more.end(), {"--overwrite", "1"});
    return RunIn(wrong, command, output, more);
  };
  const std::vector<std::string> by_hand = {"--input_path", (dir_ / "out/refined").string()};
  run("automatic_drawer", {"--refine_cameras", "1"});
  const double residual_px = ResidualPx(Output("out", "drawing.json").string());
  const std::string note = "fits, " + (dir_ / "out/refined").string() + "\n";
  for (const char* command : {"drawing_viewer", "curve_drawer", "drawing_refiner"}) {
    // The page has the name of the folder.
    const std::string copy = std::string(command) + "/out";
    fs::create_directories(dir_ / command);
    fs::copy(dir_ / "out", dir_ / copy, fs::copy_options::recursive);
    EXPECT_THAT(run(command), HasSubstr(note)) << command;
    EXPECT_THAT(run(command, by_hand, copy), Not(HasSubstr("fits"))) << command;
    EXPECT_TRUE(ReadTree(dir_ / "out") == ReadTree(dir_ / copy)) << command;
  }
  const LimnRun exported =
      RunLimn({"drawing_exporter", "--workspace_path", wrong.string(), "--input_path",
               Output("out", "drawing.json").string(), "--view", "view_03.jpg", "--output_path",
               Output("out", "view.svg").string()});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  EXPECT_THAT(exported.out, HasSubstr(note));
  // Sketches are made before the last step of the cameras, and curve_drawer has begun with it
  // again.
  EXPECT_NEAR(ResidualPx(Output("out", "drawing.json").string()), residual_px, 0.2 * residual_px);
  EXPECT_THAT(run("drawing_viewer", {"--input_path", (wrong / "sparse").string()}),
              HasSubstr("fits refined cameras, not those of this model: --input_path " +
                        (dir_ / "out/refined").string()));
  // A sketch of the given cameras, and its drawing.
  EXPECT_THAT(run("curve_sketcher"), Not(HasSubstr(note)));
  EXPECT_THAT(run("curve_drawer"), Not(HasSubstr(note)));
  EXPECT_FALSE(fs::exists(Output("out", "refined")));
}

// The two numbers in what it says about a drawing that fits the given cameras: residuals, px.
std::pair<double, double> ResidualsInGiven(const std::string& log) {
  std::smatch numbers;
  const std::regex line(
      R"(its curves are (\S+) px off their edges in the images of these \(median\), of (\S+) px)");
  EXPECT_TRUE(std::regex_search(log, numbers, line)) << log;
  if (numbers.size() != 3) return {0, 0};
  return {std::stod(numbers[1]), std::stod(numbers[2])};
}

TEST_F(SmallRun, DrawingMayFitTheGivenCameras) {
  const fs::path wrong = WrongWorkspace(dir_);
  const auto draw = [&](const std::string& output, const std::string& output_cameras) {
    return RunIn(wrong, "automatic_drawer", output,
                 {"--refine_cameras", "1", "--output_cameras", output_cameras});
  };
  draw("refined", "refined");
  fs::copy(dir_ / "refined", dir_ / "given", fs::copy_options::recursive);
  const auto [residual_px, before_px] = ResidualsInGiven(draw("given", "given"));
  EXPECT_LT(residual_px, 0.9 * before_px);
  const std::string drawing = Output("given", "drawing.json").string();
  const std::string refined_drawing = Output("refined", "drawing.json").string();
  EXPECT_GT(ResidualPx(drawing), ResidualPx(refined_drawing));
  EXPECT_NE(RefinedCamerasOfDrawing(refined_drawing), "");
  EXPECT_EQ(RefinedCamerasOfDrawing(drawing), "");

  // The same curves, elsewhere.
  const DrawingGraph graph = ReadDrawingJson(drawing).graph;
  const DrawingGraph refined = ReadDrawingJson(refined_drawing).graph;
  ASSERT_EQ(graph.links.size(), refined.links.size());
  size_t num_unmoved = 0;  // too few views show them
  for (size_t l = 0; l < graph.links.size(); ++l) {
    num_unmoved += graph.links[l].points_in_world == refined.links[l].points_in_world;
    EXPECT_EQ(graph.links[l].supporting_views, refined.links[l].supporting_views) << l;
    EXPECT_EQ(graph.links[l].kind, refined.links[l].kind) << l;
    EXPECT_EQ(graph.links[l].tentative, refined.links[l].tentative) << l;
  }
  EXPECT_LT(num_unmoved, graph.links.size() / 10);
  // Cameras and sketch are the same, too.
  EXPECT_TRUE(ReadTree(dir_ / "given/refined") == ReadTree(dir_ / "refined/refined"));
  for (const char* name : {"curves/cameras.csv", "curves/swept-sketch.bin"}) {
    EXPECT_EQ(ReadTree(dir_ / "given").at(name), ReadTree(dir_ / "refined").at(name)) << name;
  }
}

TEST_F(SmallRun, CommandsThatContinueTakeTheGivenCamerasThatADrawingFits) {
  const fs::path wrong = WrongWorkspace(dir_);
  RunIn(wrong, "automatic_drawer", "out", {"--refine_cameras", "1", "--output_cameras", "given"});
  for (const char* command : {"drawing_viewer", "drawing_refiner"}) {
    const std::string log = RunIn(wrong, command, "out", {"--overwrite", "1"});
    EXPECT_THAT(log, HasSubstr("Model " + (wrong / "sparse").string())) << command;
    EXPECT_THAT(log, Not(HasSubstr("refined"))) << command;
  }
  // Without refined cameras those of the earlier drawing go.
  RunIn(wrong, "automatic_drawer", "out", {"--refine_cameras", "0", "--overwrite", "1"});
  EXPECT_FALSE(fs::exists(Output("out", "refined")));
  EXPECT_FALSE(fs::exists(Output("out", "curves/cameras.csv")));
}

TEST_F(SmallRun, OutputCamerasDoNotMatterIfCamerasStay) {
  Run("automatic_drawer", "refined");
  EXPECT_THAT(Run("automatic_drawer", "given", {"--output_cameras", "given"}),
              HasSubstr("Cameras are left as they are"));
  EXPECT_TRUE(Results(dir_ / "given") == Results(dir_ / "refined"));
}

TEST_F(SmallRun, CameraRefinerWritesTheModelAlone) {
  const fs::path wrong = WrongWorkspace(dir_);
  RunIn(wrong, "automatic_drawer", "out", {"--refine_cameras", "1"});
  RunIn(wrong, "camera_refiner", "cameras", {"--refine_cameras", "1"});
  EXPECT_TRUE(ReadTree(dir_ / "out/refined") == ReadTree(dir_ / "cameras/refined"));
  EXPECT_EQ(ReadTree(dir_ / "out/curves").at("cameras.csv"),
            ReadTree(dir_ / "cameras/curves").at("cameras.csv"));
  EXPECT_FALSE(fs::exists(Output("cameras", "drawing.json")));
}

TEST_F(SmallRun, CameraRefinerLeavesGoodCameras) {
  EXPECT_THAT(Run("camera_refiner", "out"), HasSubstr("Cameras are left as they are"));
  const colmap_ext::SparseModel given = colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
  const colmap_ext::SparseModel left = colmap_ext::ReadModel(Output("out", "refined"));
  ASSERT_EQ(given.images.size(), left.images.size());
  for (size_t i = 0; i < given.images.size(); ++i) {
    EXPECT_EQ(given.images[i].cam_from_world.translation,
              left.images[i].cam_from_world.translation);
  }
  EXPECT_FALSE(fs::exists(Output("out", "curves/cameras.csv")));
}

TEST_F(SmallRun, HeldImagesKeepTheirPoses) {
  const fs::path wrong = WrongWorkspace(dir_);
  const std::string held = dir_.WriteFile("held.txt", "view_02.jpg\nview_05.jpg\n");
  RunIn(wrong, "automatic_drawer", "out", {"--refine_cameras", "1", "--hold_images", held});
  const colmap_ext::SparseModel given = colmap_ext::ReadModel(wrong / "sparse");
  const colmap_ext::SparseModel refined = colmap_ext::ReadModel(dir_ / "out/refined");
  for (size_t i = 0; i < given.images.size(); ++i) {
    const std::string& name = given.images[i].name;
    const bool moves = name < "view_08" && name != "view_02.jpg" && name != "view_05.jpg";
    const Rigid3d& before = given.images[i].cam_from_world;
    const Rigid3d& after = refined.images[i].cam_from_world;
    EXPECT_EQ(before.translation != after.translation, moves) << name;
    // Quaternions are normalized on reading.
    EXPECT_EQ(before.rotation.angularDistance(after.rotation) > 1e-15, moves) << name;
  }
  // The others go with them: the drawing fits what was written.
  const double residual_px = ResidualPx(Output("out", "drawing.json").string());
  RunIn(wrong, "drawing_refiner", "out");
  EXPECT_NEAR(ResidualPx(Output("out", "drawing.json").string()), residual_px, 0.1 * residual_px);
}

TEST_F(SmallRun, WithoutRefinedCamerasNoModelIsLeft) {
  EXPECT_THAT(Run("automatic_drawer", "out"), Not(HasSubstr("refined")));
  EXPECT_FALSE(fs::exists(Output("out", "refined")));
  EXPECT_THAT(Run("automatic_drawer", "out", {"--refine_cameras", "1", "--overwrite", "1"}),
              HasSubstr("Cameras refined: "));
  EXPECT_TRUE(fs::exists(Output("out", "refined/images.bin")));
  EXPECT_TRUE(fs::exists(Output("out", "curves/cameras.csv")));
  EXPECT_THAT(Run("automatic_drawer", "out", {"--overwrite", "1"}), Not(HasSubstr("refined")));
  EXPECT_FALSE(fs::exists(Output("out", "refined")));
  EXPECT_FALSE(fs::exists(Output("out", "curves/cameras.csv")));
  EXPECT_THAT(Run("drawing_refiner", "out"), HasSubstr("day/sparse"));
}

TEST_F(SmallRun, ChangedRefinedCamerasAreNotRemoved) {
  Run("automatic_drawer", "out", {"--refine_cameras", "1"});
  std::ofstream(Output("out", "refined/images.bin"), std::ios::app) << " ";
  EXPECT_THAT(Run("automatic_drawer", "out", {"--overwrite", "1"}),
              HasSubstr("do not belong to this drawing"));
  EXPECT_TRUE(fs::exists(Output("out", "refined/images.bin")));
  EXPECT_FALSE(fs::exists(Output("out", "refined/cameras.bin")));
}

TEST_F(SmallRun, RefinedCamerasDoNotGoBesideOtherModelFiles) {
  for (const char* name : {"images.bin", "images.txt", "rigs.bin", "frames.txt"}) {
    const std::string output = std::string("beside ") + name;
    fs::create_directories(Output(output, "refined"));
    std::ofstream(Output(output, "refined") / name) << "0";
    const LimnRun refused =
        RunLimn({"automatic_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day", "--output_path",
                 (dir_ / output).string(), "--image_list_path", list_, "--refine_cameras", "1"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_THAT(refused.err, HasSubstr(name));
    EXPECT_THAT(refused.err, HasSubstr("--overwrite 1 replaces it"));
  }
}

TEST_F(SmallRun, CurveDrawerRefusesASketchOfOtherCurves) {
  Run("curve_sketcher", "out");
  const LimnRun run = RunLimn({"curve_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day",
                               "--output_path", (dir_ / "out").string(), "--image_list_path", list_,
                               "--quality", "low", "--max_image_size", "300"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, HasSubstr("curve_sketcher"));
  EXPECT_FALSE(fs::exists(Output("out", "drawing.ply")));
}

TEST_F(SmallRun, OriginalSketch) {
  Run("curve_sketcher", "out", {"--mode", "original"});
  EXPECT_GT(ReadCurves(Output("out", "curves/sketch.ply").string()).polylines.size(), 20u);
  EXPECT_TRUE(fs::exists(Output("out", "curves/sketch.bin")));
  EXPECT_FALSE(fs::exists(Output("out", "curves/swept-sketch.bin")));
}

TEST_F(SmallRun, AccountTellsWhatBecameOfEveryEdgel) {
  Run("automatic_drawer", "out", {"--account", "1"});
  EXPECT_TRUE(fs::exists(Output("out", "curves/account/view_03.jpg.png")));
  std::ifstream csv(Output("out", "curves/account.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 1u + 8u + 1u);  // header, views, all
  EXPECT_THAT(lines.back(), StartsWith("all,"));

  const LimnRun refused = RunLimn({"automatic_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day",
                                   "--mode", "original", "--account", "1"});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, StartsWith("ERROR: account = 1: "));
}

TEST_F(SmallRun, ThePaperAlone) {
  const std::string said = Run("automatic_drawer", "out",
                               {"--project_path", LIMN_SOURCE_DIR "/scripts/paper.ini",
                                "--Sketch.min_supporting_views", "3", "--log_level", "2"});
  EXPECT_THAT(said, HasSubstr("enhanced sketch"));
  EXPECT_THAT(said, HasSubstr("averaging rounds"));
  for (const char* ours : {"re-triangulation", "ends continued",
                           "refinement:", "belief:", "primitives:", "kinds of"}) {
    EXPECT_THAT(said, Not(HasSubstr(ours)));
  }
  const DrawingGraph graph = ReadDrawingJson(Output("out", "drawing.json").string()).graph;
  EXPECT_GT(graph.links.size(), 10u);
}

TEST_F(SmallRun, PageHoldsAReportOfTheRun) {
  const std::string truth = std::string(LIMN_SAMPLE_DIR) + "/truth/curves-visible.ply";
  if (!HasViewerPage()) GTEST_SKIP() << "built without the viewer";
  Run("automatic_drawer", "out",
      {"--truth_path", truth, "--taus", "2,4", "--unit", "footprint",
       "--Drawing.min_link_length_px", "7.5"});
  const LimnRun page =
      RunProgram("/usr/bin/python3", {LIMN_SOURCE_DIR "/tests/scripts/readers/read_page.py",
                                      Output("out", "drawing.html").string()});
  ASSERT_EQ(page.exit_code, 0) << page.err;
  const auto report = nlohmann::json::parse(page.out).at("report");
  std::vector<std::string> stages;
  for (const auto& stage : report.at("stages")) {
    stages.push_back(stage.at("stage"));
    EXPECT_GT(stage.at("peak_mb").get<int>(), 0);
  }
  EXPECT_THAT(stages,
              ::testing::ElementsAre("image curves", "swept sketch", "drawing", "refinement",
                                     "belief", "rods", "outlines of smooth bodies", "primitives",
                                     "kinds of edges", "texture", "short curves"));
  EXPECT_EQ(report.at("options_changed").at("Drawing.min_link_length_px"), 7.5);
  const DrawingGraph graph = ReadDrawingJson(Output("out", "drawing.json").string()).graph;
  int num_with_depth = 0;
  for (const DrawingLink& link : graph.links) {
    EXPECT_EQ(link.tri_angle_deg >= 0, link.supporting_views.size() >= 2);
    EXPECT_TRUE(link.tri_angle_deg >= 0 || link.depth_sigma == -1);
    num_with_depth += link.depth_sigma > 0;
    EXPECT_GT(link.curve_px, 0);
  }
  EXPECT_GT(num_with_depth, static_cast<int>(graph.links.size()) / 2);
  int num_links = 0;
  for (const int count : report.at("support_histogram")) num_links += count;
  EXPECT_EQ(num_links, static_cast<int>(graph.links.size()));
  const auto& trust = report.at("trust");
  EXPECT_EQ(trust.at("images"), 8);
  EXPECT_GT(trust.at("explained").get<double>(), 0.02);
  EXPECT_TRUE(trust.at("agree_less").empty());
  EXPECT_GT(trust.at("well_seen").get<double>(), 0.1);
  EXPECT_LE(trust.at("well_seen").get<double>(), 1);
  EXPECT_GT(trust.at("error_px").get<double>(), 0);
  EXPECT_GT(trust.at("error_90_px").get<double>(), trust.at("error_px").get<double>());
  EXPECT_GE(trust.at("tentative").get<double>(), 0);
  EXPECT_LT(trust.at("tentative").get<double>(), 0.5);
  EXPECT_LE(trust.at("unmeasured").get<double>(), trust.at("tentative").get<double>());
  EXPECT_LT(trust.at("still").get<double>(), 0.1);
  ASSERT_EQ(report.at("evaluation").size(), 2u);
  EXPECT_GT(report.at("evaluation")[0].at("precision").get<double>(), 0.3);
  EXPECT_EQ(report.at("pr_curves").size(), 2u);
  EXPECT_GT(report.at("pr_curves")[0].at("points").size(), 2u);

  Run("automatic_drawer", "without", {"--page", "0"});
  EXPECT_FALSE(fs::exists(Output("without", "drawing.html")));
}

TEST_F(SmallRun, EveryModeDraws) {
  for (const char* mode : {"original", "enhanced", "sweep"}) {
    Run("automatic_drawer", mode, {"--mode", mode});
    EXPECT_GT(ReadDrawingJson(Output(mode, "drawing.json").string()).graph.links.size(), 20u)
        << mode;
  }
}

TEST_F(SmallRun, BoxLimitsTheDrawing) {
  Run("automatic_drawer", "out", {"--box=-0.5,0.5,-0.5,0.5,0.04,1.05"});
  const DrawingFile drawing = ReadDrawingJson(Output("out", "drawing.json").string());
  ASSERT_FALSE(drawing.graph.links.empty());
  // Averaging may move what lies on the border by a few pixel footprints (1 cm each).
  constexpr double kSlack = 0.03;
  for (const DrawingLink& link : drawing.graph.links) {
    for (const Eigen::Vector3d& point : link.points_in_world) {
      EXPECT_LT(std::max(std::abs(point.x()), std::abs(point.y())), 0.5 + kSlack);
      EXPECT_GT(point.z(), 0.04 - kSlack);
    }
  }
}

}  // namespace
}  // namespace limn::testing
