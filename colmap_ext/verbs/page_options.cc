// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/page_options.h"

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

void PageOptions::Check() const {
  LIMN_CHECK_RANGE(max_points, >= 0, <= 10000000);
  LIMN_CHECK_RANGE(thumbnail_size, >= 16, <= 4096);
}

std::string SettingsOf(const PageOptions& options, const std::string& cloud_source) {
  using Json = nlohmann::ordered_json;
  const Json json = {{"cloud", options.cloud},
                     {"cloud_source", cloud_source},
                     {"max_points", options.max_points},
                     {"thumbnail_size", options.thumbnail_size},
                     {"in_model", options.shown == PageOptions::Shown::kModel}};
  // Paths need not be UTF-8.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string CloudSourceOf(const StoredPage& page) {
  if (page.settings_json.empty()) return "";
  const auto json = ParseJson("settings of the page", page.settings_json);
  return JsonValue(json).TextOr("cloud_source", "");
}

PageOptions OptionsOf(const StoredPage& page) {
  PageOptions options;
  options.detail = page.detail;
  if (page.settings_json.empty()) return options;
  const auto json = ParseJson("settings of the page", page.settings_json);
  const JsonValue settings(json);
  options.cloud = settings.TextOr("cloud", options.cloud);
  if (const auto most = settings.Find("max_points")) options.max_points = most->Integer();
  if (const auto size = settings.Find("thumbnail_size")) options.thumbnail_size = size->Integer();
  if (settings.BoolOr("in_model", false)) options.shown = PageOptions::Shown::kModel;
  options.Check();
  return options;
}

}  // namespace limn::colmap_ext
