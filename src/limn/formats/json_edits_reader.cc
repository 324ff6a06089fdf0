// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/json_edits_reader.h"

#include <algorithm>
#include <cstddef>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_place.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

constexpr const char* kFormat = "limn_edits";
constexpr int kVersion = 1;
constexpr size_t kMaxPoints = 16;

LinkRef ToRef(const JsonValue& value) {
  LinkRef ref;
  ref.id = value.At("id").Integer();
  ref.closed = value.At("closed").Bool();
  for (const JsonValue& point : value.At("points").Items(2, kMaxPoints)) {
    ref.points.push_back(PlaceOf(point));
  }
  // Points of very short links may be the same to the accuracy of the page.
  ref.points.erase(std::unique(ref.points.begin(), ref.points.end()), ref.points.end());
  if (ref.points.size() < 2) value.At("points").Fail("all points are at one place");
  return ref;
}

std::vector<LinkRef> ToRefs(const JsonValue& value, size_t min, size_t max) {
  std::vector<LinkRef> refs;
  for (const JsonValue& item : value.Items(min, max)) refs.push_back(ToRef(item));
  return refs;
}

PlaceRef ToPlaceRef(const JsonValue& value) {
  return {ToRef(value.At("link")), PlaceOf(value.At("at"))};
}

EndRef ToEndRef(const JsonValue& value) {
  EndRef end = {ToRef(value.At("link")), value.At("end").Integer()};
  if (end.end != 0 && end.end != 1) value.At("end").Fail("0 or 1 expected");
  return end;
}

LinkKind ToKind(const JsonValue& value) {
  const LinkKind kind = NamedBy(value, LinkKindNamed, "kind of link");
  if (kind == LinkKind::kRod) value.Fail("a rod needs two outlines: no link is made one by hand");
  return kind;
}

Edit ToEdit(const JsonValue& value) {
  const std::string& name = value.At("edit").Text();
  const auto links = [&] { return ToRefs(value.At("links"), 1, JsonValue::kNoLimit); };
  if (name == "delete") return DeleteLinks{links()};
  if (name == "restore") return RestoreLinks{links()};
  if (name == "set_kind") return SetLinkKind{links(), ToKind(value.At("kind"))};
  if (name == "split") return SplitLink{ToPlaceRef(value)};
  if (name == "join") {
    const std::vector<JsonValue> ends = value.At("ends").Items(2, 2);
    return JoinEnds{{ToEndRef(ends[0]), ToEndRef(ends[1])}};
  }
  if (name == "merge") {
    const std::vector<LinkRef> refs = ToRefs(value.At("links"), 2, 2);
    return MergeLinks{{refs[0], refs[1]}};
  }
  if (name == "dimension") {
    return AddDimension{ToPlaceRef(value.At("from")), ToPlaceRef(value.At("to")),
                        PlaceOf(value.At("shift"))};
  }
  if (name == "remove_dimension") {
    return RemoveDimension{PlaceOf(value.At("from")), PlaceOf(value.At("to"))};
  }
  value.At("edit").FailUnknown("edit");
}

EditsFile ToEditsFile(const JsonValue& file) {
  if (file.At("format").Text() != kFormat) {
    file.At("format").Fail("not \"" + std::string(kFormat) + "\"");
  }
  const int version = file.At("format_version").Integer();
  if (version != kVersion) {
    file.At("format_version")
        .Fail("version " + std::to_string(version) + "; this program reads version " +
              std::to_string(kVersion));
  }
  EditsFile edits;
  if (const auto drawing = file.Find("drawing")) {
    edits.drawing = {drawing->At("name").Text(), drawing->At("fingerprint").Text()};
  }
  for (const JsonValue& edit : file.At("edits").Items(0, JsonValue::kNoLimit)) {
    edits.edits.push_back(ToEdit(edit));
  }
  return edits;
}

}  // namespace

EditsFile ParseJsonEdits(const std::string& name, const std::string& text) {
  try {
    const auto json = ParseJson(name, text);
    return ToEditsFile(JsonValue(json));
  } catch (const std::exception&) {
    RethrowJsonError(name);
  }
}

EditsFile ReadJsonEdits(const std::string& path) {
  return ParseJsonEdits(path, ReadWholeFile(path, kMaxJsonBytes));
}

}  // namespace limn
