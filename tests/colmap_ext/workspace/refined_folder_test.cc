// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/refined_folder.h"

#include <algorithm>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RefinedFolder : public ::testing::Test {
 protected:
  void Write(ModelFlavor flavor, bool has_rigs = false) const {
    SparseModel model = MakeModel();
    model.flavor = flavor;
    const SensorId sensor = {kCameraSensor, model.images[0].camera_id};
    if (has_rigs) {
      model.rigs = {{1, {{sensor, true, {}}}}};
      model.frames = {{1, 1, model.images[0].cam_from_world, {{sensor, model.images[0].id}}}};
    }
    WriteRefinedFolder(model, folder_);
  }

  std::set<std::string> Names() const {
    std::set<std::string> names;
    if (!fs::exists(folder_)) return names;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      names.insert(entry.path().filename().string());
    }
    return names;
  }

  void Append(const std::string& name) const {
    std::ofstream(folder_ / name, std::ios::app) << " ";
  }

  // Empty if everything may be replaced.
  std::string Refusal(bool overwrite = false) const {
    return ErrorText<IoError>([&] { CheckRefinedFolder(folder_, overwrite); });
  }

  TempDir dir_;
  const fs::path folder_ = dir_ / "refined";
};

TEST_F(RefinedFolder, HasTheFlavorOfTheModelAndNoOther) {
  Write(ModelFlavor::kText, /*has_rigs=*/true);
  EXPECT_THAT(Names(), ElementsAre("cameras.txt", "frames.txt", "images.txt", "limn.txt",
                                   "points3D.txt", "rigs.txt"));
  EXPECT_EQ(Refusal(), "");
  Write(ModelFlavor::kBinary);
  EXPECT_THAT(Names(), ElementsAre("cameras.bin", "images.bin", "limn.txt", "points3D.bin"));
  const SparseModel back = ReadColmapModel(folder_);
  EXPECT_EQ(back.flavor, ModelFlavor::kBinary);
  ExpectSameModel(back, MakeModel());
  EXPECT_EQ(Refusal(), "");
  Write(ModelFlavor::kText);
  EXPECT_THAT(Names(), ElementsAre("cameras.txt", "images.txt", "limn.txt", "points3D.txt"));
  EXPECT_EQ(ReadColmapModel(folder_).flavor, ModelFlavor::kText);
}

TEST_F(RefinedFolder, OfTheSameModelHasTheSameBytes) {
  Write(ModelFlavor::kBinary);
  const std::string record = ReadWholeFile((folder_ / "limn.txt").string());
  const std::string name = NameOfRefinedCameras(folder_);
  Write(ModelFlavor::kText);
  EXPECT_EQ(NameOfRefinedCameras(folder_), name);
  Write(ModelFlavor::kBinary);
  EXPECT_EQ(ReadWholeFile((folder_ / "limn.txt").string()), record);
}

TEST_F(RefinedFolder, CamerasAreNamedByWhatTheyAre) {
  EXPECT_EQ(NameOfRefinedCameras(folder_), "");
  SparseModel model = MakeModel();
  const std::string name = WriteRefinedFolder(model, folder_);
  std::reverse(model.images.begin(), model.images.end());
  model.points.clear();
  EXPECT_EQ(WriteRefinedFolder(model, folder_), name);
  model.images[0].cam_from_world.translation.x() += 1e-9;
  EXPECT_NE(WriteRefinedFolder(model, folder_), name);
  std::ofstream(folder_ / "images.txt") << "1 2 3\n";
  EXPECT_EQ(NameOfRefinedCameras(folder_), "");
}

TEST_F(RefinedFolder, FilesThatOthersWroteOrChangedAreNotReplaced) {
  EXPECT_EQ(Refusal(), "");
  fs::create_directories(folder_);
  WriteModelBinary(MakeModel(), folder_);
  EXPECT_THAT(Refusal(), AllOf(HasSubstr((folder_ / "cameras.bin").string()),
                               HasSubstr("--overwrite 1 replaces it")));
  EXPECT_EQ(Refusal(/*overwrite=*/true), "");
  for (const ModelFlavor flavor : {ModelFlavor::kBinary, ModelFlavor::kText}) {
    Write(flavor);
    EXPECT_EQ(Refusal(), "");
    const std::string changed = flavor == ModelFlavor::kBinary ? "images.bin" : "images.txt";
    Append(changed);
    EXPECT_THAT(Refusal(), HasSubstr((folder_ / changed).string()));
  }
}

TEST_F(RefinedFolder, TextOfVersionsWithoutARecordIsLimns) {
  fs::create_directories(folder_);
  WriteModelText(MakeModel(), folder_);
  EXPECT_EQ(Refusal(), "");
  EXPECT_TRUE(RemoveRefinedFolder(folder_));
  EXPECT_FALSE(fs::exists(folder_));
}

// A run that was killed between two files.
TEST_F(RefinedFolder, FilesOfAKilledRunAreLimns) {
  Write(ModelFlavor::kText);
  fs::copy_file(folder_ / "images.txt", dir_ / "images.txt");
  const std::string old_lines = ReadWholeFile((folder_ / "limn.txt").string());
  Write(ModelFlavor::kBinary);
  fs::copy_file(dir_ / "images.txt", folder_ / "images.txt");
  EXPECT_THAT(Refusal(), HasSubstr("images.txt"));
  std::ofstream(folder_ / "limn.txt", std::ios::app) << old_lines;
  EXPECT_EQ(Refusal(), "");
}

TEST_F(RefinedFolder, OnlyWhatLimnWroteIsRemoved) {
  EXPECT_TRUE(RemoveRefinedFolder(folder_));
  Write(ModelFlavor::kBinary, /*has_rigs=*/true);
  EXPECT_TRUE(RemoveRefinedFolder(folder_));
  EXPECT_FALSE(fs::exists(folder_));

  Write(ModelFlavor::kBinary);
  std::ofstream(folder_ / "notes.md") << "mine";
  EXPECT_TRUE(RemoveRefinedFolder(folder_));
  EXPECT_THAT(Names(), ElementsAre("notes.md"));

  Write(ModelFlavor::kBinary);
  Append("images.bin");
  EXPECT_FALSE(RemoveRefinedFolder(folder_));
  EXPECT_THAT(Names(), ElementsAre("images.bin", "limn.txt", "notes.md"));
}

}  // namespace
}  // namespace limn::colmap_ext
