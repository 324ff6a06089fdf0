// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/database_journal.h"

#include <array>
#include <cstddef>
#include <fstream>
#include <string>
#include <system_error>

#include "colmap_ext/workspace/camera_files.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

// First bytes of SQLite's files. A journal whose first bytes are zero was committed; a log without
// a frame has its header at most.
constexpr std::array<unsigned char, 4> kJournalMagic = {0xd9, 0xd5, 0x05, 0xf9};
constexpr std::array<unsigned char, 3> kLogMagic = {0x37, 0x7f, 0x06};
constexpr uintmax_t kLogHeaderBytes = 32;

// Where SQLite has the files of a database, which may be a link.
fs::path Beside(const fs::path& database, const char* suffix) {
  std::error_code error;
  const fs::path real = fs::canonical(database, error);
  return (error ? database : real).string() + suffix;
}

template <size_t kSize>
bool MayBegin(const fs::path& path, const std::array<unsigned char, kSize>& magic) {
  std::array<char, kSize> bytes = {};
  std::ifstream in(path, std::ios::binary);
  if (!in) return true;  // one that cannot be read may be anything
  if (!in.read(bytes.data(), kSize)) return false;
  for (size_t i = 0; i < kSize; ++i) {
    if (static_cast<unsigned char>(bytes[i]) != magic[i]) return false;
  }
  return true;
}

[[noreturn]] void FailUnfinished(const fs::path& database, const fs::path& journal,
                                 const char* what) {
  throw IoError(database.string(), journal.string() + what +
                                       ": a program is writing to the database, or was stopped "
                                       "while it did; close it, or if none runs let sqlite3 finish "
                                       "its work: sqlite3 " +
                                       ShellWord(database.string()) +
                                       " \"PRAGMA wal_checkpoint; SELECT "
                                       "count(*) FROM sqlite_master\"");
}

}  // namespace

DatabaseState CheckHasNoJournal(const fs::path& database) {
  const fs::path journal = Beside(database, "-journal"), log = Beside(database, "-wal");
  std::error_code ignored;
  if (fs::is_regular_file(journal, ignored) && MayBegin(journal, kJournalMagic)) {
    FailUnfinished(database, journal, " would undo changes that are not finished");
  }
  if (fs::is_regular_file(log, ignored) && fs::file_size(log, ignored) > kLogHeaderBytes &&
      MayBegin(log, kLogMagic)) {
    FailUnfinished(database, log, " has changes that are not in the database yet");
  }
  DatabaseState state;
  state.size = fs::file_size(database, ignored);
  state.changed = fs::last_write_time(database, ignored);
  return state;
}

void CheckIsUnchanged(const fs::path& database, const DatabaseState& since) {
  if (CheckHasNoJournal(database) == since) return;
  throw IoError(database.string(), "was changed while it was read: run this again");
}

}  // namespace limn::colmap_ext
