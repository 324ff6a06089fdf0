// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/json_text.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "limn/files/text_file.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMaxDepth = 100;
constexpr size_t kShownBytes = 40;

// Builds the values. The JSON library itself looks for each name among those before it, and for
// dropped values among all that have been read of a list: quadratic time.
class JsonBuilder : public nlohmann::json_sax<Json> {
 public:
  JsonBuilder(const std::string& path, const std::string& text, size_t max_values,
              const TakeJsonItem& take)
      : path_(path), text_(text), max_values_(max_values), take_(take) {}

  Json Take() { return std::move(root_); }

  bool null() override { return Add(nullptr); }
  bool boolean(bool value) override { return Add(value); }
  bool number_integer(number_integer_t value) override { return Add(value); }
  bool number_unsigned(number_unsigned_t value) override { return Add(value); }
  bool number_float(number_float_t value, const string_t&) override { return Add(value); }
  bool string(string_t& value) override { return Add(std::move(value)); }
  bool binary(binary_t&) override { return false; }

  bool start_object(size_t) override { return Open(Json::object()); }
  bool key(string_t& name) override {
    // Not ordered_map::emplace, which compares it with all others.
    auto& members = open_.back()->get_ref<Json::object_t&>();
    members.emplace_back(std::move(name), nullptr);
    return true;
  }
  bool end_object() override {
    CheckNames(open_.back()->get_ref<const Json::object_t&>());
    return Close();
  }
  bool start_array(size_t) override { return Open(Json::array()); }
  bool end_array() override { return Close(); }

  bool parse_error(size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int kOutOfRange = 406;
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(position, text_.size()));
    const std::string line = "line " + std::to_string(1 + std::count(text_.begin(), end, '\n'));
    if (error.id == kOutOfRange) {
      throw IoError(path_, line,
                    "a number is too large: " + Printable(token.substr(0, kShownBytes)));
    }
    if (position > text_.size()) throw IoError(path_, line, "the JSON text ends too early");
    const std::string shown =
        Printable(token.substr(token.size() - std::min(token.size(), kShownBytes)));
    throw IoError(path_, line, "is not valid JSON, at \"" + shown + "\"");
  }

 private:
  Json* Put(Json value) {
    if (++num_values_ > max_values_) {
      throw IoError(path_, "has more than " + std::to_string(max_values_) + " values");
    }
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    Json& parent = *open_.back();
    if (parent.is_array()) {
      auto& items = parent.get_ref<Json::array_t&>();
      items.push_back(std::move(value));
      return &items.back();
    }
    auto& last = parent.get_ref<Json::object_t&>().back();
    last.second = std::move(value);
    return &last.second;
  }

  bool Add(Json value) {
    Put(std::move(value));
    return true;
  }

  bool Open(Json value) {
    open_.push_back(Put(std::move(value)));
    if (open_.size() > kMaxDepth) {
      throw IoError(path_, "JSON nested more than " + std::to_string(kMaxDepth) + " deep");
    }
    return true;
  }

  bool Close() {
    Json& closed = *open_.back();
    open_.pop_back();
    const bool is_item = take_ && open_.size() == 2 && root_.is_object() && open_[1]->is_array();
    if (is_item &&
        take_(root_.get_ref<const Json::object_t&>().back().first, JsonValue(closed, root_))) {
      closed = nullptr;
    }
    return true;
  }

  // Which of two members is meant, nobody knows.
  void CheckNames(const Json::object_t& members) {
    names_.clear();
    for (const auto& [name, value] : members) names_.emplace_back(name);
    std::sort(names_.begin(), names_.end());
    const auto twice = std::adjacent_find(names_.begin(), names_.end());
    if (twice == names_.end()) return;
    throw IoError(path_, "an object has two members \"" +
                             Printable(std::string(twice->substr(0, kShownBytes))) + "\"");
  }

  const std::string& path_;
  const std::string& text_;
  const size_t max_values_;
  const TakeJsonItem& take_;
  size_t num_values_ = 0;
  Json root_;
  std::vector<Json*> open_;
  std::vector<std::string_view> names_;
};

}  // namespace

Json ParseJson(const std::string& path, const std::string& text, size_t max_values,
               const TakeJsonItem& take) {
  MarkLength(path, text);  // the parser skips the mark
  JsonBuilder builder(path, text, max_values, take);
  Json::sax_parse(text, &builder);
  return builder.Take();
}

void RethrowJsonError(const std::string& path) {
  try {
    throw;
  } catch (const InputError& error) {
    throw IoError(path, error.what());
  }
}

}  // namespace limn
