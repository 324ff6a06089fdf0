// SPDX-License-Identifier: BSD-3-Clause
// Bad options and commands give one line on standard error and exit code 1, and nothing is written.
// Bad files are in the corpus_*_test files.
#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/model_folder.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A dense workspace of our own: the sample's model, its images by links.
class BadInput : public ::testing::Test {
 protected:
  BadInput() : workspace_(dir_ / "workspace"), output_(dir_ / "output") {
    const fs::path day = fs::path(LIMN_SAMPLE_DIR) / "day";
    fs::create_directories(workspace_ / "images");
    fs::copy(day / "sparse", workspace_ / "sparse");
    for (const auto& entry : fs::directory_iterator(day / "images")) {
      fs::create_symlink(fs::absolute(entry.path()),
                         workspace_ / "images" / entry.path().filename());
    }
  }

  void ExpectRefused(const std::vector<std::string>& more_arguments, const auto& line_matcher) {
    const auto before = ReadTree(dir_.path());
    std::vector<std::string> arguments = {"automatic_drawer", "--output_path", output_.string(),
                                          "--workspace_path", workspace_.string()};
    arguments.insert(arguments.end(), more_arguments.begin(), more_arguments.end());
    const LimnRun run = RunLimn(arguments);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_THAT(run.err, StartsWith("ERROR: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_THAT(run.err, line_matcher);
    EXPECT_EQ(ReadTree(dir_.path()), before);
  }

  // Gives other names to the first images, in the model and on disk.
  void Rename(const std::vector<std::string>& names) {
    colmap_ext::SparseModel model = colmap_ext::ReadModel(workspace_ / "sparse");
    for (size_t i = 0; i < names.size(); ++i) {
      const fs::path image = workspace_ / "images" / names[i];
      fs::create_directories(image.parent_path());
      fs::rename(workspace_ / "images" / model.images[i].name, image);
      model.images[i].name = names[i];
    }
    fs::remove_all(workspace_ / "sparse");
    fs::create_directory(workspace_ / "sparse");
    colmap_ext::WriteModelBinary(model, workspace_ / "sparse");
  }

  TempDir dir_;
  fs::path workspace_;
  fs::path output_;
};

TEST_F(BadInput, NoPathAtAll) {
  const LimnRun run = RunLimn({"automatic_drawer"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), HasSubstr("workspace_path")));
}

TEST_F(BadInput, WrongOptionValue) {
  ExpectRefused({"--EdgeDetection.sigma_px", "0"}, HasSubstr("EdgeDetection.sigma_px = 0"));
  ExpectRefused({"--Linking.min_length_px", "long"}, HasSubstr("Linking.min_length_px = long"));
  ExpectRefused({"--quality", "best"}, HasSubstr("quality = best"));
  ExpectRefused({"--box", "0,1,0,1"}, HasSubstr("box"));
  ExpectRefused({"--box", "0,1,1,0,0,1"}, HasSubstr("box"));
  ExpectRefused({"--num_threads", "0"}, HasSubstr("num_threads = 0"));
  ExpectRefused({"--max_image_size", "3"}, HasSubstr("max_image_size = 3"));
  ExpectRefused({"--DrawingRefinement.num_rounds", "100000"},
                HasSubstr("DrawingRefinement.num_rounds = 100000"));
  ExpectRefused({"--Paper.max_averaging_rounds", "1000000000"},
                HasSubstr("Paper.max_averaging_rounds = 1e+09"));
}

TEST_F(BadInput, ATableOnAFullDeviceIsLost) {
  const std::string curve = dir_.WriteFile("curve.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  const LimnRun run =
      RunProgram("/bin/sh", {"-c", "\"$0\" \"$@\" > /dev/full", LIMN_PROGRAM, "drawing_evaluator",
                             "--input_path", curve, "--truth_path", curve, "--taus", "0.1"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "ERROR: standard output: the table could not be written\n");
}

TEST_F(BadInput, UnknownOption) {
  ExpectRefused({"--Drawing.no_such_option", "1"}, HasSubstr("Drawing.no_such_option"));
}

TEST_F(BadInput, UnregisteredImageInTheList) {
  const std::string list = dir_.WriteFile("list.txt", "view_00.jpg\nview_77.jpg\n");
  ExpectRefused({"--image_list_path", list}, HasSubstr("view_77.jpg"));
  ExpectRefused({"--refine_cameras", "1", "--hold_images", list},
                AllOf(HasSubstr("hold_images = " + list), HasSubstr("\"view_77.jpg\""),
                      HasSubstr("remove it from the list")));
  ExpectRefused({"--refine_cameras", "0", "--hold_images", list},
                HasSubstr("needs refine_cameras = 1 or auto"));
  ExpectRefused({"--image_list_path", "/no/list.txt"},
                HasSubstr("/no/list.txt: cannot open: No such file or directory"));
}

TEST_F(BadInput, DrawingOfGivenCamerasThatAreNotRefined) {
  const auto expect = [&](const std::string& option, const std::string& value,
                          const std::string& error) {
    ExpectRefused({"--output_cameras", "given", "--" + option, value}, HasSubstr(error));
  };
  expect("refine_cameras", "0", "output_cameras = given: no camera is refined");
  expect("account", "1", "needs output_cameras = refined");
  expect("DrawingRefinement.num_rounds", "0", "output_cameras = given: needs DrawingRefinement");
}

TEST_F(BadInput, PipesAndFoldersInPlaceOfFiles) {
  const std::string pipe = (dir_ / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0666), 0);
  for (const char* option : {"--image_list_path", "--project_path"}) {
    ExpectRefused({option, pipe}, HasSubstr(pipe + ": is a pipe or a device, not a file"));
    ExpectRefused({option, dir_.path().string()}, HasSubstr(": is a folder, not a file"));
  }
  for (const char* extension : {"json", "ply", "obj", "txt"}) {
    const std::string link = pipe + "." + extension;
    fs::create_symlink("pipe", link);
    const LimnRun run =
        RunLimn({"drawing_evaluator", "--input_path", link, "--truth_path", link, "--taus", "1"},
                {.max_seconds = 20});
    EXPECT_EQ(run.exit_code, 1) << extension;
    EXPECT_EQ(run.err, "ERROR: " + link + ": is a pipe or a device, not a file\n");
  }
  fs::remove(workspace_ / "images/view_03.jpg");
  fs::create_directory(workspace_ / "images/view_03.jpg");
  ExpectRefused({}, HasSubstr("view_03.jpg: is a folder or a pipe, not an image file"));
}

TEST_F(BadInput, ImageNamesWhoseOverlaysCannotBe) {
  Rename({std::string(255, 'n')});
  ExpectRefused({}, HasSubstr("longer than 255 bytes"));
}

TEST_F(BadInput, ImageNamesWhoseOverlaysAreInEachOthersWay) {
  Rename({"a", "a.png/b.jpg"});
  ExpectRefused({}, HasSubstr("image \"a.png/b.jpg\": the folder of its overlay would have"));
}

TEST_F(BadInput, PathsThatNoIniFileCanHold) {
  ExpectRefused({"--mask_path", "a\nb"},
                HasSubstr("mask_path = a\\x0ab: must be without line ends"));
}

TEST_F(BadInput, MissingProjectFile) {
  ExpectRefused({"--project_path", (dir_ / "none.ini").string()}, HasSubstr("none.ini"));
}

TEST_F(BadInput, CurveDrawerWithoutSketch) {
  const std::string list = dir_.WriteFile("list.txt", "view_00.jpg\n");
  const LimnRun run =
      RunLimn({"curve_drawer", "--workspace_path", workspace_.string(), "--output_path",
               output_.string(), "--image_list_path", list, "--max_image_size", "160"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), HasSubstr("swept-sketch.bin")));
  EXPECT_FALSE(fs::exists(output_ / "drawing.ply"));
}

TEST(Commands, UnknownCommandIsRefused) {
  const LimnRun run = RunLimn({"automatic_painter"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.err, AllOf(StartsWith("ERROR: "), HasSubstr("automatic_painter")));
}

TEST(Commands, WhatIsMeantIsTold) {
  const LimnRun run = RunLimn({"drawing_exportr"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err,
            "ERROR: unknown command 'drawing_exportr': did you mean drawing_exporter?; 'limn help' "
            "lists the commands\n");
}

TEST(Commands, HelpOfACommandIsItsHelp) {
  const LimnRun help = RunLimn({"help", "drawing_aligner"});
  EXPECT_EQ(help.exit_code, 0) << help.err;
  EXPECT_EQ(help.out, RunLimn({"drawing_aligner", "-h"}).out);
  EXPECT_EQ(RunLimn({"help", "nonsense"}).exit_code, 1);
}

TEST(Commands, AllAreListedAndHaveHelp) {
  const LimnRun help = RunLimn({"help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("-h "), HasSubstr("--help_all")));
  for (const char* command :
       {"automatic_drawer", "camera_refiner", "edge_extractor", "curve_linker", "curve_sketcher",
        "curve_drawer", "drawing_exporter", "drawing_viewer", "model_importer", "drawing_fuser",
        "drawing_evaluator", "truth_extractor"}) {
    EXPECT_THAT(help.out, HasSubstr(command));
    const LimnRun run = RunLimn({command, "-h"});
    EXPECT_EQ(run.exit_code, 0) << command;
    EXPECT_THAT(run.out, HasSubstr("_path")) << command;
    EXPECT_EQ(run.err, "") << command;
  }
}

}  // namespace
}  // namespace limn::testing
