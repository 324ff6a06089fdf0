#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace limn {

// The JSON of a file, with the members of objects in the order of the file. Throws IoError when it
// is no JSON or nested more than 100 deep (the JSON library writes and copies recursively).
nlohmann::ordered_json ParseJson(const std::string& path, const std::string& text);

// A number that is an int, without silent truncation. Throws InputError.
int IntFromJson(const nlohmann::ordered_json& json);

}  // namespace limn
