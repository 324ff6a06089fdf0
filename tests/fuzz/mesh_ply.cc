// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/formats/mesh_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string path = limn::fuzz::WriteScratch("mesh.ply", limn::fuzz::Text(data, size));
  return limn::fuzz::ExpectReadOrRefused([&] { limn::ReadMesh(path); });
}
