// SPDX-License-Identifier: BSD-3-Clause
// Lists of images: as importers read them, as the list of a PMVS folder, and as a choice among its
// images.
#include "colmap_ext/dense_files/patch_file.h"
#include "colmap_ext/import/import_input.h"
#include "colmap_ext/workspace/pmvs_model.h"
#include "colmap_ext/workspace/to_views.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/pmvs_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace limn;
  const std::filesystem::path& folder = fuzz::PmvsFolder();
  const std::string list =
      fuzz::WriteScratch("pmvs/bundle.rd.out.list.txt", fuzz::Text(data, size));
  fuzz::ExpectReadOrRefused([&] { colmap_ext::ReadImageList(list); });
  return fuzz::ExpectReadOrRefused([&] {
    colmap_ext::ViewOptions options;
    options.image_list_path = list;
    const colmap_ext::ViewSet set =
        colmap_ext::ToViews(colmap_ext::ReadPmvsModel(folder), folder / "visualize", options);
    colmap_ext::PmvsNumbers(folder / "models" / "option.patch", set.views);
  });
}
