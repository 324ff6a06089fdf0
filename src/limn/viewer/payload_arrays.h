// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace limn {

// Collects the arrays of a payload and their entries in its header (payload.h).
class PayloadArrays {
 public:
  PayloadArrays();
  ~PayloadArrays();

  // T is float, double, uint32_t, int32_t or uint8_t.
  template <typename T>
  void Add(const std::string& name, const std::vector<T>& values);
  void AddBytes(const std::string& name, std::string_view bytes);

  const nlohmann::ordered_json& header() const { return *header_; }
  const std::string& bytes() const { return bytes_; }

 private:
  void AddEntry(const std::string& name, const char* type, size_t length);

  std::unique_ptr<nlohmann::ordered_json> header_;
  std::string bytes_;
};

}  // namespace limn
