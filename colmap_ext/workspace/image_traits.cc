// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/image_traits.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include "colmap_ext/workspace/stream_bytes.h"
#include "colmap_ext/workspace/tiff_directory.h"

namespace limn::colmap_ext {
namespace {

// EXIF data are small; a segment of JPEG has at most 64 KB.
constexpr int64_t kMaxExifBytes = 1 << 20;

std::string Bytes(std::istream& in, int64_t count) {
  std::string bytes(static_cast<size_t>(std::clamp<int64_t>(count, 0, kMaxExifBytes)), '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(in.gcount()));
  return bytes;
}

// EXIF data are a TIFF file without a picture: the first directory has the orientation.
int OrientationOfExif(const std::string& exif) {
  constexpr const char kHeader[] = "Exif\0";
  const std::string header(kHeader, 6);
  const bool has_header = exif.starts_with(header);
  std::istringstream in(has_header ? exif.substr(header.size()) : exif);
  return TiffOrientation(in);
}

ImageTraits OfJpeg(std::istream& in) {
  ImageTraits traits;
  in.seekg(2);
  while (in.get() == 0xFF) {
    int marker = in.get();
    while (marker == 0xFF) marker = in.get();
    constexpr int kApp1 = 0xE1, kScan = 0xDA;
    const int64_t length = ReadBigEndian(in, 2);
    if (marker < 0 || marker == kScan || length < 2) break;
    const std::streamoff end = in.tellg() + static_cast<std::streamoff>(length - 2);
    if (marker == kApp1) {
      const std::string segment = Bytes(in, length - 2);
      if (segment.starts_with("Exif")) {
        traits.orientation = OrientationOfExif(segment);
        break;
      }
    }
    in.seekg(end);
  }
  return traits;
}

ImageTraits OfPng(std::istream& in) {
  ImageTraits traits;
  in.seekg(8);
  constexpr int64_t kHeader = 0x49484452, kTransparency = 0x74524E53, kExif = 0x65584966,
                    kEnd = 0x49454E44;
  int color_type = 0;
  while (true) {
    const int64_t length = ReadBigEndian(in, 4);
    const int64_t type = ReadBigEndian(in, 4);
    if (length < 0 || type < 0 || type == kEnd) return traits;
    const std::streamoff end = in.tellg() + static_cast<std::streamoff>(length + 4);
    if (type == kHeader) {
      in.ignore(8);
      traits.is_deep = in.get() > 8;
      color_type = in.get();
      constexpr int kAlphaBit = 4;
      traits.has_alpha = color_type >= 0 && (color_type & kAlphaBit) != 0;
    }
    constexpr int kPalette = 3;
    if (type == kTransparency && color_type == kPalette) traits.has_alpha = true;
    if (type == kExif) traits.orientation = OrientationOfExif(Bytes(in, length));
    in.clear();
    in.seekg(end);
  }
}

ImageTraits OfWebp(std::istream& in) {
  ImageTraits traits;
  in.seekg(12);
  while (true) {
    const std::string kind = Bytes(in, 4);
    const int64_t length = ReadLittleEndian(in, 4);
    if (kind.size() < 4 || length < 0) return traits;
    const std::streamoff end = in.tellg() + static_cast<std::streamoff>(length + (length & 1));
    if (kind == "VP8X") {
      constexpr int kAlphaFlag = 0x10;
      traits.has_alpha = (std::max(in.get(), 0) & kAlphaFlag) != 0;
    } else if (kind == "VP8L") {
      in.ignore(1);
      const int64_t bits = ReadLittleEndian(in, 4);
      traits.has_alpha = traits.has_alpha || (bits >= 0 && (bits >> 28 & 1) != 0);
    } else if (kind == "EXIF") {
      traits.orientation = OrientationOfExif(Bytes(in, length));
    }
    in.clear();
    in.seekg(end);
  }
}

ImageTraits OfTiff(std::istream& in) {
  ImageTraits traits;
  const auto directory = LargestTiffDirectory(in);
  if (!directory) return traits;
  traits.orientation = directory->orientation;
  traits.is_deep = directory->bits > 8;
  traits.has_alpha = directory->has_alpha;
  return traits;
}

// The number of channels is in the SIZ marker, behind eight numbers of 4 bytes: the size of the
// image and of its tiles.
ImageTraits OfJpeg2000(std::istream& in) {
  ImageTraits traits;
  const std::string start = Bytes(in, 1 << 12);
  const size_t marker = start.find(std::string("\xFF\x4F\xFF\x51"));
  constexpr size_t kChannels = 4 + 2 + 2 + 32;
  if (marker == std::string::npos || marker + kChannels + 2 >= start.size()) return traits;
  const auto byte = [&](size_t at) { return static_cast<unsigned char>(start[marker + at]); };
  const int num_channels = byte(kChannels) << 8 | byte(kChannels + 1);
  traits.has_alpha = num_channels == 2 || num_channels == 4;
  traits.is_deep = (byte(kChannels + 2) & 0x7F) + 1 > 8;
  return traits;
}

// Binary files with 16 bits have a maximum above 255: the third number of the header.
ImageTraits OfPnm(std::istream& in) {
  in.ignore(2);
  int num_numbers = 0;
  int64_t value = -1;
  for (int64_t i = 0; i < kMaxExifBytes && num_numbers < 3; ++i) {
    const int byte = in.get();
    if (byte >= '0' && byte <= '9') {
      value = std::min<int64_t>(std::max<int64_t>(value, 0) * 10 + byte - '0', INT32_MAX);
    } else {
      if (value >= 0 && ++num_numbers == 3) break;
      value = -1;
      if (byte == '#') in.ignore(kMaxExifBytes, '\n');
      if (byte < 0) break;
    }
  }
  ImageTraits traits;
  traits.is_deep = num_numbers == 3 && value > 255;
  return traits;
}

}  // namespace

ImageTraits ReadTraits(std::istream& in) {
  const int64_t start = ReadBigEndian(in, 4);
  in.clear();
  in.seekg(0);
  if (start >> 16 == 0xFFD8) return OfJpeg(in);
  if (start == 0x89504E47) return OfPng(in);
  if (start == 0x52494646) return OfWebp(in);
  if (start >> 16 == 0x4949 || start >> 16 == 0x4D4D) return OfTiff(in);
  if (start == 0xC || start == 0xFF4FFF51) return OfJpeg2000(in);
  constexpr int64_t kPnmFirst = 0x5034, kPnmLast = 0x5036;
  if (start >> 16 >= kPnmFirst && start >> 16 <= kPnmLast) return OfPnm(in);
  return {};
}

ImageTraits ReadTraits(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return ReadTraits(in);
}

}  // namespace limn::colmap_ext
