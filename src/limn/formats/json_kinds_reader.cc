#include "limn/formats/json_kinds_reader.h"

#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

Polyline3d ToPolyline(const Json& json) {
  Polyline3d polyline;
  for (const Json& point : json) {
    polyline.emplace_back(point.at(0).get<double>(), point.at(1).get<double>(),
                          point.at(2).get<double>());
    if (!polyline.back().allFinite()) throw InputError("a point is not finite");
  }
  if (polyline.size() < 2) throw InputError("a curve has fewer than two points");
  return polyline;
}

std::array<CurveSet, kNumLinkKinds> ToCurves(const Json& json) {
  std::array<CurveSet, kNumLinkKinds> curves;
  for (const Json& curve : json.at("curves")) {
    const auto name = curve.at("kind").get<std::string>();
    const auto kind = LinkKindNamed(name);
    if (!kind || *kind == LinkKind::kUnknown) {
      throw InputError("unknown kind of curve \"" + name.substr(0, 40) + "\"");
    }
    curves[static_cast<int>(*kind)].polylines.push_back(ToPolyline(curve.at("points")));
  }
  return curves;
}

}  // namespace

std::array<CurveSet, kNumLinkKinds> ReadJsonKinds(const std::string& path) {
  try {
    return ToCurves(ParseJson(path, ReadWholeFile(path, kMaxJsonBytes)));
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
}

}  // namespace limn
