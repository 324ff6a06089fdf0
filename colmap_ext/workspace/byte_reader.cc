#include "colmap_ext/workspace/byte_reader.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <utility>

#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

constexpr size_t kMaxNameBytes = 4096;

// A count that is really text (an LFS pointer, an HTML page, a text model under a wrong name).
bool LooksLikeText(uint64_t count) {
  char bytes[sizeof(count)];
  std::memcpy(bytes, &count, sizeof(count));
  return std::all_of(std::begin(bytes), std::end(bytes), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isprint(byte) || std::isspace(byte);
  });
}

}  // namespace

ByteReader::ByteReader(std::istream& in, std::string path) : in_(in), path_(std::move(path)) {
  const auto begin = in_.tellg();
  in_.seekg(0, std::ios::end);
  const auto end = in_.tellg();
  in_.seekg(begin);
  if (!in_ || begin < 0 || end < begin) throw IoError(path_, "cannot be read");
  size_ = static_cast<uint64_t>(end - begin);
}

void ByteReader::ReadBytes(void* out, uint64_t size, const char* what) {
  if (size > Remaining()) {
    Here().Fail("truncated: " + std::to_string(size) + " bytes expected for " + what + ", " +
                std::to_string(Remaining()) + " left");
  }
  in_.read(static_cast<char*>(out), static_cast<std::streamsize>(size));
  if (!in_) Here().Fail(std::string("read error in ") + what);
  offset_ += size;
}

uint64_t ByteReader::ReadCount(const char* what, uint64_t min_record_bytes) {
  const uint64_t at = offset_;
  const uint64_t count = Read<uint64_t>(what);
  if (count > Remaining() / min_record_bytes) {
    if (at == 0 && LooksLikeText(count)) At(at).Fail("text, not a binary COLMAP file");
    At(at).Fail(std::string(what) + " = " + std::to_string(count) + " does not fit the remaining " +
                std::to_string(Remaining()) + " bytes: truncated, or not a COLMAP file");
  }
  return count;
}

std::string ByteReader::ReadName(const char* what) {
  const Place start = Here();
  std::string name;
  for (char c = Read<char>(what); c != '\0'; c = Read<char>(what)) {
    if (name.size() == kMaxNameBytes) {
      start.Fail(std::string(what) + " is longer than " + std::to_string(kMaxNameBytes) + " bytes");
    }
    name += c;
  }
  return name;
}

void ByteReader::CheckEnd() const {
  if (Remaining() == 0) return;
  Here().Fail(std::to_string(Remaining()) +
              " bytes after the last record: not a COLMAP file, or damaged");
}

}  // namespace limn::colmap_ext
