#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limn/util/errors.h"

namespace limn::colmap_ext {

// Members of JSON objects. All throw IoError via `place`, naming the member, if it is of another
// type, and all but Find and those with a default if it is missing. A null counts as missing.

// Null if there is none, or if `object` is no object.
const nlohmann::ordered_json* FindMember(const nlohmann::ordered_json& object, const char* key);

const nlohmann::ordered_json& Member(const nlohmann::ordered_json& object, const char* key,
                                     const FilePlace& place);

// A list, or an object.
const nlohmann::ordered_json& ListMember(const nlohmann::ordered_json& object, const char* key,
                                         const FilePlace& place);
const nlohmann::ordered_json& ObjectMember(const nlohmann::ordered_json& object, const char* key,
                                           const FilePlace& place);

// Finite.
double NumberMember(const nlohmann::ordered_json& object, const char* key, const FilePlace& place);
double NumberMemberOr(const nlohmann::ordered_json& object, const char* key, double otherwise,
                      const FilePlace& place);

// An integer from 0 to 2^53.
uint64_t IndexMember(const nlohmann::ordered_json& object, const char* key, const FilePlace& place);

std::string TextMember(const nlohmann::ordered_json& object, const char* key,
                       const FilePlace& place);
bool FlagMemberOr(const nlohmann::ordered_json& object, const char* key, bool otherwise,
                  const FilePlace& place);

// A list of so many finite numbers.
std::vector<double> NumbersMember(const nlohmann::ordered_json& object, const char* key,
                                  size_t count, const FilePlace& place);
std::vector<double> NumbersOf(const nlohmann::ordered_json& list, const char* key, size_t count,
                              const FilePlace& place);

}  // namespace limn::colmap_ext
