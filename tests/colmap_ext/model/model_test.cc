// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/model/model.h"

#include <algorithm>
#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/model/test_model.h"
#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string ErrorOf(const fs::path& folder) {
  return ErrorText<IoError>([&] { ReadColmapModel(folder); });
}

TEST(Model, BothFlavorsAreReadFromAFolder) {
  const TempDir binary;
  const TempDir text;
  WriteModelBinary(MakeModel(), binary.path());
  WriteModelText(MakeModel(), text.path());
  for (const TempDir* dir : {&binary, &text}) {
    EXPECT_TRUE(HoldsColmapModel(dir->path()));
    EXPECT_EQ(CountColmapImages(dir->path()), 3u);
    const SparseModel model = ReadColmapModel(dir->path());
    ExpectSameModel(model, MakeModel());
    EXPECT_EQ(model.folder, dir->path());
    EXPECT_THAT(model.warnings, IsEmpty());
  }
}

TEST(Model, BinaryIsPreferredAndNewerTextIsAWarning) {
  const TempDir dir;
  SparseModel other = MakeModel();
  other.images.pop_back();
  WriteModelText(other, dir.path());
  WriteModelBinary(MakeModel(), dir.path());
  const auto now = fs::last_write_time(dir / "images.bin");
  fs::last_write_time(dir / "images.txt", now - std::chrono::hours(1));
  EXPECT_EQ(ReadColmapModel(dir.path()).images.size(), 3u);
  EXPECT_THAT(ReadColmapModel(dir.path()).warnings, IsEmpty());
  fs::last_write_time(dir / "images.txt", now + std::chrono::hours(1));
  EXPECT_THAT(ReadColmapModel(dir.path()).warnings, ElementsAre(HasSubstr("images.txt is newer")));
}

TEST(Model, MissingPointsAreAWarning) {
  const TempDir dir;
  WriteModelBinary(MakeModel(), dir.path());
  fs::remove(dir / "points3D.bin");
  const SparseModel model = ReadColmapModel(dir.path());
  EXPECT_EQ(model.images.size(), 3u);
  EXPECT_TRUE(model.points.empty());
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("points3D.bin is missing")));
}

TEST(Model, IncompleteFoldersAreExplained) {
  const TempDir dir;
  EXPECT_THAT(ErrorOf(dir / "nowhere"), HasSubstr("nowhere: no such folder"));
  EXPECT_THAT(ErrorOf(dir.path()), HasSubstr("neither of them found"));
  WriteModelBinary(MakeModel(), dir.path());
  fs::remove(dir / "images.bin");
  EXPECT_THAT(ErrorOf(dir.path()), HasSubstr("images.bin is missing beside cameras.bin"));
  EXPECT_FALSE(HoldsColmapModel(dir.path()));
}

TEST(Model, EmptyFilesAreRefused) {
  const TempDir dir;
  WriteModelBinary(MakeModel(), dir.path());
  dir.WriteFile("images.bin", "");
  EXPECT_THAT(ErrorOf(dir.path()), HasSubstr("images.bin: byte 0: truncated"));
}

// COLMAP itself converts a model with its 3.8 camera models: our binary writer is read by it, and
// its text and binary files give back the same model. Names without spaces, which its text format
// loses.
TEST(Model, AgreesWithColmapModelConverter) {
  if (!HaveColmap()) GTEST_SKIP() << "colmap is not installed";
  SparseModel model = MakeModel();
  model.images[1].name = "sub/ab.png";
  model.points[1].track.push_back({9, 1});
  model.images[0].observations[1].point3D_id = 2;
  for (int id = 0; id <= 10; ++id) {
    model.cameras.push_back(MakeCamera(static_cast<CameraModelId>(id), 100 - id));
  }
  const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
  const auto sort = [&](SparseModel* m) {
    std::sort(m->cameras.begin(), m->cameras.end(), by_id);
    std::sort(m->images.begin(), m->images.end(), by_id);
    std::sort(m->points.begin(), m->points.end(), by_id);
  };
  sort(&model);
  const TempDir dir;
  for (const char* folder : {"ours", "BIN", "TXT"}) fs::create_directories(dir / folder);
  WriteModelBinary(model, dir / "ours");
  for (const std::string type : {"BIN", "TXT"}) {
    ASSERT_TRUE(RunColmap("model_converter --input_path '" + (dir / "ours").string() +
                              "' --output_path '" + (dir / type).string() + "' --output_type " +
                              type,
                          dir / "log"))
        << type;
    SparseModel converted = ReadColmapModel(dir / type);
    sort(&converted);
    ExpectSameModel(converted, model);
  }
}

}  // namespace
}  // namespace limn::colmap_ext
