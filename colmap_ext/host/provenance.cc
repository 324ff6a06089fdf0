// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/provenance.h"

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"

namespace limn::colmap_ext {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string Provenance(const RunOptions& options) {
  Json json = Json::parse(OptionsAsJson(options.pipeline));
  json["max_image_size"] = options.view.max_image_size;
  json["max_scale"] = options.view.max_scale;
  json["box"] = options.box;
  json["Surfaces"] = nullptr;  // faces are found later
  return json.dump();
}

std::string ProvenanceAfter(const std::string& before, const ProvenanceKeys& keys,
                            const RunOptions& options) {
  Json json = ParseJson("options of the drawing", before);
  const Json now = Json::parse(OptionsAsJson(options.pipeline));
  for (const char* key : keys.taken) {
    if (now.contains(key)) {
      json[key] = now[key];
    } else {
      json.erase(key);
    }
  }
  for (const char* key : keys.dropped) json[key] = nullptr;
  return json.dump();
}

bool HasBox(const std::string& provenance) {
  const Json json = ParseJson("options of the drawing", provenance);
  return json.contains("box") && !json["box"].empty();
}

}  // namespace limn::colmap_ext
