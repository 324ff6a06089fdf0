// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/packed_numbers.h"

#include <array>
#include <cmath>

#include <zlib.h>

namespace limn {
namespace {

// Bytes with more bits of entropy are left as they are: deflating them takes time and saves little.
constexpr double kMaxEntropyBits = 7.6;
// No deflated stream is longer by more than this factor when inflated.
constexpr size_t kMaxInflation = 1032;

double EntropyBits(std::string_view bytes) {
  std::array<size_t, 256> counts{};
  for (const char byte : bytes) ++counts[static_cast<unsigned char>(byte)];
  double bits = 0;
  for (const size_t count : counts) {
    if (count == 0) continue;
    const double share = static_cast<double>(count) / static_cast<double>(bytes.size());
    bits -= share * std::log2(share);
  }
  return bits;
}

std::string Deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string deflated(size, '\0');
  compress2(reinterpret_cast<Bytef*>(deflated.data()), &size,
            reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_SPEED);
  deflated.resize(size);
  return deflated;
}

// With whether they are deflated.
void PutBytes(std::string_view bytes, ByteWriter* out) {
  std::string deflated;
  if (EntropyBits(bytes) < kMaxEntropyBits) deflated = Deflated(bytes);
  const bool is_deflated = !deflated.empty() && deflated.size() < bytes.size();
  out->Put<uint8_t>(is_deflated);
  if (is_deflated) out->PutCount(deflated.size());
  const std::string_view put = is_deflated ? std::string_view(deflated) : bytes;
  out->PutArray(put.data(), put.size());
}

std::string GetBytes(size_t count, ByteReader* in) {
  if (!in->GetFlag()) return std::string(in->Take(count));
  const std::string_view deflated = in->Take(in->GetCount(1));
  in->Check(count / kMaxInflation <= deflated.size(), "deflated bytes are too few");
  std::string bytes(count, '\0');
  uLongf size = count;
  const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                reinterpret_cast<const Bytef*>(deflated.data()), deflated.size());
  in->Check(result == Z_OK && size == count, "deflated bytes are damaged");
  return bytes;
}

}  // namespace

namespace internal {

void PutPlanes(std::string_view items, size_t item_bytes, ByteWriter* out) {
  const size_t num_items = items.size() / item_bytes;
  std::string plane(num_items, '\0');
  for (size_t k = 0; k < item_bytes; ++k) {
    for (size_t i = 0; i < num_items; ++i) plane[i] = items[i * item_bytes + k];
    PutBytes(plane, out);
  }
}

std::string GetPlanes(size_t num_items, size_t item_bytes, ByteReader* in) {
  std::string items;
  for (size_t k = 0; k < item_bytes; ++k) {
    const std::string plane = GetBytes(num_items, in);
    items.resize(num_items * item_bytes);
    for (size_t i = 0; i < num_items; ++i) items[i * item_bytes + k] = plane[i];
  }
  return items;
}

size_t GetNumItems(ByteReader* in) {
  const uint64_t count = in->Get<uint64_t>();
  in->Check(count / kMaxInflation <= in->Remaining(), "more numbers than bytes");
  return count;
}

}  // namespace internal

void PutPackedText(std::string_view text, ByteWriter* out) {
  out->PutCount(text.size());
  PutBytes(text, out);
}

std::string GetPackedText(ByteReader* in) { return GetBytes(internal::GetNumItems(in), in); }

void StepWriter::PutUnsigned(uint64_t number) {
  for (; number >= 128; number >>= 7) bytes_.push_back(static_cast<char>(number | 128));
  bytes_.push_back(static_cast<char>(number));
}

void StepWriter::Finish(ByteWriter* out) const { PutPackedText(bytes_, out); }

StepReader::StepReader(ByteReader* in) : in_(in), bytes_(GetPackedText(in)) {}

uint64_t StepReader::GetUnsigned() {
  uint64_t number = 0;
  for (int shift = 0;; shift += 7) {
    in_->Check(at_ < bytes_.size() && shift < 64, "a number is cut off");
    const auto byte = static_cast<unsigned char>(bytes_[at_++]);
    number |= static_cast<uint64_t>(byte & 127) << shift;
    if (byte < 128) return number;
  }
}

int64_t StepReader::Get() {
  const uint64_t folded = GetUnsigned();
  const auto step = static_cast<int64_t>(folded >> 1 ^ -(folded & 1));
  last_ = static_cast<int64_t>(static_cast<uint64_t>(last_) + static_cast<uint64_t>(step));
  return last_;
}

size_t StepReader::GetCount() {
  const uint64_t count = GetUnsigned();
  in_->Check(count <= bytes_.size() - at_, "a count is larger than what follows");
  return count;
}

void StepReader::ExpectEnd() const {
  in_->Check(at_ == bytes_.size(), "numbers follow the last one");
}

}  // namespace limn
