#include "colmap_ext/workspace/image_header.h"

#include <array>
#include <cstdint>
#include <fstream>

namespace limn::colmap_ext {
namespace {

constexpr std::array<int, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

// Big endian; negative at the end of the stream.
int64_t ReadBigEndian(std::istream& in, int num_bytes) {
  int64_t value = 0;
  for (int i = 0; i < num_bytes; ++i) {
    const int byte = in.get();
    if (byte < 0) return -1;
    value = value << 8 | byte;
  }
  return value;
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

// After the first byte of the start-of-image marker.
std::optional<ImageSize> ReadJpeg(std::istream& in) {
  if (in.get() != 0xD8) return std::nullopt;
  while (in.get() == 0xFF) {
    int marker = in.get();
    while (marker == 0xFF) marker = in.get();  // fill bytes
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
  while (in.get() == 0xFF) {
    int marker = in.get();
    while (marker == 0xFF) marker = in.get();
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

bool IsJpeg(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return in.get() == 0xFF && in.get() == 0xD8;
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
      return ReadJpeg(in);
    default:
      return std::nullopt;
  }
}

std::optional<ImageSize> ReadSizeFromHeader(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return ReadSizeFromHeader(in);
}

}  // namespace limn::colmap_ext
