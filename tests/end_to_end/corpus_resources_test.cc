// SPDX-License-Identifier: BSD-3-Clause
// Several models and resources: cases 34 to 36 of tests/README.md.
#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "end_to_end/corpus_case.h"
#include "limn/files/atomic_file.h"
#include "limn/files/whole_file.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using W = CorpusWorkspace;

// sparse/0 and sparse/1 in other frames, dense/0 for the first of them.
void MakeTwoModels(const W& w) {
  colmap_ext::SparseModel model = w.Model();
  fs::remove_all(w / "sparse");
  w.WriteText(model, "sparse/1");
  model.images.resize(4);
  for (colmap_ext::ModelImage& image : model.images) image.cam_from_world.translation.x() += 50;
  w.WriteText(model, "sparse/0");
  w.WriteText(model, "dense/0/sparse");
  fs::copy(w / "images", w / "dense/0/images",
           fs::copy_options::recursive | fs::copy_options::copy_symlinks);
}

const CorpusCase kCases[] = {
    {.name = "Case34_DenseWithItsOwnModel",
     .spoil = MakeTwoModels,
     .outcome = Outcome::kAccepted,
     .said = {"dense/0/sparse (4 registered images), images in ", "dense/0/images, results to "}},
    {.name = "Case34_SparseWithTheRawImages",
     .spoil = MakeTwoModels,
     .outcome = Outcome::kAccepted,
     .said = {"sparse/1 (6 registered images), images in ", "project/images, results to "},
     .arguments = {"--model_index", "1"}},
};

class CorpusResources : public Corpus {};
TEST_P(CorpusResources, Is) { RunCase(); }
INSTANTIATE_TEST_SUITE_P(Section6, CorpusResources, ::testing::ValuesIn(kCases), NameOf);

RunConditions Limits(double max_seconds) {
  RunConditions conditions;
  conditions.max_memory_mb = 2048;
  conditions.max_seconds = max_seconds;
  return conditions;
}

TEST(CorpusRuns, Case35_ThousandsOfImages) {
  constexpr int kCount = 3000;
  const W w;
  colmap_ext::SparseModel model = w.Model();
  const colmap_ext::ModelImage first = model.images[0];
  model.images.clear();
  model.points.clear();
  model.cameras[0].width = 64;
  model.cameras[0].height = 48;
  model.cameras[0].params = {64, 64, 32, 24};
  fs::remove_all(w / "images");
  fs::create_directories(w / "images");
  cv::Mat pixels(48, 64, CV_8U, cv::Scalar(50));
  pixels.colRange(20, 40) = 200;
  for (int i = 0; i < kCount; ++i) {
    colmap_ext::ModelImage image = first;
    image.id = static_cast<uint32_t>(i + 1);
    image.name = std::to_string(i) + ".png";
    image.observations.clear();
    image.cam_from_world.translation.x() = i;
    // No two alike.
    pixels.at<uchar>(0, 0) = static_cast<uchar>(i % 256);
    pixels.at<uchar>(0, 1) = static_cast<uchar>(i / 256);
    ASSERT_TRUE(cv::imwrite((w / "images" / image.name).string(), pixels));
    model.images.push_back(image);
  }
  w.WriteBinary(model);
  const LimnRun run = RunLimn(
      {"edge_extractor", "--workspace_path", w.path().string(), "--num_threads", "2"}, Limits(300));
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("3000 images, 0 3D points"));
}

// Files of 100 GB without content, and memory that is too small.
TEST(CorpusRuns, Case35_EmptyGigabytesAreNotRead) {
  const W w;
  for (const char* file : {"a.json", "a.ini", "a.txt", "a.ply"}) {
    w.Write(file, "");
    fs::resize_file(w / file, uintmax_t{100} << 30);
  }
  const auto path = [&](const char* file) { return (w / file).string(); };
  const std::vector<std::vector<std::string>> runs = {
      {"drawing_exporter", "--input_path", path("a.json"), "--output_path", path("a.dxf")},
      {"edge_extractor", "--project_path", path("a.ini")},
      {"edge_extractor", "--workspace_path", w.path().string(), "--image_list_path", path("a.txt")},
      {"truth_extractor", "--workspace_path", w.path().string(), "--mesh_path", path("a.ply"),
       "--output_path", path("truth.ply")}};
  for (const std::vector<std::string>& arguments : runs) {
    const LimnRun run = RunLimn(arguments, Limits(20));
    EXPECT_EQ(run.exit_code, 1) << arguments.front();
    EXPECT_THAT(run.err, HasSubstr(": has 107374182400 bytes, at most ")) << arguments.front();
  }
}

// From too little to load the program to enough for all; what is in between is said in a line.
TEST(CorpusRuns, Case35_TooLittleMemoryIsALine) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer needs all addresses";
#endif
  const W w;
  RunConditions conditions = Limits(60);
  int lines = 0;
  LimnRun run;
  for (conditions.max_memory_mb = 150; conditions.max_memory_mb < 1000;
       conditions.max_memory_mb += 20) {
    run = RunLimn({"edge_extractor", "--workspace_path", w.path().string(), "--num_threads", "1"},
                  conditions);
    if (run.exit_code == 0) break;
    if (run.err.find("error while loading shared libraries") != std::string::npos) continue;
    EXPECT_EQ(run.exit_code, 1) << conditions.max_memory_mb;
    EXPECT_THAT(run.err, ::testing::StartsWith("ERROR: ")) << conditions.max_memory_mb;
    if (run.err.find("lower --max_image_size") != std::string::npos) lines += 1;
  }
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GE(lines, 1);
}

// Ctrl-C while the edges are looked for.
TEST(CorpusRuns, Case35_InterruptedRunLeavesNothingHalfWritten) {
  const fs::path day = fs::path(LIMN_SAMPLE_DIR) / "day";
  const TempDir dir;
  RunConditions conditions;
  conditions.interrupt_after_seconds = 5;
  const LimnRun run = RunLimn({"automatic_drawer", "--workspace_path", day.string(),
                               "--output_path", (dir / "out").string(), "--num_threads", "1"},
                              conditions);
  EXPECT_EQ(run.exit_code, 130);
  EXPECT_THAT(run.err, ::testing::StartsWith("Interrupted: "));
  for (const auto& [name, bytes] : ReadTree(dir.path())) {
    if (name == "out/curves/.lock") continue;  // of a run that had to be ended at once
    EXPECT_THAT(name, HasSubstr("curves/cache/"));
    EXPECT_FALSE(name.ends_with(kTemporarySuffix)) << name;
  }
}

// All files but the page, whose report has times.
std::map<std::string, std::string> Results(const fs::path& folder) {
  auto files = ReadTree(folder);
  files.erase("drawing.html");
  return files;
}

// Nothing that was given is changed, nothing that was written is read as input.
TEST(CorpusRuns, Case36_RunningTwice) {
  const W w;
  const auto given = Results(w.path());
  const std::vector<std::string> arguments = {"automatic_drawer",
                                              "--workspace_path",
                                              w.path().string(),
                                              "--quality",
                                              "low",
                                              "--max_image_size",
                                              "160",
                                              "--num_threads",
                                              "2",
                                              "--refine_cameras",
                                              "1"};
  const LimnRun first = RunLimn(arguments, Limits(120));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const auto after_first = Results(w.path());
  EXPECT_GT(after_first.size(), given.size());
  const LimnRun second = RunLimn(arguments, Limits(120));
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_THAT(second.out, HasSubstr("6 images were taken from the cache"));
  const auto after_second = Results(w.path());
  EXPECT_EQ(after_second.size(), after_first.size());
  for (const auto& [name, bytes] : after_first) EXPECT_TRUE(after_second.at(name) == bytes) << name;
  for (const auto& [name, bytes] : given) EXPECT_EQ(after_second.at(name), bytes) << name;

  // What another run has made is kept, unless it may be replaced.
  std::vector<std::string> other = arguments;
  other.insert(other.end(), {"--Drawing.min_link_length_px", "30"});
  const LimnRun refused = RunLimn(other, Limits(120));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_EQ(refused.err, "ERROR: " + (w / "drawing.json").string() +
                             ": was drawn with other options (/Drawing/min_link_length_px): "
                             "--overwrite 1 replaces it, --output_path writes elsewhere\n");
  EXPECT_EQ(Results(w.path()), after_first);
  other.insert(other.end(), {"--overwrite", "1"});
  const LimnRun replaced = RunLimn(other, Limits(120));
  EXPECT_EQ(replaced.exit_code, 0) << replaced.err;
  EXPECT_NE(Results(w.path()).at("drawing.json"), after_first.at("drawing.json"));
}

// The options of an earlier version stood in another order, and there were more of them.
void WriteAsEarlierVersion(const std::filesystem::path& path, double corner_arm_px) {
  auto drawing = nlohmann::ordered_json::parse(ReadWholeFile(path.string()));
  nlohmann::ordered_json& options = drawing["options"];
  options["Linking"]["corner_arm_px"] = corner_arm_px;
  const nlohmann::ordered_json edges = options["EdgeDetection"];
  options.erase("EdgeDetection");
  options["EdgeDetection"] = edges;
  std::ofstream(path) << drawing.dump();
}

TEST(CorpusRuns, Case36_ADrawingOfAnEarlierVersion) {
  const W w;
  const std::vector<std::string> arguments = {"automatic_drawer",
                                              "--workspace_path",
                                              w.path().string(),
                                              "--quality",
                                              "low",
                                              "--max_image_size",
                                              "160"};
  ASSERT_EQ(RunLimn(arguments, Limits(120)).exit_code, 0);
  WriteAsEarlierVersion(w / "drawing.json", 5);
  const LimnRun accepted = RunLimn(arguments, Limits(120));
  EXPECT_EQ(accepted.exit_code, 0) << accepted.err;
  WriteAsEarlierVersion(w / "drawing.json", 6);
  const LimnRun refused = RunLimn(arguments, Limits(120));
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("other options (/Linking/corner_arm_px)"));
}

}  // namespace
}  // namespace limn::testing
