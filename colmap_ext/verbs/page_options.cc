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

std::string SettingsOf(const PageOptions& options) {
  const nlohmann::ordered_json json = {{"thumbnail_size", options.thumbnail_size},
                                       {"in_model", options.shown == PageOptions::Shown::kModel}};
  return json.dump();
}

PageOptions OptionsOf(const StoredPage& page) {
  PageOptions options;
  options.detail = page.detail;
  if (page.settings_json.empty()) return options;
  const auto json = ParseJson("settings of the page", page.settings_json);
  const JsonValue settings(json);
  if (const auto size = settings.Find("thumbnail_size")) options.thumbnail_size = size->Integer();
  if (settings.BoolOr("in_model", false)) options.shown = PageOptions::Shown::kModel;
  options.Check();
  return options;
}

}  // namespace limn::colmap_ext
