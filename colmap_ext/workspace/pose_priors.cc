// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/pose_priors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <vector>

#include <Eigen/Geometry>
#include <sqlite3.h>

#include "colmap_ext/model/image_name.h"
#include "colmap_ext/workspace/database_journal.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {
namespace {

// COLMAP's PosePrior::CoordinateSystem::WGS84.
constexpr int kSystemWgs84 = 0;

// Longer than any name or matrix, and than the text of any table of COLMAP.
constexpr int kMaxValueBytes = 1 << 20;
// Steps of SQLite's machine, about a second: a row takes tens of them.
constexpr int kStepsPerCall = 1'000'000;
constexpr int kMaxCalls = 100;

// A path as the URI of SQLite; the file is read as it is, without locks and logs.
std::string ImmutableUri(const std::filesystem::path& path) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    if (c == '%' || c == '?' || c == '#') {
      char code[4];
      std::snprintf(code, sizeof(code), "%%%02X", static_cast<unsigned>(c));
      uri += code;
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

// A schema is a program, and the file may be anybody's: nothing of it runs.
void Restrict(sqlite3* handle, int* num_calls) {
  for (const int setting : {SQLITE_DBCONFIG_TRUSTED_SCHEMA, SQLITE_DBCONFIG_ENABLE_VIEW,
                            SQLITE_DBCONFIG_ENABLE_TRIGGER}) {
    sqlite3_db_config(handle, setting, 0, nullptr);
  }
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kMaxValueBytes);
  sqlite3_limit(handle, SQLITE_LIMIT_SQL_LENGTH, kMaxValueBytes);
  const auto count_call = [](void* calls) {
    return ++*static_cast<int*>(calls) > kMaxCalls ? 1 : 0;
  };
  sqlite3_progress_handler(handle, kStepsPerCall, count_call, num_calls);
}

// An open database; its errors name the file.
class Database {
 public:
  explicit Database(const std::filesystem::path& path) : path_(path.string()) {
    const int code = sqlite3_open_v2(ImmutableUri(path).c_str(), &handle_,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    if (code == SQLITE_OK) {
      Restrict(handle_, &num_calls_);
      return;
    }
    const std::string reason = sqlite3_errstr(code);
    sqlite3_close(handle_);
    throw IoError(path_, "cannot be opened: " + reason);
  }
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database() { sqlite3_close(handle_); }

  const std::string& path() const { return path_; }
  sqlite3* handle() const { return handle_; }
  [[noreturn]] void Fail() const {
    switch (sqlite3_errcode(handle_)) {
      case SQLITE_INTERRUPT:
        throw IoError(path_, "takes more work than any database of COLMAP");
      case SQLITE_TOOBIG:
        throw IoError(path_, "has a value of more than " + std::to_string(kMaxValueBytes) +
                                 " bytes where COLMAP has short ones");
      default:
        throw IoError(path_, Printable(sqlite3_errmsg(handle_)));
    }
  }

 private:
  std::string path_;
  sqlite3* handle_ = nullptr;
  int num_calls_ = 0;
};

// Iterates over the rows of a query.
class Rows {
 public:
  Rows(const Database& database, const std::string& query) : database_(database) {
    if (sqlite3_prepare_v2(database.handle(), query.c_str(), -1, &statement_, nullptr) !=
        SQLITE_OK) {
      database.Fail();
    }
  }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  ~Rows() { sqlite3_finalize(statement_); }

  bool Next() {
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) database_.Fail();
    return code == SQLITE_ROW;
  }
  std::string Text(int column) const {
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return text ? text : "";
  }
  int Int(int column) const { return sqlite3_column_int(statement_, column); }
  // Nothing for NULL and what is not finite.
  std::optional<double> Number(int column) const {
    if (sqlite3_column_type(statement_, column) == SQLITE_NULL) return std::nullopt;
    const double number = sqlite3_column_double(statement_, column);
    return std::isfinite(number) ? std::optional(number) : std::nullopt;
  }
  // The numbers of a blob, as COLMAP stores matrices; the same.
  template <typename Matrix>
  std::optional<Matrix> Numbers(int column, const std::string& image) const {
    const auto size = static_cast<size_t>(sqlite3_column_bytes(statement_, column));
    if (size == 0) return std::nullopt;
    Matrix matrix;
    if (size != matrix.size() * sizeof(double)) {
      throw IoError(database_.path(), "prior of image \"" + Printable(image) + "\"",
                    std::string(sqlite3_column_name(statement_, column)) + " has " +
                        std::to_string(size) + " bytes, not " +
                        std::to_string(matrix.size() * sizeof(double)));
    }
    std::memcpy(matrix.data(), sqlite3_column_blob(statement_, column), size);
    return matrix.allFinite() ? std::optional(matrix) : std::nullopt;
  }

 private:
  const Database& database_;
  sqlite3_stmt* statement_ = nullptr;
};

// Views and virtual tables are programs; they have no pages. None of the name is no table, either.
bool IsTable(const Database& database, const std::string& name) {
  Rows rows(database,
            "SELECT type, rootpage FROM sqlite_master WHERE type IN ('table', 'view') "
            "AND name = '" +
                name + "' COLLATE NOCASE");
  bool is_table = false;
  while (rows.Next()) {
    is_table = true;
    if (rows.Text(0) == "table" && rows.Int(1) > 0) continue;
    throw IoError(database.path(), name +
                                       " is a view or a virtual table, not a table as COLMAP "
                                       "makes them: nothing of it is run");
  }
  return is_table;
}

// False of columns that are computed, which are programs, too.
bool HasColumn(const Database& database, const std::string& table, const std::string& column) {
  if (!IsTable(database, table)) return false;
  Rows rows(database, "SELECT name, hidden FROM pragma_table_xinfo('" + table + "')");
  while (rows.Next()) {
    if (rows.Text(0) != column) continue;
    if (rows.Int(1) == 0) return true;
    throw IoError(database.path(), "column " + column + " of " + table +
                                       " is computed, not stored: nothing of it is run");
  }
  return false;
}

void ExpectColumns(const Database& database, const std::string& table,
                   const std::vector<std::string>& columns) {
  if (!IsTable(database, table)) throw IoError(database.path(), "has no table " + table);
  for (const std::string& column : columns) {
    if (HasColumn(database, table, column)) continue;
    throw IoError(database.path(), "table " + table + " has no column " + column);
  }
}

// Latitude, longitude and altitude.
bool IsOnEarth(const Eigen::Vector3d& position) {
  return std::abs(position.x()) <= 90 && std::abs(position.y()) <= 360 &&
         std::abs(position.z()) <= 1e6;
}

std::string WhyNotOnEarth(const Eigen::Vector3d& position) {
  const Eigen::Vector3d exchanged(position.y(), position.x(), position.z());
  return std::string("is not a latitude, longitude and altitude") +
         (IsOnEarth(exchanged) ? "; it would be with latitude and longitude exchanged" : "");
}

// Cameras without satellites write zeros.
bool IsNowhere(const PosePrior& prior) {
  return prior.is_geographic && prior.position && prior.position->head<2>().isZero(0);
}

void Check(const Database& database, const PosePriors& priors) {
  const PosePrior* first = nullptr;
  for (const auto& [image, prior] : priors) {
    if (!prior.position) continue;
    const std::string place = "prior of image \"" + Printable(image) + "\"";
    if (prior.is_geographic && !IsOnEarth(*prior.position)) {
      throw IoError(database.path(), place, WhyNotOnEarth(*prior.position));
    }
    if (!first) first = &prior;
    if (prior.is_geographic != first->is_geographic) {
      throw IoError(database.path(), place, "is in another coordinate system than others");
    }
  }
}

// Of COLMAP 3.10 and later.
PosePriors ReadPriorTable(const Database& database, const std::set<std::string>& images) {
  const auto or_null = [&](const char* column) {
    return HasColumn(database, "pose_priors", column) ? std::string(column)
                                                      : "NULL AS " + std::string(column);
  };
  // COLMAP 4 has priors of any sensor; cameras are of type 0, and their data are images.
  const bool has_sensors = HasColumn(database, "pose_priors", "corr_data_id");
  ExpectColumns(database, "images", {"image_id", "name"});
  ExpectColumns(database, "pose_priors",
                {"coordinate_system", has_sensors ? "corr_sensor_type" : "image_id"});
  Rows rows(database, "SELECT images.name, position, coordinate_system, " +
                          or_null("position_covariance") + ", " + or_null("gravity") +
                          " FROM pose_priors JOIN images ON images.image_id = pose_priors." +
                          (has_sensors ? "corr_data_id WHERE corr_sensor_type = 0" : "image_id"));
  PosePriors priors;
  while (rows.Next()) {
    const std::string image = Utf8Name(rows.Text(0));
    if (!images.contains(image)) continue;
    PosePrior prior;
    prior.position = rows.Numbers<Eigen::Vector3d>(1, image);
    prior.is_geographic = rows.Int(2) == kSystemWgs84;
    if (IsNowhere(prior)) prior.position.reset();
    const auto covariance = rows.Numbers<Eigen::Matrix3d>(3, image);
    if (covariance && covariance->trace() > 0) {
      prior.position_sigma = std::sqrt(covariance->trace() / 3);
    }
    prior.gravity = rows.Numbers<Eigen::Vector3d>(4, image);
    if (prior.gravity && !(prior.gravity->norm() > 0)) prior.gravity.reset();
    if (prior.position || prior.gravity) priors[image] = prior;
  }
  return priors;
}

// From older COLMAP: positions from the photographs' EXIF data, or poses stored by a user.
PosePriors ReadImageColumns(const Database& database, const std::set<std::string>& images) {
  ExpectColumns(database, "images",
                {"name", "prior_qw", "prior_qx", "prior_qy", "prior_qz", "prior_ty", "prior_tz"});
  Rows rows(database,
            "SELECT name, prior_qw, prior_qx, prior_qy, prior_qz, prior_tx, prior_ty, prior_tz "
            "FROM images");
  PosePriors priors;
  while (rows.Next()) {
    const std::string image = Utf8Name(rows.Text(0));
    if (!images.contains(image)) continue;
    const auto x = rows.Number(5), y = rows.Number(6), z = rows.Number(7);
    if (!x || !y || !z) continue;
    const Eigen::Vector3d translation(*x, *y, *z);
    const Eigen::Quaterniond rotation(rows.Number(1).value_or(0), rows.Number(2).value_or(0),
                                      rows.Number(3).value_or(0), rows.Number(4).value_or(0));
    PosePrior prior;
    prior.is_geographic = !(rotation.norm() > 0);
    prior.position = prior.is_geographic
                         ? translation
                         : Eigen::Vector3d(-(rotation.normalized().conjugate() * translation));
    if (!IsNowhere(prior)) priors[image] = prior;
  }
  const bool on_earth = std::all_of(priors.begin(), priors.end(), [](const auto& item) {
    return !item.second.is_geographic || IsOnEarth(*item.second.position);
  });
  if (on_earth) return priors;
  for (auto& [image, prior] : priors) prior.is_geographic = false;
  return priors;
}

}  // namespace

PosePriors ReadPosePriors(const std::filesystem::path& path, const std::set<std::string>& images) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    throw IoError(path.string(), "is not a file");
  const DatabaseState state = CheckHasNoJournal(path);
  const Database database(path);
  const bool has_table = HasColumn(database, "pose_priors", "position");
  if (!has_table && !HasColumn(database, "images", "prior_tx")) {
    throw IoError(path.string(), "is not a database of COLMAP: it has no table pose_priors");
  }
  PosePriors priors =
      has_table ? ReadPriorTable(database, images) : ReadImageColumns(database, images);
  Check(database, priors);
  CheckIsUnchanged(path, state);
  return priors;
}

}  // namespace limn::colmap_ext
