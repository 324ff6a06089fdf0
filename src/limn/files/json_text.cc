#include "limn/files/json_text.h"

#include <limits>

#include <nlohmann/json.hpp>

#include "limn/files/text_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxDepth = 100;

// What the JSON library says, without its number for it: "[json.exception.type_error.302] ...".
std::string Complaint(const Json::exception& error) {
  const std::string text = error.what();
  const size_t end = text.find("] ");
  return text.starts_with("[json.exception.") && end != std::string::npos ? text.substr(end + 2)
                                                                          : text;
}

}  // namespace

Json ParseJson(const std::string& path, const std::string& text) {
  MarkLength(path, text);  // the parser skips the mark
  const auto check_depth = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kMaxDepth) {
      throw IoError(path, "JSON nested more than " + std::to_string(kMaxDepth) + " deep");
    }
    return true;
  };
  try {
    return Json::parse(text, check_depth);
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
}

void RethrowJsonError(const std::string& path) {
  try {
    throw;
  } catch (const Json::exception& error) {
    throw IoError(path, Complaint(error));
  } catch (const InputError& error) {
    throw IoError(path, error.what());
  }
}

int IntFromJson(const Json& json) {
  using Limits = std::numeric_limits<int>;
  const bool fits = json.is_number_integer() && json.get<double>() >= Limits::min() &&
                    json.get<double>() <= Limits::max();
  if (!fits) throw InputError("an integer expected, not " + json.dump().substr(0, 40));
  return json.get<int>();
}

}  // namespace limn
