// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/output_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "colmap_ext/temp_dir.h"
#include "limn/files/whole_file.h"
#include "limn/pictures/picture.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using ::testing::HasSubstr;

constexpr char kOurCurves[] = "ply\nformat binary_little_endian 1.0\ncomment curves by limn\n";

TEST(CheckWritable, AcceptsFoldersAndWhatCanBecomeOne) {
  const TempDir dir;
  CheckWritable(dir.path());
  CheckWritable(dir / "new/folder");
  CheckWritable("relative/folder");
  EXPECT_FALSE(std::filesystem::exists(dir / "new"));
}

TEST(CheckWritable, RefusesFilesAndDeadLinksInTheWay) {
  const TempDir dir;
  const std::string file = dir.WriteFile("file", "");
  std::filesystem::create_symlink("/nowhere/at/all", dir / "link");
  for (const OutputPath& path :
       {OutputPath(file), OutputPath(file + "/folder"), OutputPath(dir / "link", ""),
        OutputPath(dir / "link", "curves")}) {
    EXPECT_THAT(ErrorText<IoError>([&] { CheckWritable(path); }), HasSubstr("is not a folder"));
  }
}

TEST(CheckWritable, FollowsLinksThatTheUserNamedAndNoOthers) {
  const TempDir dir;
  std::filesystem::create_directories(dir / "other/curves");
  std::filesystem::create_directory_symlink("other", dir / "link");
  CheckWritable({dir / "link", "curves"});
  EXPECT_THAT(ErrorText<IoError>([&] {
                CheckWritable({dir.path(), "link/curves"});
              }),
              HasSubstr((dir / "link").string() + ": is a link to other"));
}

TEST(CheckWritable, RefusesReadOnlyFolders) {
  if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TempDir dir;
  std::filesystem::permissions(
      dir.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THAT(ErrorText<IoError>([&] { CheckWritable(dir / "new"); }),
              HasSubstr("Permission denied"));
  std::filesystem::permissions(dir.path(), std::filesystem::perms::owner_all);
}

// What the check says of a file with this content.
std::string RefusalToReplace(const TempDir& dir, const std::string& content, bool overwrite) {
  const std::string path = dir.WriteFile("result", content);
  return ErrorText<IoError>([&] { CheckResultFile(path, overwrite); });
}

TEST(CheckResultFile, RefusesWhatLimnHasNotMade) {
  const TempDir dir;
  EXPECT_EQ(RefusalToReplace(dir, kOurCurves, false), "");
  EXPECT_EQ(RefusalToReplace(dir, "glTF {\"asset\":{\"generator\":\"limn 1\"", false), "");
  EXPECT_EQ(
      RefusalToReplace(dir, "# EDGE_MAP v3.0\n\n# Format :  [Pixel_Pos]  Strength Uncer, by limn\n",
                       false),
      "");
  EXPECT_EQ(RefusalToReplace(dir, ".CEM v2.0\n# Curve fragments by limn\nsize=[4 3]\n", false), "");
  for (const char* foreign :
       {"", "ply\nformat ascii 1.0\n", "\xFF\xD8", "Notes on limn, Limn and LIMN\n",
        "ply\nformat ascii 1.0\ncomment curves by limn, edited\n", "glTF {\"generator\":\"other\"",
        "# my options\nworkspace_path=a\n",
        "# EDGE_MAP v3.0\n\n# Format :  [Pixel_Pos]  Strength Uncer\n", ".CEM v2.0\nsize=[4 3]\n",
        "<?xml version=\"1.0\"?>\n<svg><path id=\"link_1\"/>"}) {
    EXPECT_THAT(RefusalToReplace(dir, foreign, false), HasSubstr("was not made by limn"));
    EXPECT_EQ(RefusalToReplace(dir, foreign, true), "");
  }
  CheckResultFile((dir / "new").string(), false);
  std::filesystem::create_directory(dir / "folder");
  EXPECT_THAT(ErrorText<IoError>([&] { CheckResultFile((dir / "folder").string(), true); }),
              HasSubstr("is a folder"));
}

TEST(CheckResultFile, PicturesOfLimnAreKnown) {
  const TempDir dir;
  const Picture picture{1, 1, {10, 20, 30}};
  WritePng(dir / "ours.png", picture);
  CheckResultFile(dir / "ours.png", false);
  // The same without who made it.
  std::string bytes = ReadWholeFile((dir / "ours.png").string());
  bytes.erase(33, 12 + std::string("Software=limn").size());
  dir.WriteFile("photo.png", bytes);
  EXPECT_THAT(ErrorText<IoError>([&] { CheckResultFile(dir / "photo.png", false); }),
              HasSubstr("was not made by limn"));
}

TEST(CheckNamedOutput, RefusesInputsModelsAndDrawings) {
  const TempDir dir;
  const std::string input = dir.WriteFile("input.ply", kOurCurves);
  std::filesystem::create_symlink("input.ply", dir / "link.ply");
  const std::string model = dir.WriteFile("cameras.txt", "# CAMERA_ID, MODEL,");
  const std::string drawing = dir.WriteFile("d.json", "{\"format\": \"limn-drawing\",\n");
  const std::string other = dir.WriteFile("other.ply", kOurCurves);
  const auto refusal = [&](const std::string& path, bool overwrite) {
    return ErrorText<IoError>([&] { CheckNamedOutput(path, {"", input}, overwrite); });
  };
  EXPECT_THAT(refusal(input, false), HasSubstr("is an input"));
  EXPECT_THAT(refusal((dir / "link.ply").string(), true), HasSubstr("is a link to input.ply"));
  EXPECT_THAT(refusal(model, false), HasSubstr("is a file of a model"));
  EXPECT_THAT(refusal(drawing, false), HasSubstr("is a drawing"));
  EXPECT_EQ(refusal(other, false), "");
  EXPECT_EQ(refusal((dir / "new.ply").string(), false), "");
  for (const std::string& path : {input, model, drawing}) EXPECT_EQ(refusal(path, true), "");
}

}  // namespace
}  // namespace limn::colmap_ext
