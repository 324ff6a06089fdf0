// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/image_header.h"

#include "colmap_ext/workspace/image_traits.h"
#include "fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  limn::fuzz::FuzzStream(data, size, [](std::istream& in, const std::string&) {
    limn::colmap_ext::ReadSizeFromHeader(in);
  });
  limn::fuzz::FuzzStream(
      data, size, [](std::istream& in, const std::string&) { limn::colmap_ext::ReadTraits(in); });
  return limn::fuzz::FuzzStream(
      data, size, [](std::istream& in, const std::string&) { limn::colmap_ext::IsTruncated(in); });
}
