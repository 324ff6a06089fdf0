// SPDX-License-Identifier: BSD-3-Clause
// The same photographs give the same bytes, however many threads draw them and in whatever order,
// under whatever ids, the model lists them.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using colmap_ext::SparseModel;

constexpr int kNumImages = 8;

class Determinism : public ::testing::Test {
 protected:
  Determinism() {
    std::string names;
    for (int i = 0; i < kNumImages; ++i) names += "view_0" + std::to_string(i) + ".jpg\n";
    list_ = dir_.WriteFile("list.txt", names);
  }

  // What the main job makes of small images, cameras refined too: all its files, but those that
  // name threads, paths or times, and the refined model, which has the order and ids of the given
  // one.
  std::map<std::string, std::string> Draw(const std::string& output, const fs::path& model,
                                          int num_threads) const {
    const LimnRun run =
        RunLimn({"automatic_drawer", "--input_path", model.string(), "--image_path",
                 LIMN_SAMPLE_DIR "/day/images", "--image_list_path", list_, "--output_path",
                 (dir_ / output).string(), "--max_image_size", "320", "--quality", "low",
                 "--refine_cameras", "1", "--num_threads", std::to_string(num_threads)});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    auto files = ReadTree(dir_ / output);
    EXPECT_EQ(files.erase("curves/project.ini") + files.erase("drawing.html"), 2u);
    std::erase_if(files, [](const auto& file) { return file.first.starts_with("refined/"); });
    return files;
  }

  fs::path Write(const std::string& name, const SparseModel& model) const {
    fs::create_directories(dir_ / name);
    colmap_ext::WriteModelBinary(model, dir_ / name);
    return dir_ / name;
  }

  TempDir dir_;
  std::string list_;
};

void ExpectSameFiles(const std::map<std::string, std::string>& actual,
                     const std::map<std::string, std::string>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (const auto& [name, bytes] : expected) {
    EXPECT_TRUE(actual.contains(name) && actual.at(name) == bytes) << name << " differs";
  }
}

// The same model under other ids of cameras and images; cameras, images, points and the elements of
// tracks in another order.
SparseModel Shuffled(SparseModel model) {
  constexpr uint32_t kLastId = 1000;
  std::mt19937 random(1);
  for (colmap_ext::Camera& camera : model.cameras) camera.id = kLastId - camera.id;
  for (colmap_ext::ModelImage& image : model.images) {
    image.id = kLastId - image.id;
    image.camera_id = kLastId - image.camera_id;
  }
  for (colmap_ext::ModelPoint& point : model.points) {
    for (colmap_ext::TrackElement& element : point.track) {
      element.image_id = kLastId - element.image_id;
    }
    std::shuffle(point.track.begin(), point.track.end(), random);
  }
  std::shuffle(model.cameras.begin(), model.cameras.end(), random);
  std::shuffle(model.images.begin(), model.images.end(), random);
  std::shuffle(model.points.begin(), model.points.end(), random);
  return model;
}

TEST_F(Determinism, ThreadsDoNotMatter) {
  const fs::path model = LIMN_SAMPLE_DIR "/day/sparse";
  const auto one = Draw("one", model, 1);
  EXPECT_TRUE(one.contains("drawing.json"));
  ExpectSameFiles(Draw("two", model, 2), one);
  ExpectSameFiles(Draw("eight", model, 8), one);
}

// Both models are written here: reading normalizes rotations, which may change their last digit.
TEST_F(Determinism, OrderAndIdsOfTheModelDoNotMatter) {
  const SparseModel model = colmap_ext::ReadModel(LIMN_SAMPLE_DIR "/day/sparse");
  const auto in_order = Draw("in order", Write("model", model), 2);
  ExpectSameFiles(Draw("shuffled", Write("other model", Shuffled(model)), 2), in_order);
}

}  // namespace
}  // namespace limn::testing
