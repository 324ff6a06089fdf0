// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/file_buffer.h"

#include <algorithm>
#include <cerrno>

#include <unistd.h>

namespace limn {

FileBuffer::FileBuffer(FileDescriptor file) : file_(std::move(file)), buffer_(1 << 16) {
  setp(buffer_.data(), buffer_.data() + buffer_.size());
}

bool FileBuffer::WriteAll(const char* bytes, size_t size) {
  while (size > 0) {
    const ssize_t written = write(file_.number(), bytes, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes += written;
    size -= static_cast<size_t>(written);
  }
  return true;
}

bool FileBuffer::Flush() {
  const auto size = static_cast<size_t>(pptr() - pbase());
  setp(buffer_.data(), buffer_.data() + buffer_.size());
  return !file_.IsOpen() || WriteAll(buffer_.data(), size);
}

bool FileBuffer::Close() {
  const bool is_flushed = Flush();
  const int number = file_.Release();
  return is_flushed && (number < 0 || close(number) == 0);
}

FileBuffer::int_type FileBuffer::overflow(int_type c) {
  if (!Flush()) return traits_type::eof();
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  *pptr() = traits_type::to_char_type(c);
  pbump(1);
  return c;
}

std::streamsize FileBuffer::xsputn(const char* bytes, std::streamsize size) {
  if (size > epptr() - pptr() && !Flush()) return 0;
  if (size > epptr() - pptr()) return WriteAll(bytes, static_cast<size_t>(size)) ? size : 0;
  std::copy(bytes, bytes + size, pptr());
  pbump(static_cast<int>(size));
  return size;
}

}  // namespace limn
