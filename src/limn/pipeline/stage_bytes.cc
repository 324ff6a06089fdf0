#include "limn/pipeline/stage_bytes.h"

#include <bit>

#include "limn/util/errors.h"

namespace limn {

static_assert(std::endian::native == std::endian::little, "stage files are little-endian");

std::string ByteSource::GetText() {
  const std::vector<char> characters = GetArray<char>();
  return {characters.begin(), characters.end()};
}

size_t ByteSource::TakeCount(size_t item_size) {
  const uint64_t count = Get<uint64_t>();
  if (count > (bytes_.size() - position_) / item_size) {
    Fail("a list of " + std::to_string(count) + " items does not fit into the file");
  }
  return count;
}

std::string_view ByteSource::Take(size_t size) {
  if (size > bytes_.size() - position_) Fail("the file ends too early");
  const std::string_view taken = bytes_.substr(position_, size);
  position_ += size;
  return taken;
}

void ByteSource::Fail(const std::string& reason) const {
  throw IoError(path_, "byte " + std::to_string(position_), reason);
}

void ByteSource::ExpectEnd() const {
  if (position_ != bytes_.size()) Fail("data after the end");
}

}  // namespace limn
