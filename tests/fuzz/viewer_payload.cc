// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz/fuzz_file.h"
#include "fuzz/fuzz_target.h"
#include "limn/viewer/packing.h"
#include "limn/viewer/page_reader.h"

// The bytes are what a page unpacks to.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const limn::fuzz::MemoryFile file("<!doctype html><script id=\"payload\">" +
                                    limn::Base64(limn::Gzip(limn::fuzz::Text(data, size))) +
                                    "</script>");
  return limn::fuzz::ExpectReadOrRefused([&] { limn::ReadViewerPage(file.path()); });
}
