#include "limn/viewer/packing.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include <zlib.h>

namespace limn {

std::string Gzip(std::string_view bytes) {
  constexpr int kGzipWindow = 15 + 16;  // 32 KiB, with gzip's header
  constexpr int kMemoryLevel = 9;
  // The best one takes half as long again and saves less than 1 % of a drawing.
  constexpr int kLevel = 6;
  constexpr size_t kBlock = 1 << 18;
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

std::string Base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
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

}  // namespace limn
