#include "limn/formats/json_edits_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "limn_edits";
constexpr int kVersion = 1;
constexpr size_t kMaxPoints = 16;
constexpr double kMaxCoordinate = 1e15;

// A value of the file and where it is, for messages.
class Value {
 public:
  Value(const Json& json, std::string place) : json_(json), place_(std::move(place)) {}

  [[noreturn]] void Fail(const std::string& reason) const {
    throw InputError((place_.empty() ? "" : place_ + ": ") + reason);
  }

  Value At(const char* name) const {
    if (!json_.is_object()) Fail("an object expected");
    const auto found = json_.find(name);
    if (found == json_.end()) Fail("no \"" + std::string(name) + "\"");
    return {*found, place_.empty() ? name : place_ + "." + name};
  }

  // The items of a list of `min` to `max`.
  std::vector<Value> Items(size_t min, size_t max) const {
    if (!json_.is_array()) Fail("a list expected");
    if (json_.size() < min || json_.size() > max) {
      const std::string expected = min == max ? std::to_string(min)
                                   : max == kNoLimit
                                       ? std::to_string(min) + " or more"
                                       : std::to_string(min) + " to " + std::to_string(max);
      Fail("a list of " + expected + " expected, not of " + std::to_string(json_.size()));
    }
    std::vector<Value> items;
    for (size_t i = 0; i < json_.size(); ++i) {
      items.push_back({json_[i], place_ + "[" + std::to_string(i) + "]"});
    }
    return items;
  }

  double Number() const {
    if (!json_.is_number()) Fail("a number expected");
    const auto number = json_.get<double>();
    if (!(std::abs(number) <= kMaxCoordinate)) Fail("a number from -1e15 to 1e15 expected");
    return number;
  }

  int Integer() const {
    if (!json_.is_number_integer()) Fail("an integer expected");
    return IntFromJson(json_);
  }

  bool Bool() const {
    if (!json_.is_boolean()) Fail("true or false expected");
    return json_.get<bool>();
  }

  std::string Text() const {
    if (!json_.is_string()) Fail("a text expected");
    return json_.get<std::string>();
  }

  static constexpr size_t kNoLimit = static_cast<size_t>(-1);

 private:
  const Json& json_;
  std::string place_;
};

Eigen::Vector3d ToPlace(const Value& value) {
  const std::vector<Value> items = value.Items(3, 3);
  return {items[0].Number(), items[1].Number(), items[2].Number()};
}

LinkRef ToRef(const Value& value) {
  LinkRef ref;
  ref.id = value.At("id").Integer();
  ref.closed = value.At("closed").Bool();
  for (const Value& point : value.At("points").Items(2, kMaxPoints)) {
    ref.points.push_back(ToPlace(point));
  }
  // Points of very short links may be the same to the accuracy of the page.
  ref.points.erase(std::unique(ref.points.begin(), ref.points.end()), ref.points.end());
  if (ref.points.size() < 2) value.At("points").Fail("all points are at one place");
  return ref;
}

std::vector<LinkRef> ToRefs(const Value& value, size_t min, size_t max) {
  std::vector<LinkRef> refs;
  for (const Value& item : value.Items(min, max)) refs.push_back(ToRef(item));
  return refs;
}

PlaceRef ToPlaceRef(const Value& value) {
  return {ToRef(value.At("link")), ToPlace(value.At("at"))};
}

EndRef ToEndRef(const Value& value) {
  EndRef end = {ToRef(value.At("link")), value.At("end").Integer()};
  if (end.end != 0 && end.end != 1) value.At("end").Fail("0 or 1 expected");
  return end;
}

LinkKind ToKind(const Value& value) {
  const std::string name = value.Text();
  const auto kind = LinkKindNamed(name);
  if (kind == LinkKind::kRod) value.Fail("a rod needs two outlines: no link is made one by hand");
  if (!kind) value.Fail("unknown kind of link \"" + Printable(name.substr(0, 40)) + "\"");
  return *kind;
}

Edit ToEdit(const Value& value) {
  const std::string name = value.At("edit").Text();
  const auto links = [&] { return ToRefs(value.At("links"), 1, Value::kNoLimit); };
  if (name == "delete") return DeleteLinks{links()};
  if (name == "restore") return RestoreLinks{links()};
  if (name == "set_kind") return SetLinkKind{links(), ToKind(value.At("kind"))};
  if (name == "split") return SplitLink{ToPlaceRef(value)};
  if (name == "join") {
    const std::vector<Value> ends = value.At("ends").Items(2, 2);
    return JoinEnds{{ToEndRef(ends[0]), ToEndRef(ends[1])}};
  }
  if (name == "merge") {
    const std::vector<LinkRef> refs = ToRefs(value.At("links"), 2, 2);
    return MergeLinks{{refs[0], refs[1]}};
  }
  if (name == "dimension") {
    return AddDimension{ToPlaceRef(value.At("from")), ToPlaceRef(value.At("to")),
                        ToPlace(value.At("shift"))};
  }
  if (name == "remove_dimension") {
    return RemoveDimension{ToPlace(value.At("from")), ToPlace(value.At("to"))};
  }
  value.At("edit").Fail("unknown edit \"" + Printable(name.substr(0, 40)) + "\"");
}

std::vector<Edit> ToEdits(const Json& json) {
  const Value file(json, "");
  if (file.At("format").Text() != kFormat) {
    file.At("format").Fail("not \"" + std::string(kFormat) + "\"");
  }
  const int version = file.At("format_version").Integer();
  if (version != kVersion) {
    file.At("format_version")
        .Fail("version " + std::to_string(version) + "; this program reads version " +
              std::to_string(kVersion));
  }
  std::vector<Edit> edits;
  for (const Value& edit : file.At("edits").Items(0, Value::kNoLimit)) {
    edits.push_back(ToEdit(edit));
  }
  return edits;
}

}  // namespace

std::vector<Edit> ParseJsonEdits(const std::string& name, const std::string& text) {
  try {
    return ToEdits(ParseJson(name, text));
  } catch (const std::exception&) {
    RethrowJsonError(name);
  }
}

std::vector<Edit> ReadJsonEdits(const std::string& path) {
  return ParseJsonEdits(path, ReadWholeFile(path, kMaxJsonBytes));
}

}  // namespace limn
