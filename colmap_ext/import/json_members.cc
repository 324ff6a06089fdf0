#include "colmap_ext/import/json_members.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace limn::colmap_ext {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMaxIndex = 9007199254740992;  // 2^53

[[noreturn]] void FailType(const char* key, const char* expected, const FilePlace& place) {
  place.Fail("\"" + std::string(key) + "\" is not " + expected);
}

double FiniteNumber(const Json& json, const char* key, const FilePlace& place) {
  if (!json.is_number()) FailType(key, "a number", place);
  const double number = json.get<double>();
  if (!std::isfinite(number)) FailType(key, "a finite number", place);
  return number;
}

}  // namespace

const Json* FindMember(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(key);
  return found == object.end() || found->is_null() ? nullptr : &*found;
}

const Json& Member(const Json& object, const char* key, const FilePlace& place) {
  const Json* found = FindMember(object, key);
  if (!found) place.Fail("no \"" + std::string(key) + "\"");
  return *found;
}

const Json& ListMember(const Json& object, const char* key, const FilePlace& place) {
  const Json& json = Member(object, key, place);
  if (!json.is_array()) FailType(key, "a list", place);
  return json;
}

const Json& ObjectMember(const Json& object, const char* key, const FilePlace& place) {
  const Json& json = Member(object, key, place);
  if (!json.is_object()) FailType(key, "an object", place);
  return json;
}

double NumberMember(const Json& object, const char* key, const FilePlace& place) {
  return FiniteNumber(Member(object, key, place), key, place);
}

double NumberMemberOr(const Json& object, const char* key, double otherwise,
                      const FilePlace& place) {
  const Json* found = FindMember(object, key);
  return found ? FiniteNumber(*found, key, place) : otherwise;
}

uint64_t IndexMember(const Json& object, const char* key, const FilePlace& place) {
  const double number = NumberMember(object, key, place);
  if (!(number >= 0 && number <= kMaxIndex && number == std::floor(number))) {
    FailType(key, "an index", place);
  }
  return static_cast<uint64_t>(number);
}

std::string TextMember(const Json& object, const char* key, const FilePlace& place) {
  const Json& json = Member(object, key, place);
  if (!json.is_string()) FailType(key, "a text", place);
  return json.get<std::string>();
}

bool FlagMemberOr(const Json& object, const char* key, bool otherwise, const FilePlace& place) {
  const Json* found = FindMember(object, key);
  if (found && !found->is_boolean()) FailType(key, "true or false", place);
  return found ? found->get<bool>() : otherwise;
}

std::vector<double> NumbersOf(const Json& list, const char* key, size_t count,
                              const FilePlace& place) {
  if (!list.is_array() || list.size() != count) {
    FailType(key, ("a list of " + std::to_string(count) + " numbers").c_str(), place);
  }
  std::vector<double> numbers;
  for (const Json& json : list) numbers.push_back(FiniteNumber(json, key, place));
  return numbers;
}

std::vector<double> NumbersMember(const Json& object, const char* key, size_t count,
                                  const FilePlace& place) {
  return NumbersOf(Member(object, key, place), key, count, place);
}

}  // namespace limn::colmap_ext
