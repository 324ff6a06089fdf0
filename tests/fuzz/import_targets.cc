// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/import_targets.h"

#include "fuzz/fuzz_file.h"

namespace limn::fuzz {
namespace {

std::filesystem::path MakeImages() {
  for (const char* name : {"a.png", "b.png"}) {
    WriteScratch(std::string("images/") + name, EmptyImage());
  }
  return ScratchFolder() / "images";
}

}  // namespace

int FuzzImport(const std::string& path, ReadScene read) {
  static const std::filesystem::path folder = MakeImages();
  static const std::string list = WriteScratch("list.txt", "a.png\nb.png\n");
  return ExpectReadOrRefused([&] {
    colmap_ext::ImageFolder images(folder, /*skip_missing=*/true);
    colmap_ext::ToSparseModel(read({path, &images, list, -1}), {});
  });
}

int FuzzImportFile(const uint8_t* data, size_t size, ReadScene read) {
  const MemoryFile file(Text(data, size));
  return FuzzImport(file.path(), read);
}

}  // namespace limn::fuzz
