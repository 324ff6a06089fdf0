// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/pose_priors.h"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "colmap_ext/workspace/test_database.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

using limn::testing::DatabaseVersion;
using limn::testing::RunSql;
using limn::testing::StoredPrior;
using limn::testing::WriteDatabase;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// Of the images of all tests.
PosePriors Read(const std::filesystem::path& path) {
  return ReadPosePriors(path, {"sub/a b.jpg", "zero.jpg", "a", "b", "a\n.jpg"});
}

class PosePriorsTest : public ::testing::Test {
 protected:
  std::string ErrorOf(const std::string& path) {
    return ErrorText<IoError>([&] { Read(path); });
  }

  TempDir dir_;
  const std::string path_ = (dir_ / "database.db").string();
};

TEST_F(PosePriorsTest, OfAllVersionsAreRead) {
  StoredPrior first{"sub/a b.jpg", {47.25, 8.5, 410.5}};
  first.covariance = Eigen::Vector3d(1, 4, 7).asDiagonal();
  first.gravity = {0.1, 9, -1};
  for (const auto version : {DatabaseVersion::k3_8, DatabaseVersion::k3_10, DatabaseVersion::k3_12,
                             DatabaseVersion::k4_1}) {
    SCOPED_TRACE(static_cast<int>(version));
    const TempDir dir;
    WriteDatabase(dir / "d.db", version, {first, {"none.jpg"}, {"zero.jpg", {0, 0, 0}}});
    const PosePriors priors = Read(dir / "d.db");
    ASSERT_EQ(priors.size(), 1u);
    const PosePrior& prior = priors.at("sub/a b.jpg");
    EXPECT_EQ(prior.position, first.position);
    EXPECT_TRUE(prior.is_geographic);
    EXPECT_EQ(prior.position_sigma, version >= DatabaseVersion::k3_12 ? 2 : 0);
    EXPECT_EQ(prior.gravity.has_value(), version == DatabaseVersion::k4_1);
    if (prior.gravity) {
      EXPECT_EQ(*prior.gravity, first.gravity);
    }
  }
}

TEST_F(PosePriorsTest, CartesianPositionsAndUndefinedOnes) {
  WriteDatabase(path_, DatabaseVersion::k3_12, {{"a", {500000, 5e6, 3}, 1}, {"b", {1, 2, 3}, -1}});
  const PosePriors priors = Read(path_);
  EXPECT_EQ(priors.at("a").position, Eigen::Vector3d(500000, 5e6, 3));
  EXPECT_FALSE(priors.at("a").is_geographic);
  EXPECT_FALSE(priors.at("b").is_geographic);
}

TEST_F(PosePriorsTest, OldPosesAreCentersOfCameras) {
  WriteDatabase(path_, DatabaseVersion::k3_8, {{"a", {1, 2, 3}}, {"b", {500, 2, 3}}});
  // Half a turn about x.
  RunSql(path_, "UPDATE images SET prior_qw=0, prior_qx=2, prior_qy=0, prior_qz=0 WHERE name='a'");
  const PosePriors priors = Read(path_);
  EXPECT_LT((*priors.at("a").position - Eigen::Vector3d(-1, 2, 3)).norm(), 1e-12);
  // No latitude.
  EXPECT_FALSE(priors.at("b").is_geographic);
}

TEST_F(PosePriorsTest, NothingIsChanged) {
  WriteDatabase(path_, DatabaseVersion::k4_1, {{"a", {1, 2, 3}}});
  RunSql(path_, "PRAGMA journal_mode=WAL");
  const auto bytes = [&] {
    std::ifstream file(path_, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string before = bytes();
  std::filesystem::permissions(path_, std::filesystem::perms::owner_read);
  EXPECT_EQ(Read(path_).size(), 1u);
  EXPECT_EQ(bytes(), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(dir_.path()), {}), 1);
}

TEST_F(PosePriorsTest, NamesWithSpecialCharactersAreFiles) {
  const std::string path = (dir_ / "a?b=%41#c d.db").string();
  WriteDatabase(path, DatabaseVersion::k4_1, {{"a", {1, 2, 3}}});
  EXPECT_EQ(Read(path).size(), 1u);
}

TEST_F(PosePriorsTest, BadDatabasesAreNamed) {
  EXPECT_THAT(ErrorOf(path_), StartsWith(path_ + ": is not a file"));
  EXPECT_THAT(ErrorOf(dir_.path().string()), HasSubstr("is not a file"));
  EXPECT_THAT(ErrorOf(dir_.WriteFile("x.db", std::string(5000, 'x'))),
              HasSubstr("x.db: file is not a database"));
  EXPECT_THAT(ErrorOf(dir_.WriteFile("empty.db", "")),
              HasSubstr("empty.db: is not a database of COLMAP: it has no table pose_priors"));
  RunSql(path_, "CREATE TABLE pose_priors (position BLOB);");
  EXPECT_THAT(ErrorOf(path_), AllOf(StartsWith(path_), HasSubstr("has no table images")));
}

TEST_F(PosePriorsTest, BadValuesAreNamed) {
  WriteDatabase(path_, DatabaseVersion::k4_1, {{"a\n.jpg", {1, 2, 3}}, {"b", {91, 2, 3}}});
  EXPECT_THAT(ErrorOf(path_), HasSubstr("prior of image \"b\": is not a latitude, longitude"));
  RunSql(path_, "UPDATE pose_priors SET coordinate_system = 1 WHERE corr_data_id = 98");
  EXPECT_THAT(ErrorOf(path_), HasSubstr("prior of image \"b\": is in another coordinate system"));
  RunSql(path_, "UPDATE pose_priors SET gravity = x'00'");
  EXPECT_THAT(ErrorOf(path_), HasSubstr("\": gravity has 1 bytes, not 24"));
  RunSql(path_, "UPDATE pose_priors SET gravity = NULL, position = 'twenty-four characters..'");
  EXPECT_THAT(ErrorOf(path_), StartsWith(path_ + ": prior of image \""));
}

// An endless program in place of a table.
TEST_F(PosePriorsTest, NothingOfTheSchemaIsRun) {
  const std::string endless =
      "WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r) SELECT i AS image_id, NULL "
      "AS"
      " position, 1 AS coordinate_system FROM r";
  WriteDatabase(path_, DatabaseVersion::k3_10, {{"a", {1, 2, 3}}});
  RunSql(path_, "DROP TABLE pose_priors; CREATE VIEW pose_priors AS " + endless);
  EXPECT_THAT(ErrorOf(path_), HasSubstr("pose_priors is a view or a virtual table"));
  // A view that says that it is a table.
  RunSql(path_,
         "PRAGMA writable_schema = 1; UPDATE sqlite_master SET type = 'table', rootpage = 2 "
         "WHERE name = 'pose_priors'");
  EXPECT_THAT(ErrorOf(path_), StartsWith(path_ + ": "));
  RunSql(path_, "PRAGMA writable_schema = 1; DELETE FROM sqlite_master WHERE name = 'pose_priors'");
  RunSql(path_,
         "CREATE TABLE pose_priors (image_id INTEGER PRIMARY KEY, position AS "
         "(zeroblob(900000000)), coordinate_system INTEGER)");
  EXPECT_THAT(ErrorOf(path_), HasSubstr("column position of pose_priors is computed"));
}

TEST_F(PosePriorsTest, WorkAndLengthsHaveLimits) {
  WriteDatabase(path_, DatabaseVersion::k3_10, {{"a", {1, 2, 3}}});
  RunSql(path_, "UPDATE pose_priors SET position = zeroblob(2000000)");
  EXPECT_THAT(ErrorOf(path_), HasSubstr("has a value of more than 1048576 bytes"));
  // All rows of one table fit all of the other.
  RunSql(path_,
         "DROP TABLE images; DROP TABLE pose_priors; CREATE TABLE images (image_id INTEGER, name "
         "TEXT);"
         "CREATE TABLE pose_priors (image_id INTEGER, position BLOB, coordinate_system INTEGER);"
         "WITH RECURSIVE r(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM r LIMIT 30000)"
         "INSERT INTO images SELECT 1, 'x' FROM r; INSERT INTO pose_priors SELECT 1, NULL, 1 FROM "
         "images");
  EXPECT_THAT(ErrorOf(path_), HasSubstr("takes more work than any database of COLMAP"));
}

TEST_F(PosePriorsTest, OnlyThoseOfTheImagesAreReadAndChecked) {
  WriteDatabase(path_, DatabaseVersion::k4_1,
                {{"a", {1, 2, 3}}, {"c", {1, 2, 3}, 1}, {"d", {95, 2, 3}}});
  EXPECT_EQ(Read(path_).size(), 1u);
  const std::string old = (dir_ / "old.db").string();
  WriteDatabase(old, DatabaseVersion::k3_8, {{"a", {1, 2, 3}}, {"d", {500, 2, 3}}});
  EXPECT_TRUE(Read(old).at("a").is_geographic);
  EXPECT_EQ(Read(old).size(), 1u);
}

TEST_F(PosePriorsTest, CutDatabasesAreNamed) {
  std::vector<StoredPrior> many;
  for (int i = 0; i < 300; ++i) many.push_back({std::to_string(i), {1, 2, 3}});
  WriteDatabase(path_, DatabaseVersion::k4_1, many);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) / 2);
  EXPECT_THAT(ErrorOf(path_), StartsWith(path_ + ": "));
}

TEST_F(PosePriorsTest, UnfinishedChangesAreNamed) {
  WriteDatabase(path_, DatabaseVersion::k4_1, {{"a", {1, 2, 3}, 1}});
  const auto fails_with = [&](const std::string& name, const std::string& bytes) {
    const std::string beside = dir_.WriteFile(name, bytes);
    EXPECT_THAT(ErrorOf(path_),
                AllOf(StartsWith(path_ + ": " + beside), HasSubstr("sqlite3 " + path_)))
        << name;
    std::filesystem::create_symlink(path_, dir_ / "link.db");
    EXPECT_THAT(ErrorOf((dir_ / "link.db").string()), HasSubstr(beside));
    std::filesystem::remove(dir_ / "link.db");
    std::filesystem::remove(beside);
  };
  const auto is_void_with = [&](const std::string& name, const std::string& bytes) {
    const std::string beside = dir_.WriteFile(name, bytes);
    EXPECT_EQ(Read(path_).size(), 1u) << name;
    std::filesystem::remove(beside);
  };
  const std::string rest(600, 'x');
  fails_with("database.db-journal", "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7" + rest);
  fails_with("database.db-wal", "\x37\x7f\x06\x82" + rest);
  is_void_with("database.db-journal", "");
  is_void_with("database.db-journal", std::string(600, '\0'));  // committed
  is_void_with("database.db-wal", "");
  is_void_with("database.db-wal", "\x37\x7f\x06\x83" + rest.substr(0, 28));  // no frame
  is_void_with("database.db-wal", "pages");
}

}  // namespace
}  // namespace limn::colmap_ext
