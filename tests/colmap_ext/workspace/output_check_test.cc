#include "colmap_ext/workspace/output_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "colmap_ext/temp_dir.h"
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
  for (const std::string& path : {file, file + "/folder", (dir / "link").string()}) {
    EXPECT_THAT(ErrorText<IoError>([&] { CheckWritable(path); }), HasSubstr("is not a folder"));
  }
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

TEST(CheckLinkedCurves, RefusesFoldersOfOthers) {
  const TempDir dir;
  const auto refusal = [&] {
    return ErrorText<IoError>([&] { CheckLinkedCurves(dir / "curves"); });
  };
  EXPECT_EQ(refusal(), "");
  std::filesystem::create_directory(dir / "other");
  std::filesystem::create_directory_symlink("other", dir / "curves");
  EXPECT_EQ(refusal(), "");
  dir.WriteFile("other/.lock", "");
  EXPECT_EQ(refusal(), "");
  dir.WriteFile("other/notes", "");
  EXPECT_EQ(refusal(), (dir / "curves").string() + ": is a link to " + (dir / "other").string() +
                           ", which holds other files than results of limn: link an empty folder, "
                           "or choose another --output_path");
  std::filesystem::create_directories(dir / "other/cache/fragments");
  EXPECT_EQ(refusal(), "");
  std::filesystem::remove_all(dir / "other/cache");
  EXPECT_NE(refusal(), "");
  dir.WriteFile("other/tracks.txt", "# Curve tracks: links of drawing.json and so on\n");
  EXPECT_EQ(refusal(), "");
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
  EXPECT_THAT(refusal((dir / "link.ply").string(), false), HasSubstr("is an input"));
  EXPECT_THAT(refusal(model, false), HasSubstr("is a file of a model"));
  EXPECT_THAT(refusal(drawing, false), HasSubstr("is a drawing"));
  EXPECT_EQ(refusal(other, false), "");
  EXPECT_EQ(refusal((dir / "new.ply").string(), false), "");
  for (const std::string& path : {input, model, drawing}) EXPECT_EQ(refusal(path, true), "");
}

}  // namespace
}  // namespace limn::colmap_ext
