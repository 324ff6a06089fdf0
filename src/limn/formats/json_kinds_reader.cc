// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/json_kinds_reader.h"

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_place.h"

namespace limn {
namespace {

std::array<CurveSet, kNumLinkKinds> ToCurves(const JsonValue& file) {
  std::array<CurveSet, kNumLinkKinds> curves;
  for (const JsonValue& curve : file.At("curves").Items()) {
    const LinkKind kind = NamedBy(curve.At("kind"), LinkKindNamed, "kind of curve");
    if (kind == LinkKind::kUnknown) curve.At("kind").FailUnknown("kind of curve");
    const JsonValue points = curve.At("points");
    points.Items(2, JsonValue::kNoLimit);
    curves[static_cast<int>(kind)].polylines.push_back(PlacesOf(points));
  }
  return curves;
}

}  // namespace

std::array<CurveSet, kNumLinkKinds> ReadJsonKinds(const std::string& path) {
  try {
    const auto json = ParseJson(path, ReadWholeFile(path, kMaxJsonBytes));
    return ToCurves(JsonValue(json));
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
}

}  // namespace limn
