// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/image_header.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string_view>

#include "colmap_ext/workspace/stream_bytes.h"
#include "colmap_ext/workspace/tiff_directory.h"

namespace limn::colmap_ext {
namespace {

constexpr std::array<int, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

// Whether these bytes come next; reads no further than the first that differs.
bool Follows(std::istream& in, std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(),
                     [&](char byte) { return in.get() == static_cast<unsigned char>(byte); });
}

std::optional<ImageSize> CheckedSize(int64_t width, int64_t height) {
  if (width <= 0 || height <= 0 || width > INT32_MAX || height > INT32_MAX) return std::nullopt;
  return ImageSize{static_cast<int>(width), static_cast<int>(height)};
}

// After the first byte of the signature.
std::optional<ImageSize> ReadPng(std::istream& in) {
  for (size_t i = 1; i < kPngSignature.size(); ++i) {
    if (in.get() != kPngSignature[i]) return std::nullopt;
  }
  in.ignore(8);  // length and name of the IHDR chunk
  const int64_t width = ReadBigEndian(in, 4);
  return CheckedSize(width, ReadBigEndian(in, 4));
}

// Start-of-frame markers hold the size; C4, C8 and CC in their range are something else.
bool IsStartOfFrame(int marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

// TEM, restarts and the start of the image have no length.
bool HasLength(int marker) { return marker != 0x01 && (marker < 0xD0 || marker > 0xD8); }

// The kind of the next marker with a length, which decoders find behind any other bytes; -1 at the
// end.
int NextMarker(std::istream& in) {
  int byte = in.get();
  while (byte >= 0) {
    while (byte >= 0 && byte != 0xFF) byte = in.get();
    while (byte == 0xFF) byte = in.get();
    if (byte > 0 && HasLength(byte)) return byte;
  }
  return -1;
}

// After the first byte of the start-of-image marker.
std::optional<ImageSize> ReadJpeg(std::istream& in) {
  if (in.get() != 0xD8) return std::nullopt;
  for (int marker = NextMarker(in); marker >= 0; marker = NextMarker(in)) {
    const int64_t length = ReadBigEndian(in, 2);
    if (length < 2) return std::nullopt;
    if (IsStartOfFrame(marker)) {
      in.ignore(1);  // bits per sample
      const int64_t height = ReadBigEndian(in, 2);
      return CheckedSize(ReadBigEndian(in, 2), height);
    }
    in.ignore(length - 2);
  }
  return std::nullopt;
}

// The largest picture.
std::optional<ImageSize> ReadTiff(std::istream& in) {
  const auto directory = LargestTiffDirectory(in);
  return directory ? std::optional(directory->size) : std::nullopt;
}

// After the first byte. The height is negative in files whose first row is the top one.
std::optional<ImageSize> ReadBmp(std::istream& in) {
  if (in.get() != 'M') return std::nullopt;
  in.ignore(12);
  constexpr int64_t kOldHeader = 12;
  const int num_bytes = ReadLittleEndian(in, 4) == kOldHeader ? 2 : 4;
  const int64_t width = ReadLittleEndian(in, num_bytes);
  const int64_t height = ReadLittleEndian(in, num_bytes);
  return CheckedSize(width, height > INT32_MAX ? (int64_t{1} << 32) - height : height);
}

// After the first byte. Lossy, lossless or extended.
std::optional<ImageSize> ReadWebp(std::istream& in) {
  if (!Follows(in, "IFF")) return std::nullopt;
  in.ignore(4);
  if (!Follows(in, "WEBPVP8")) return std::nullopt;
  const int kind = in.get();
  in.ignore(4);
  if (kind == 'L') {
    in.ignore(1);
    const int64_t bits = ReadLittleEndian(in, 4);
    if (bits < 0) return std::nullopt;
    return CheckedSize((bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1);
  }
  if (kind == 'X') {
    in.ignore(4);
    const int64_t width = ReadLittleEndian(in, 3);
    const int64_t height = ReadLittleEndian(in, 3);
    return height < 0 ? std::nullopt : CheckedSize(width + 1, height + 1);
  }
  in.ignore(6);
  const int64_t width = ReadLittleEndian(in, 2);
  const int64_t height = ReadLittleEndian(in, 2);
  return height < 0 ? std::nullopt : CheckedSize(width & 0x3FFF, height & 0x3FFF);
}

// After the first byte of a stream of JPEG 2000 codes.
std::optional<ImageSize> ReadJpeg2000Codes(std::istream& in) {
  if (!Follows(in, "\x4F\xFF\x51")) return std::nullopt;
  in.ignore(4);
  const int64_t right = ReadBigEndian(in, 4);
  const int64_t bottom = ReadBigEndian(in, 4);
  const int64_t left = ReadBigEndian(in, 4);
  const int64_t top = ReadBigEndian(in, 4);
  return top < 0 ? std::nullopt : CheckedSize(right - left, bottom - top);
}

// After the first byte. The codes are in one of the boxes.
std::optional<ImageSize> ReadJpeg2000(std::istream& in) {
  if (ReadBigEndian(in, 3) != 12 || !Follows(in, "jP  ")) return std::nullopt;
  in.ignore(4);
  while (true) {
    int64_t length = ReadBigEndian(in, 4);
    const int64_t type = ReadBigEndian(in, 4);
    const bool is_long = length == 1;
    if (is_long) length = ReadBigEndian(in, 8);
    constexpr int64_t kCodes = 0x6A703263;  // jp2c
    if (type == kCodes) return in.get() == 0xFF ? ReadJpeg2000Codes(in) : std::nullopt;
    const int64_t header = is_long ? 16 : 8;
    if (length < header || type < 0) return std::nullopt;
    in.seekg(length - header, std::ios::cur);
  }
}

// After the first byte: the width and the height in words, between spaces and comments.
std::optional<ImageSize> ReadPnm(std::istream& in) {
  const int kind = in.get();
  if (kind < '1' || kind > '6') return std::nullopt;
  const auto next_number = [&]() -> int64_t {
    int byte = in.get();
    while (byte == '#' || std::isspace(byte)) {
      if (byte == '#') in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      byte = in.get();
    }
    int64_t value = -1;
    for (; std::isdigit(byte) && value <= INT32_MAX; byte = in.get()) {
      value = std::max<int64_t>(value, 0) * 10 + byte - '0';
    }
    return value;
  };
  const int64_t width = next_number();
  return CheckedSize(width, next_number());
}

// After the first byte.
std::optional<ImageSize> ReadSunRaster(std::istream& in) {
  if (!Follows(in, "\xA6\x6A\x95")) return std::nullopt;
  const int64_t width = ReadBigEndian(in, 4);
  return CheckedSize(width, ReadBigEndian(in, 4));
}

// After the signature.
bool PngIsTruncated(std::istream& in) {
  in.ignore(static_cast<std::streamsize>(kPngSignature.size()) - 1);
  while (true) {
    const int64_t length = ReadBigEndian(in, 4);
    const int64_t type = ReadBigEndian(in, 4);
    if (length < 0 || type < 0) return true;
    constexpr int64_t kEnd = 0x49454E44;  // IEND, without data
    if (type == kEnd) return ReadBigEndian(in, 4) < 0;
    in.seekg(length + 4, std::ios::cur);  // and the checksum
  }
}

// After the first byte of the start-of-image marker. In a scan 0xFF is followed by 0 or by a
// marker.
bool JpegIsTruncated(std::istream& in) {
  in.get();
  for (int marker = NextMarker(in); marker >= 0; marker = NextMarker(in)) {
    const int64_t length = ReadBigEndian(in, 2);
    if (length < 2) return true;
    in.seekg(length - 2, std::ios::cur);
    if (marker != 0xDA) continue;
    int before = 0;
    for (int byte = in.get(); byte >= 0; before = byte, byte = in.get()) {
      if (before == 0xFF && byte == 0xD9) return false;
    }
    return true;
  }
  return true;
}

}  // namespace

ImageFormat FormatOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  switch (ReadBigEndian(in, 2)) {
    case 0xFFD8:
      return ImageFormat::kJpeg;
    case 0:
    case 0xFF4F:
      return ImageFormat::kJpeg2000;
    case 0x4949:  // II
    case 0x4D4D:  // MM
      return ImageFormat::kTiff;
    case 0x5249:  // RI
      return ImageFormat::kWebp;
    default:
      return ImageFormat::kOther;
  }
}

bool IsTruncated(std::istream& in) {
  switch (in.get()) {
    case 0x89:
      return PngIsTruncated(in);
    case 0xFF:
      return JpegIsTruncated(in);
    default:
      return false;
  }
}

bool IsTruncated(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return IsTruncated(in);
}

std::optional<ImageSize> ReadSizeFromHeader(std::istream& in) {
  switch (in.get()) {
    case 0x89:
      return ReadPng(in);
    case 0xFF:
      return in.peek() == 0x4F ? ReadJpeg2000Codes(in) : ReadJpeg(in);
    case 'I':
    case 'M':
      return ReadTiff(in);
    case 'B':
      return ReadBmp(in);
    case 'R':
      return ReadWebp(in);
    case 'P':
      return ReadPnm(in);
    case 0x59:
      return ReadSunRaster(in);
    case 0:
      return ReadJpeg2000(in);
    default:
      return std::nullopt;
  }
}

std::optional<ImageSize> ReadSizeFromHeader(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return ReadSizeFromHeader(in);
}

}  // namespace limn::colmap_ext
