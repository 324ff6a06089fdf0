// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/packing.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include <zlib.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr int kGzipWindow = 15 + 16;  // 32 KiB, with gzip's header
constexpr size_t kBlock = 1 << 18;
constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// -1 for what is no digit.
std::array<int8_t, 256> ValuesOfDigits() {
  std::array<int8_t, 256> values;
  values.fill(-1);
  for (int8_t value = 0; value < 64; ++value) values[static_cast<uint8_t>(kDigits[value])] = value;
  return values;
}

}  // namespace

std::string Gzip(std::string_view bytes) {
  constexpr int kMemoryLevel = 9;
  // The best one takes half as long again and saves less than 1 % of a drawing.
  constexpr int kLevel = 6;
  z_stream stream = {};
  if (deflateInit2(&stream, kLevel, Z_DEFLATED, kGzipWindow, kMemoryLevel, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::runtime_error("zlib cannot be initialized");
  }
  std::string packed;
  int status = Z_OK;
  size_t taken = 0;
  while (status == Z_OK) {
    const size_t chunk = std::min(bytes.size() - taken, kBlock);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + taken));
    stream.avail_in = static_cast<uInt>(chunk);
    const size_t at = packed.size();
    packed.resize(at + kBlock);
    stream.next_out = reinterpret_cast<Bytef*>(packed.data() + at);
    stream.avail_out = static_cast<uInt>(kBlock);
    status = deflate(&stream, taken + chunk == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    taken += chunk - stream.avail_in;
    packed.resize(packed.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::runtime_error("zlib cannot pack");
  return packed;
}

std::string Gunzip(std::string_view packed, size_t max_bytes) {
  z_stream stream = {};
  if (inflateInit2(&stream, kGzipWindow) != Z_OK) throw std::runtime_error("zlib: no memory");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end(&stream, &inflateEnd);
  std::string bytes;
  size_t taken = 0;
  for (int status = Z_OK; status != Z_STREAM_END;) {
    const size_t chunk = std::min(packed.size() - taken, kBlock);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
    stream.avail_in = static_cast<uInt>(chunk);
    const size_t at = bytes.size();
    bytes.resize(at + kBlock);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + at);
    stream.avail_out = static_cast<uInt>(kBlock);
    status = inflate(&stream, Z_NO_FLUSH);
    taken += chunk - stream.avail_in;
    bytes.resize(bytes.size() - stream.avail_out);
    if (status != Z_OK && status != Z_STREAM_END) throw InputError("is damaged: no gzip data");
    if (bytes.size() > max_bytes) {
      throw InputError("unpacks to more than " + std::to_string(max_bytes) + " bytes");
    }
  }
  return bytes;
}

std::string Base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t at = 0; at < bytes.size(); at += 3) {
    const size_t count = std::min<size_t>(3, bytes.size() - at);
    uint32_t triple = 0;
    for (size_t i = 0; i < 3; ++i) {
      triple = triple << 8 | (i < count ? static_cast<uint8_t>(bytes[at + i]) : 0);
    }
    for (size_t i = 0; i < 4; ++i) {
      text += i <= count ? kDigits[triple >> (18 - 6 * i) & 63] : '=';
    }
  }
  return text;
}

std::string Unbase64(std::string_view text) {
  const std::array<int8_t, 256> values = ValuesOfDigits();
  if (text.size() % 4 != 0) throw InputError("is cut off: no whole base64");
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  uint32_t bits = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    const int value = values[static_cast<uint8_t>(text[i])];
    if (value < 0) throw InputError("is damaged: no base64");
    bits = bits << 6 | static_cast<uint32_t>(value);
    if (i % 4 != 0) bytes += static_cast<char>(bits >> (6 - 2 * (i % 4)) & 255);
  }
  return bytes;
}

}  // namespace limn
