// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/payload_arrays.h"

#include <bit>
#include <cstdint>
#include <type_traits>

#include <nlohmann/json.hpp>

namespace limn {
namespace {

constexpr size_t kAlignment = 8;

static_assert(std::endian::native == std::endian::little, "byte swapping is not written yet");

template <typename T>
constexpr const char* TypeName() {
  if constexpr (std::is_same_v<T, float>) return "f32";
  if constexpr (std::is_same_v<T, double>) return "f64";
  if constexpr (std::is_same_v<T, uint32_t>) return "u32";
  if constexpr (std::is_same_v<T, int32_t>) return "i32";
  return "u8";
}

}  // namespace

PayloadArrays::PayloadArrays()
    : header_(std::make_unique<nlohmann::ordered_json>(nlohmann::ordered_json::object())) {}

PayloadArrays::~PayloadArrays() = default;

void PayloadArrays::AddEntry(const std::string& name, const char* type, size_t length) {
  bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment, '\0');
  (*header_)[name] = {{"type", type}, {"offset", bytes_.size()}, {"length", length}};
}

template <typename T>
void PayloadArrays::Add(const std::string& name, const std::vector<T>& values) {
  AddEntry(name, TypeName<T>(), values.size());
  const size_t at = bytes_.size();
  bytes_.resize(at + sizeof(T) * values.size());
  const char* from = reinterpret_cast<const char*>(values.data());
  for (size_t plane = 0; plane < sizeof(T); ++plane) {
    char* to = bytes_.data() + at + plane * values.size();
    for (size_t i = 0; i < values.size(); ++i) to[i] = from[i * sizeof(T) + plane];
  }
}

void PayloadArrays::AddBytes(const std::string& name, std::string_view bytes) {
  AddEntry(name, "u8", bytes.size());
  bytes_.append(bytes);
}

template void PayloadArrays::Add(const std::string&, const std::vector<float>&);
template void PayloadArrays::Add(const std::string&, const std::vector<double>&);
template void PayloadArrays::Add(const std::string&, const std::vector<uint32_t>&);
template void PayloadArrays::Add(const std::string&, const std::vector<int32_t>&);
template void PayloadArrays::Add(const std::string&, const std::vector<uint8_t>&);

}  // namespace limn
