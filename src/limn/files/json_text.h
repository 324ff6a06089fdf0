#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace limn {

// Parses the JSON text of a file, keeping the order of members. Throws IoError if it is invalid or
// nested more than 100 deep (the JSON library writes and copies recursively).
nlohmann::ordered_json ParseJson(const std::string& path, const std::string& text);

// Call it in a handler of std::exception: rethrows InputErrors and errors of the JSON library as
// IoError with the file's name. Other exceptions propagate.
[[noreturn]] void RethrowJsonError(const std::string& path);

// A number as an int. Throws InputError if it is not one, instead of truncating.
int IntFromJson(const nlohmann::ordered_json& json);

}  // namespace limn
