// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/file_identity.h"

#include <cstdint>
#include <fstream>
#include <string_view>
#include <vector>

#include "limn/cache/content_hash.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

std::string IdentityText(uint64_t size, const ContentHash& hash) {
  return std::to_string(size) + " " + hash.Hex();
}

}  // namespace

std::string FileIdentity(const std::string& path) {
  std::ifstream in = OpenFile(path);
  ContentHash hash;
  std::vector<char> block(1 << 20);
  uint64_t size = 0;
  while (in.read(block.data(), static_cast<std::streamsize>(block.size())) || in.gcount() > 0) {
    hash.Add(std::string_view(block.data(), static_cast<size_t>(in.gcount())));
    size += static_cast<uint64_t>(in.gcount());
  }
  if (in.bad()) throw IoError(path, "cannot be read");
  return IdentityText(size, hash);
}

std::string IdentityOfBytes(std::string_view bytes) {
  ContentHash hash;
  hash.Add(bytes);
  return IdentityText(bytes.size(), hash);
}

}  // namespace limn::colmap_ext
