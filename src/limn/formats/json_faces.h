// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limn/files/json_value.h"
#include "limn/formats/json_views.h"
#include "limn/model/faces.h"

namespace limn {

// A face of drawing.json, as json_drawing_writer.h describes it. Throws InputError if a view has no
// name.
nlohmann::ordered_json FaceToJson(const DrawingFace& face, size_t id,
                                  const std::vector<std::string>& view_names);

// Throws InputError if a value is missing or of another type, or the surface or a view is unknown;
// the invariants of Validate are not checked.
DrawingFace FaceFromJson(const JsonValue& value, const JsonViewIds& view_ids);

}  // namespace limn
