// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/json_junctions_reader.h"

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_place.h"

namespace limn {
namespace {

JunctionKind JunctionKindNamed(const std::string& name) {
  if (name == "corner") return JunctionKind::kCorner;
  if (name == "t") return JunctionKind::kTee;
  if (name == "crossing") return JunctionKind::kCrossing;
  return JunctionKind::kUnknown;
}

CurveNode ToCurveNode(const JsonValue& junction) {
  CurveNode node;
  node.position_in_world = PlaceOf(junction.At("position"));
  node.degree = junction.At("degree").Integer();
  if (node.degree < 1) junction.At("degree").Fail("a junction of degree below 1");
  if (const auto kind = junction.Find("kind")) node.kind = JunctionKindNamed(kind->Text());
  return node;
}

}  // namespace

std::vector<CurveNode> ReadJunctions(const std::string& path) {
  const std::string text = ReadWholeFile(path, kMaxJsonBytes);
  std::vector<CurveNode> nodes;
  try {
    const auto json = ParseJson(path, text);
    for (const JsonValue& junction : JsonValue(json).At("junctions").Items()) {
      nodes.push_back(ToCurveNode(junction));
    }
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
  return nodes;
}

}  // namespace limn
