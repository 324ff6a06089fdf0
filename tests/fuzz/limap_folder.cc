// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/limap_folder.h"

#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/formats/limap_structures.h"

namespace limn::fuzz {
namespace {

std::filesystem::path MakeFolder(bool is_text) {
  const std::filesystem::path folder = ScratchFolder() / (is_text ? "limap-text" : "limap");
  std::filesystem::create_directories(folder);
  if (is_text) return folder;
  LimapStructures structures;
  structures.images = {LimapImage{3, 1, {LimapSegment(), LimapSegment()}, {}, {}}};
  structures.lines = {{7, {0, 0, 0}, {1, 0, 0}, {{3, 0}}, -1}};
  WriteLimapStructures(structures, folder);
  return folder;
}

}  // namespace

int FuzzLimap(const uint8_t* data, size_t size, const std::string& name) {
  static const std::filesystem::path folder = MakeFolder(name.ends_with(".txt"));
  WriteScratch(folder.filename().string() + "/" + name, Text(data, size));
  return ExpectReadOrRefused([&] { ReadLimapStructures(folder); });
}

}  // namespace limn::fuzz
