// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/json_value.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

using OrderedJson = nlohmann::ordered_json;

// Appends the way from `from` to `wanted`, or nothing if it is not there.
bool AppendWay(const OrderedJson& from, const OrderedJson& wanted, std::string* way) {
  if (&from == &wanted) return true;
  const size_t length = way->size();
  if (from.is_array()) {
    for (size_t i = 0; i < from.size(); ++i) {
      *way += "[" + std::to_string(i) + "]";
      if (AppendWay(from[i], wanted, way)) return true;
      way->resize(length);
    }
  } else if (from.is_object()) {
    for (const auto& [name, value] : from.get_ref<const OrderedJson::object_t&>()) {
      if (!way->empty()) *way += ".";
      *way += Printable(name.substr(0, 40));
      if (AppendWay(value, wanted, way)) return true;
      way->resize(length);
    }
  }
  return false;
}

}  // namespace

std::string JsonValue::Place() const {
  std::string way;
  AppendWay(*root_, *value_, &way);
  return way;
}

void JsonValue::Fail(const std::string& reason) const {
  const std::string place = Place();
  throw InputError(place.empty() ? reason : place + ": " + reason);
}

void JsonValue::FailUnknown(const char* what) const {
  Fail(std::string("unknown ") + what + " \"" + Printable(Text().substr(0, 40)) + "\"");
}

void JsonValue::ExpectObject() const {
  if (!value_->is_object()) Fail("an object expected");
}

std::optional<JsonValue> JsonValue::Find(const char* name) const {
  ExpectObject();
  const auto found = value_->find(name);
  if (found == value_->end()) return std::nullopt;
  return JsonValue(*found, *root_);
}

std::optional<JsonValue> JsonValue::FindNonNull(const char* name) const {
  const std::optional<JsonValue> found = Find(name);
  return found && found->IsNull() ? std::nullopt : found;
}

JsonValue JsonValue::At(const char* name) const {
  const std::optional<JsonValue> found = Find(name);
  if (!found) Fail("no \"" + std::string(name) + "\"");
  return *found;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::Members() const {
  ExpectObject();
  std::vector<std::pair<std::string, JsonValue>> members;
  members.reserve(value_->size());
  for (const auto& [name, value] : value_->get_ref<const OrderedJson::object_t&>()) {
    members.emplace_back(name, JsonValue(value, *root_));
  }
  return members;
}

std::vector<JsonValue> JsonValue::Items(size_t min, size_t max) const {
  if (!value_->is_array()) Fail("a list expected");
  if (value_->size() < min || value_->size() > max) {
    const std::string expected = min == max ? std::to_string(min)
                                 : max == kNoLimit
                                     ? std::to_string(min) + " or more"
                                     : std::to_string(min) + " to " + std::to_string(max);
    Fail("a list of " + expected + " expected, not of " + std::to_string(value_->size()));
  }
  std::vector<JsonValue> items;
  items.reserve(value_->size());
  for (const OrderedJson& item : *value_) items.push_back(JsonValue(item, *root_));
  return items;
}

void JsonValue::Numbers(size_t count, double* numbers) const {
  if (!value_->is_array() || value_->size() != count) {
    Fail("a list of " + std::to_string(count) + " numbers expected");
  }
  for (size_t i = 0; i < count; ++i) numbers[i] = JsonValue((*value_)[i], *root_).Number();
}

std::vector<double> JsonValue::Numbers() const {
  std::vector<double> numbers;
  for (const JsonValue& item : Items()) numbers.push_back(item.Number());
  return numbers;
}

double JsonValue::Number() const {
  if (!value_->is_number()) Fail("a number expected");
  const auto number = value_->get<double>();
  if (!(std::abs(number) <= kMaxNumber)) Fail("a number from -1e15 to 1e15 expected");
  return number;
}

int JsonValue::Integer() const {
  using Limits = std::numeric_limits<int>;
  const bool fits = value_->is_number_integer() && value_->get<double>() >= Limits::min() &&
                    value_->get<double>() <= Limits::max();
  if (!fits) Fail("an integer expected");
  return value_->get<int>();
}

uint64_t JsonValue::Index() const {
  constexpr double kMaxIndex = 9007199254740992;  // 2^53
  const double number = value_->is_number() ? value_->get<double>() : -1;
  const bool is_index = number >= 0 && number <= kMaxIndex && number == std::floor(number);
  if (!is_index) Fail("an integer from 0 to 2^53 expected");
  return static_cast<uint64_t>(number);
}

bool JsonValue::Bool() const {
  if (!value_->is_boolean()) Fail("true or false expected");
  return value_->get<bool>();
}

const std::string& JsonValue::Text() const {
  if (!value_->is_string()) Fail("a text expected");
  return value_->get_ref<const std::string&>();
}

bool JsonValue::IsNull() const { return value_->is_null(); }

double JsonValue::NumberOr(const char* name, double otherwise) const {
  const auto found = Find(name);
  return found ? found->Number() : otherwise;
}

bool JsonValue::BoolOr(const char* name, bool otherwise) const {
  const auto found = Find(name);
  return found ? found->Bool() : otherwise;
}

std::string JsonValue::TextOr(const char* name, const std::string& otherwise) const {
  const auto found = Find(name);
  return found ? found->Text() : otherwise;
}

std::vector<JsonValue> JsonValue::ItemsOf(const char* name) const {
  const auto found = Find(name);
  return found ? found->Items() : std::vector<JsonValue>();
}

}  // namespace limn
