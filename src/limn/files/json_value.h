// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace limn {

// A value of a JSON file. Its type is checked where it is taken: InputErrors name its place, such
// as "edits[3].links[0].points[2]: a number expected". The file's root must outlive it.
class JsonValue {
 public:
  static constexpr size_t kNoLimit = SIZE_MAX;
  // Numbers are at most so large: their squares and cubes are still numbers.
  static constexpr double kMaxNumber = 1e15;

  explicit JsonValue(const nlohmann::ordered_json& root) : JsonValue(root, root) {}
  // A value within the root.
  JsonValue(const nlohmann::ordered_json& value, const nlohmann::ordered_json& root)
      : value_(&value), root_(&root) {}

  // A member of an object. Linear time in their number.
  JsonValue At(const char* name) const;
  // Nothing if there is no such member.
  std::optional<JsonValue> Find(const char* name) const;
  // Nor if it is null, as other programs write what they do not know.
  std::optional<JsonValue> FindNonNull(const char* name) const;
  void ExpectObject() const;
  // Those of an object, with their names, in the order of the file.
  std::vector<std::pair<std::string, JsonValue>> Members() const;

  // The items of a list of `min` to `max`.
  std::vector<JsonValue> Items(size_t min = 0, size_t max = kNoLimit) const;
  // Those of a list of exactly `count` numbers.
  void Numbers(size_t count, double* numbers) const;
  std::vector<double> Numbers() const;

  double Number() const;
  int Integer() const;
  // An integer from 0 to 2^53; may be written as 7.0.
  uint64_t Index() const;
  bool Bool() const;
  const std::string& Text() const;
  bool IsNull() const;

  // As in At, or what is said if there is no such member.
  double NumberOr(const char* name, double otherwise) const;
  bool BoolOr(const char* name, bool otherwise) const;
  std::string TextOr(const char* name, const std::string& otherwise) const;
  // None if there is no such member.
  std::vector<JsonValue> ItemsOf(const char* name) const;

  const nlohmann::ordered_json& Json() const { return *value_; }
  JsonValue Root() const { return JsonValue(*root_); }
  // Such as "links[3].points"; empty of the root. Linear time in the size of the file.
  std::string Place() const;
  [[noreturn]] void Fail(const std::string& reason) const;
  // Of a text: unknown `what`, and the text.
  [[noreturn]] void FailUnknown(const char* what) const;

 private:
  const nlohmann::ordered_json* value_;
  const nlohmann::ordered_json* root_;
};

}  // namespace limn
