// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;
using ::testing::StrEq;

constexpr char kMatrix[] = "600 0 320 0\n0 600 240 0\n0 0 1 5\n";

TEST(Formats, AreRecognizedByWhatIsThere) {
  const TempDir dir;
  const auto expect = [&](const std::string& file, const std::string& text, const char* name,
                          bool file_alone) {
    const std::string path = dir.WriteFile(std::string(name) + "/" + file, text);
    EXPECT_THAT(RecognizeFormat(dir / name).name, StrEq(name));
    if (file_alone) {
      EXPECT_THAT(RecognizeFormat(path).name, StrEq(name));
    }
  };
  expect("001.projmatrix", kMatrix, "projection_matrices", false);
  expect("frame_1.extrinsic", "", "intrinsic_extrinsic", false);
  expect("bundle.out", "# Bundle file v0.3\n0 0\n", "bundler", true);
  expect("a.nvm", "NVM_V3\n", "nvm", true);
  expect("dino_par.txt", "0\n", "middlebury", true);
  expect("transforms.json", "{}", "nerf_transforms", true);
  expect("reconstruction.json", "[{\"cameras\": {}}]", "opensfm", true);
  expect("anything.json", "{\"sfm_data_version\": \"0.3\"}", "openmvg", true);
  expect("anything.xml", "<?xml?><document><chunk/></document>", "metashape", true);
  expect("anything.csv", "#cameras 1\n#name,x,y,alt,heading,pitch,roll\n", "realitycapture", true);
}

TEST(Formats, TextFilesOfMatricesAreRecognized) {
  const TempDir dir;
  dir.WriteFile("pmvs/00000000.txt", std::string("CONTOUR\n") + kMatrix);
  dir.WriteFile("dtu/pos_001.txt", kMatrix);
  EXPECT_THAT(RecognizeFormat(dir / "pmvs").name, StrEq("projection_matrices"));
  EXPECT_THAT(RecognizeFormat(dir / "dtu").name, StrEq("projection_matrices"));
}

TEST(Formats, FilesThatAreNotReadTellHowToExport) {
  const TempDir dir;
  const auto error = [&](const std::string& name, const std::string& text) {
    const std::string path = dir.WriteFile(name, text);
    const std::string of_file = ErrorText<IoError>([&] { RecognizeFormat(path); });
    EXPECT_THAT(of_file, HasSubstr("--input_type may be projection_matrices, "));
    const std::string of_folder =
        ErrorText<IoError>([&] { RecognizeFormat(std::filesystem::path(path).parent_path()); });
    EXPECT_THAT(of_folder, HasSubstr(std::filesystem::path(name).filename().string() + " is a"));
    return of_file;
  };
  EXPECT_THAT(error("a/cameras.sfm", "{}"), HasSubstr("Meshroom, which is not read: aliceVision"));
  EXPECT_THAT(error("b/scene.mvs", "MVSI"), HasSubstr("InterfaceCOLMAP"));
  EXPECT_THAT(error("c/poses_bounds.npy", ""), HasSubstr("LLFF"));
  EXPECT_THAT(error("d/a.psx", ""), HasSubstr("Agisoft XML"));
  EXPECT_THAT(error("e/a.rcproj", ""), HasSubstr("Internal/External camera parameters"));
  EXPECT_THAT(error("f/sfm_data.bin", ""), HasSubstr("ConvertSfM_DataFormat"));
}

TEST(Formats, NoneAndSeveralAreRefused) {
  const TempDir dir;
  const auto error = [&](const std::string& name) {
    return ErrorText<IoError>([&] { RecognizeFormat(dir / name); });
  };
  dir.WriteFile("text/notes.txt", "nothing of the kind\n");
  EXPECT_THAT(error("text"), HasSubstr("no format of cameras recognized"));
  EXPECT_THAT(error("nowhere"), HasSubstr("nowhere: no such file or folder"));
  dir.WriteFile("both/a.nvm", "NVM_V3\n");
  dir.WriteFile("both/transforms.json", "{}");
  EXPECT_THAT(error("both"), HasSubstr("several formats of cameras found (nvm, nerf_transforms)"));
}

TEST(Formats, SeveralFilesOfOneFormatAreRefused) {
  const TempDir dir;
  dir.WriteFile("a.nvm", "NVM_V3\n");
  dir.WriteFile("b.nvm", "NVM_V3\n");
  ImageFolder images(dir.path(), false);
  EXPECT_THAT(ErrorText<IoError>([&] {
                FindImportFormat("nvm")->read({dir.path(), &images, "", -1});
              }),
              HasSubstr("several files *.nvm in this folder (a.nvm, b.nvm)"));
}

}  // namespace
}  // namespace limn::colmap_ext
