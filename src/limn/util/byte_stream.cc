// SPDX-License-Identifier: BSD-3-Clause
#include "limn/util/byte_stream.h"

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr size_t kBlockBytes = 1 << 16;

}  // namespace

ByteReader::ByteReader(std::string path, std::string_view bytes)
    : path_(std::move(path)), window_(bytes), size_(bytes.size()) {}

ByteReader::ByteReader(std::string path, std::istream& in) : path_(std::move(path)), in_(&in) {
  const auto begin = in.tellg();
  in.seekg(0, std::ios::end);
  const auto end = in.tellg();
  in.seekg(begin);
  if (!in || begin < 0 || end < begin) throw IoError(path_, "cannot be read");
  size_ = static_cast<uint64_t>(end - begin);
}

size_t ByteReader::GetCount(size_t item_bytes) {
  const uint64_t count = Get<uint64_t>("a count");
  if (count > Remaining() / item_bytes) {
    Fail("count " + std::to_string(count) + " exceeds the file");
  }
  return count;
}

std::string_view ByteReader::Take(size_t count) {
  ExpectBytes(count, "a string");
  if (count > window_.size()) Refill(count, "a string");
  const std::string_view taken = window_.substr(0, count);
  Advance(count);
  return taken;
}

void ByteReader::ExpectEnd() const {
  if (Remaining() == 0) return;
  Fail(std::to_string(Remaining()) + " bytes after the last record: another format, or damaged");
}

void ByteReader::CopyAcross(void* out, size_t count, const char* what) {
  ExpectBytes(count, what);
  char* to = static_cast<char*>(out);
  const size_t ready = window_.copy(to, window_.size());
  Advance(ready);
  to += ready;
  count -= ready;
  if (count >= kBlockBytes) {
    ReadStream(to, count, what);
    at_ += count;
    return;
  }
  Refill(count, what);
  std::memcpy(to, window_.data(), count);
  Advance(count);
}

void ByteReader::ExpectBytes(uint64_t count, const char* what) const {
  if (count <= Remaining()) return;
  Fail("truncated: " + std::to_string(count) + " bytes expected for " + what + ", " +
       std::to_string(Remaining()) + " left");
}

void ByteReader::Refill(size_t count, const char* what) {
  std::string block(std::min<uint64_t>(std::max(count, kBlockBytes), Remaining()), '\0');
  const size_t kept = window_.copy(block.data(), window_.size());
  ReadStream(block.data() + kept, block.size() - kept, what);
  buffer_ = std::move(block);
  window_ = buffer_;
}

void ByteReader::ReadStream(char* out, size_t count, const char* what) {
  in_->read(out, static_cast<std::streamsize>(count));
  if (!*in_) Fail(std::string("read error in ") + what);
}

}  // namespace limn
