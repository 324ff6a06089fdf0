// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>

#include "limn/util/errors.h"

// A fuzz target defines LLVMFuzzerTestOneInput and hands the bytes to one reader, which must return
// or throw one of our errors; anything else that leaves the target is a finding.
namespace limn::fuzz {

// Calls body(); swallows IoError and InputError. Always 0, what libFuzzer wants to hear.
template <typename Body>
int ExpectReadOrRefused(const Body& body) {
  try {
    body();
  } catch (const IoError&) {
  } catch (const InputError&) {
  }
  return 0;
}

inline std::string_view Text(const uint8_t* data, size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Calls read(stream, name) with the bytes as a stream.
template <typename Read>
int FuzzStream(const uint8_t* data, size_t size, const Read& read) {
  return ExpectReadOrRefused([&] {
    std::istringstream in{std::string(Text(data, size))};
    read(in, std::string("fuzzed"));
  });
}

}  // namespace limn::fuzz
