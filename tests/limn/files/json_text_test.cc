// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/json_text.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

std::string Nested(int depth) { return std::string(depth, '[') + std::string(depth, ']'); }

auto Parsing(const std::string& text) {
  return [text] { ParseJson("a.json", text); };
}

TEST(ParseJson, KeepsTheOrderOfMembers) {
  EXPECT_EQ(ParseJson("a.json", R"({"b": 1, "a": [2, {}, "x", null, -3, 1e5, true]})").dump(),
            R"({"b":1,"a":[2,{},"x",null,-3,100000.0,true]})");
}

TEST(ParseJson, RefusesWhatIsNoneAndWhatIsNestedDeep) {
  EXPECT_THAT(Parsing("{\"b\": "), ThrowsMessage<IoError>(HasSubstr("a.json: line 1: the JSON text "
                                                                    "ends too early")));
  EXPECT_THAT(Parsing("\n\n{\"b\": nan}"),
              ThrowsMessage<IoError>(HasSubstr("a.json: line 3: is not valid JSON")));
  EXPECT_THAT(Parsing("[1e999]"), ThrowsMessage<IoError>(HasSubstr("a number is too large")));
  EXPECT_THAT(Parsing("[\"\xff\"]"), ThrowsMessage<IoError>(Not(HasSubstr("exception"))));
  EXPECT_THROW(ParseJson("a.json", ""), IoError);
  EXPECT_NO_THROW(ParseJson("a.json", Nested(50)));
  // Writing this would need more stack than there is.
  EXPECT_THROW(ParseJson("a.json", Nested(1000000)), IoError);
  EXPECT_THROW(ParseJson("a.json", std::string(1000000, '[')), IoError);
}

TEST(ParseJson, RefusesTwoMembersOfOneName) {
  EXPECT_THAT(Parsing(R"([{"a": 1, "b": 2, "a": 3}])"),
              ThrowsMessage<IoError>(HasSubstr("an object has two members \"a\"")));
}

TEST(ParseJson, RefusesMoreValuesThanItMayRead) {
  EXPECT_NO_THROW(ParseJson("a.json", "[1, 2, 3]", 4));
  EXPECT_THAT([] { ParseJson("a.json", "[1, 2, 3]", 3); },
              ThrowsMessage<IoError>(HasSubstr("has more than 3 values")));
}

// The JSON library alone takes minutes: the square of their number.
TEST(ParseJson, TakesLinearTime) {
  std::string members, items;
  for (int i = 0; i < 300'000; ++i) {
    members += (i ? ",\"k" : "\"k") + std::to_string(i) + "\":{}";
    items += i ? ",{}" : "{}";
  }
  EXPECT_EQ(ParseJson("a.json", "{" + members + "}").size(), 300'000u);
  EXPECT_EQ(ParseJson("a.json", "[" + items + "]").size(), 300'000u);
}

TEST(ParseJson, ItemsThatAreTakenLeaveNull) {
  std::vector<std::string> taken;
  const TakeJsonItem take = [&](const std::string& list, const JsonValue& item) {
    taken.push_back(item.Place() + " = " + item.Json().dump());
    return list == "a";
  };
  const auto left = ParseJson(
      "a.json", R"({"a": [{"x": [1]}, [2], 3], "b": [[4]], "c": {"d": []}})", kMaxJsonValues, take);
  EXPECT_THAT(taken, ElementsAre(R"(a[0] = {"x":[1]})", "a[1] = [2]", "b[0] = [4]"));
  EXPECT_EQ(left.dump(), R"({"a":[null,null,3],"b":[[4]],"c":{"d":[]}})");
}

TEST(ReadDrawingJson, RefusesOptionsNestedDeep) {
  const TemporaryFolder folder;
  EXPECT_THROW(ReadDrawingJson(folder.Write(
                   "deep.json",
                   R"({"format": "limn-drawing", "format_version": 1, "views": [], "options": )" +
                       Nested(200000) + R"(, "nodes": [], "links": []})")),
               IoError);
}

}  // namespace
}  // namespace limn
