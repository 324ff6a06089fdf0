// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/depth_map.h"

#include <fstream>

#include "limn/files/atomic_file.h"
#include "limn/files/whole_file.h"
#include "limn/util/byte_stream.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

constexpr int kMaxSide = 1000000;

// A positive decimal number up to its '&'.
int ReadHeaderNumber(ByteReader& reader, const char* what) {
  int value = 0;
  bool any = false;
  for (char c = reader.Get<char>(what); c != '&' || !any; c = reader.Get<char>(what)) {
    any = true;
    if (c < '0' || c > '9') reader.Here().Fail("the header is not \"width&height&channels&\"");
    value = 10 * value + (c - '0');
    if (value > kMaxSide) reader.Here().Fail(std::string(what) + " is too large");
  }
  if (value == 0) reader.Here().Fail(std::string(what) + " is 0");
  return value;
}

FloatMap ReadWithChannels(const std::filesystem::path& path, int channels, const char* kind) {
  FloatMap map = ReadFloatMap(path);
  if (map.channels != channels) {
    throw IoError(path.string(), std::string("not a ") + kind +
                                     " map: " + std::to_string(map.channels) +
                                     " channels instead of " + std::to_string(channels));
  }
  return map;
}

}  // namespace

FloatMap ReadFloatMap(std::istream& in, const std::string& path) {
  ByteReader reader(path, in);
  FloatMap map;
  map.width = ReadHeaderNumber(reader, "width");
  map.height = ReadHeaderNumber(reader, "height");
  map.channels = ReadHeaderNumber(reader, "number of channels");
  // At most 10^18 values: no overflow.
  const uint64_t count =
      static_cast<uint64_t>(map.width) * static_cast<uint64_t>(map.height) * map.channels;
  if (count > reader.Remaining() / sizeof(float)) {
    reader.Here().Fail("truncated: " + std::to_string(count) + " values expected, " +
                       std::to_string(reader.Remaining() / sizeof(float)) + " found");
  }
  map.data.resize(count);
  reader.GetArray(map.data.data(), count, "values");
  reader.ExpectEnd();
  return map;
}

FloatMap ReadFloatMap(const std::filesystem::path& path) {
  std::ifstream in = OpenFile(path.string());
  return ReadFloatMap(in, path.string());
}

void WriteFloatMap(const FloatMap& map, std::ostream& out) {
  out << map.width << '&' << map.height << '&' << map.channels << '&';
  out.write(reinterpret_cast<const char*>(map.data.data()),
            static_cast<std::streamsize>(map.data.size() * sizeof(float)));
}

void WriteFloatMap(const FloatMap& map, const OutputPath& path) {
  WriteFileAtomically(path, [&](std::ostream& out) { WriteFloatMap(map, out); });
}

FloatMap ReadDepthMap(const std::filesystem::path& path) {
  return ReadWithChannels(path, 1, "depth");
}

FloatMap ReadNormalMap(const std::filesystem::path& path) {
  return ReadWithChannels(path, 3, "normal");
}

}  // namespace limn::colmap_ext
