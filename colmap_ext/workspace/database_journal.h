// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>

namespace limn::colmap_ext {

// The state of a SQLite database that is read without locks.
struct DatabaseState {
  uintmax_t size = 0;
  std::filesystem::file_time_type changed;

  bool operator==(const DatabaseState&) const = default;
};

// Throws IoError if the file alone may not hold what was stored last: a rollback journal beside it
// that would undo half of a change, or a write-ahead log with changes that are only in there. A
// program is writing then, or was stopped while it did. Journals that are empty or void do not
// count.
DatabaseState CheckHasNoJournal(const std::filesystem::path& database);

// Throws IoError if the database has a journal now, or has changed since.
void CheckIsUnchanged(const std::filesystem::path& database, const DatabaseState& since);

}  // namespace limn::colmap_ext
