// SPDX-License-Identifier: BSD-3-Clause
// The .vis beside a cloud of three points; the model has three images, of which two are views.
#include "colmap_ext/dense_files/dense_cloud.h"
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace limn;
  static const std::string cloud_path = fuzz::WriteScratch(
      "fused.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n");
  std::vector<View> views(2);
  views[1].model_index = 2;
  fuzz::WriteScratch("fused.ply.vis", fuzz::Text(data, size));
  return fuzz::ExpectReadOrRefused(
      [&] { colmap_ext::OpenPlyCloud(cloud_path, views, 3).points([](const DensePoint&) {}); });
}
