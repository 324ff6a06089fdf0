// Lists of images: as importers read them, as the list of a PMVS folder, and as a choice among its
// images.
#include "colmap_ext/dense/patch_file.h"
#include "colmap_ext/import/import_input.h"
#include "colmap_ext/workspace/pmvs_model.h"
#include "colmap_ext/workspace/to_views.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"

namespace limn::fuzz {
namespace {

// Three images without their list.
std::filesystem::path MakePmvsFolder() {
  for (const std::string number : {"00000000", "00000001", "00000002"}) {
    WriteScratch("pmvs/txt/" + number + ".txt", "CONTOUR\n50 0 20 1\n0 50 15 2\n0 0 1 3\n");
    WriteScratch("pmvs/visualize/" + number + ".jpg", EmptyImage());
  }
  return ScratchFolder() / "pmvs";
}

}  // namespace
}  // namespace limn::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace limn;
  static const std::filesystem::path folder = fuzz::MakePmvsFolder();
  const std::string list =
      fuzz::WriteScratch("pmvs/bundle.rd.out.list.txt", fuzz::Text(data, size));
  fuzz::ExpectReadOrRefused([&] { colmap_ext::ReadImageList(list); });
  fuzz::ExpectReadOrRefused(
      [&] { colmap_ext::ReadPmvsImageNames((folder / "models" / "option.patch").string()); });
  return fuzz::ExpectReadOrRefused([&] {
    colmap_ext::ViewOptions options;
    options.image_list_path = list;
    colmap_ext::ToViews(colmap_ext::ReadPmvsModel(folder), folder / "visualize", options);
  });
}
