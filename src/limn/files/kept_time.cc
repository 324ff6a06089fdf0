// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/kept_time.h"

#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>

#include "limn/util/errors.h"

namespace limn {

KeptTime::KeptTime(const OutputPath& path)
    : path_(path), folder_(WritableFolder::Make(path.Folder())), changed_(ChangeOfFile()) {}

void KeptTime::Restore() const {
  const timespec times[] = {{.tv_sec = 0, .tv_nsec = UTIME_OMIT},
                            {.tv_sec = changed_.seconds, .tv_nsec = changed_.nanoseconds}};
  const int folder = folder_.descriptor();
  if (utimensat(folder, path_.Name().c_str(), times, AT_SYMLINK_NOFOLLOW) != 0) Fail();
}

FileTime KeptTime::ChangeOfFile() const {
  const auto status = folder_.StatusOf(path_.Name());
  if (!status) Fail();
  return status->changed;
}

void KeptTime::Fail() const {
  throw IoError(path_.string(),
                std::string("its time of change cannot be kept: ") + std::strerror(errno));
}

}  // namespace limn
