#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limn/model/faces.h"

namespace limn {

// A face of drawing.json, as json_drawing_writer.h describes it. Throws InputError if a view has no
// name.
nlohmann::ordered_json FaceToJson(const DrawingFace& face, size_t id,
                                  const std::vector<std::string>& view_names);

// Throws InputError if the surface or a view is unknown; the invariants of Validate are not
// checked.
DrawingFace FaceFromJson(const nlohmann::ordered_json& json,
                         const std::map<std::string, int>& view_ids);

}  // namespace limn
