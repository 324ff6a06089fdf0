// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <streambuf>
#include <vector>

#include "limn/files/file_descriptor.h"

namespace limn {

// Writes what a stream puts out to an open file. Where a write fails the stream does, and errno
// tells why.
class FileBuffer : public std::streambuf {
 public:
  explicit FileBuffer(FileDescriptor file);
  ~FileBuffer() override { Flush(); }

  // Also closes the file. Returns whether all was written.
  bool Close();

 protected:
  int_type overflow(int_type c) override;
  int sync() override { return Flush() ? 0 : -1; }
  std::streamsize xsputn(const char* bytes, std::streamsize size) override;

 private:
  bool Flush();
  bool WriteAll(const char* bytes, size_t size);

  FileDescriptor file_;
  std::vector<char> buffer_;
};

}  // namespace limn
