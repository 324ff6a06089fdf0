// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/test_database.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <sqlite3.h>

namespace limn::testing {
namespace {

// A number as SQL: COLMAP's NaN becomes NULL.
std::string Sql(double number) {
  if (std::isnan(number)) return "NULL";
  char text[40];
  std::snprintf(text, sizeof(text), "%.17g", number);
  return text;
}

// As COLMAP stores matrices.
template <typename Matrix>
std::string Blob(const Matrix& matrix) {
  std::string text = "x'";
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    unsigned char bytes[sizeof(double)];
    std::memcpy(bytes, matrix.data() + i, sizeof(double));
    for (const unsigned char byte : bytes) {
      char digits[3];
      std::snprintf(digits, sizeof(digits), "%02x", byte);
      text += digits;
    }
  }
  return text + "'";
}

const char* TablesOf(DatabaseVersion version) {
  switch (version) {
    case DatabaseVersion::k3_8:
      return "CREATE TABLE images (image_id INTEGER PRIMARY KEY, name TEXT, camera_id INTEGER,"
             " prior_qw REAL, prior_qx REAL, prior_qy REAL, prior_qz REAL,"
             " prior_tx REAL, prior_ty REAL, prior_tz REAL);";
    case DatabaseVersion::k3_10:
      return "CREATE TABLE images (image_id INTEGER PRIMARY KEY, name TEXT, camera_id INTEGER);"
             "CREATE TABLE pose_priors (image_id INTEGER PRIMARY KEY, position BLOB,"
             " coordinate_system INTEGER);";
    case DatabaseVersion::k3_12:
      return "CREATE TABLE images (image_id INTEGER PRIMARY KEY, name TEXT, camera_id INTEGER);"
             "CREATE TABLE pose_priors (image_id INTEGER PRIMARY KEY, position BLOB,"
             " coordinate_system INTEGER, position_covariance BLOB);";
    case DatabaseVersion::k4_1:
      return "CREATE TABLE images (image_id INTEGER PRIMARY KEY, name TEXT, camera_id INTEGER);"
             "CREATE TABLE pose_priors (pose_prior_id INTEGER PRIMARY KEY, corr_data_id INTEGER,"
             " corr_sensor_id INTEGER, corr_sensor_type INTEGER, position BLOB,"
             " position_covariance BLOB, gravity BLOB, coordinate_system INTEGER);";
  }
  return "";
}

std::string RowsOf(const StoredPrior& prior, DatabaseVersion version, int number) {
  const bool is_new = version == DatabaseVersion::k4_1;
  const std::string id = std::to_string(is_new ? 100 - number : number);
  const std::string image = id + ", '" + prior.image + "', 1";
  const std::string system = std::to_string(prior.coordinate_system);
  const std::string insert_image = "INSERT INTO images VALUES(" + image + ");";
  switch (version) {
    case DatabaseVersion::k3_8:
      return "INSERT INTO images VALUES(" + image + ", NULL, NULL, NULL, NULL, " +
             Sql(prior.position.x()) + ", " + Sql(prior.position.y()) + ", " +
             Sql(prior.position.z()) + ");";
    case DatabaseVersion::k3_10:
      return insert_image + "INSERT INTO pose_priors VALUES(" + id + ", " + Blob(prior.position) +
             ", " + system + ");";
    case DatabaseVersion::k3_12:
      return insert_image + "INSERT INTO pose_priors VALUES(" + id + ", " + Blob(prior.position) +
             ", " + system + ", " + Blob(prior.covariance) + ");";
    case DatabaseVersion::k4_1:
      return insert_image + "INSERT INTO pose_priors VALUES(NULL, " + id + ", 1, 0, " +
             Blob(prior.position) + ", " + Blob(prior.covariance) + ", " + Blob(prior.gravity) +
             ", " + system + "), (NULL, " + id + ", 1, 1, " + Blob(Eigen::Vector3d(1, 2, 3)) +
             ", NULL, NULL, 1);";
  }
  return "";
}

}  // namespace

void WriteDatabase(const std::filesystem::path& path, DatabaseVersion version,
                   const std::vector<StoredPrior>& priors) {
  std::string sql = std::string("BEGIN;") + TablesOf(version);
  for (size_t i = 0; i < priors.size(); ++i) {
    sql += RowsOf(priors[i], version, static_cast<int>(i) + 1);
  }
  RunSql(path, sql + "COMMIT;");
}

void RunSql(const std::filesystem::path& path, const std::string& sql) {
  sqlite3* database = nullptr;
  const bool is_open = sqlite3_open(path.c_str(), &database) == SQLITE_OK;
  const bool is_done =
      is_open && sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK;
  const std::string reason = sqlite3_errmsg(database);
  sqlite3_close(database);
  if (!is_done) throw std::runtime_error(path.string() + ": " + reason);
}

}  // namespace limn::testing
