// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/nvm.h"

#include "fuzz/import_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  return limn::fuzz::FuzzImportFile(data, size, limn::colmap_ext::ReadNvm);
}
