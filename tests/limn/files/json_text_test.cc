#include "limn/files/json_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/json_junctions_reader.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string Nested(int depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(ParseJson, KeepsTheOrderOfMembers) {
  EXPECT_EQ(ParseJson("a.json", R"({"b": 1, "a": [2]})").dump(), R"({"b":1,"a":[2]})");
}

TEST(ParseJson, RefusesWhatIsNoneAndWhatIsNestedDeep) {
  EXPECT_THROW(ParseJson("a.json", "{\"b\": "), IoError);
  EXPECT_NO_THROW(ParseJson("a.json", Nested(50)));
  // Writing this would need more stack than there is.
  EXPECT_THROW(ParseJson("a.json", Nested(1000000)), IoError);
  EXPECT_THROW(ParseJson("a.json", std::string(1000000, '[')), IoError);
}

TEST(IntFromJson, TakesIntegersInRangeOnly) {
  EXPECT_EQ(IntFromJson(OrderedJson::parse("-7")), -7);
  EXPECT_EQ(IntFromJson(OrderedJson::parse("2147483647")), 2147483647);
  for (const char* text : {"2147483648", "-2147483649", "4294967296", "18446744073709551615", "1.5",
                           "1e300", "\"1\"", "null", "[1]"}) {
    EXPECT_THROW(IntFromJson(OrderedJson::parse(text)), InputError) << text;
  }
}

// The readers that use it say which file it was.
TEST(ReadersOfJson, RefuseNumbersThatAreNoInt) {
  const TemporaryFolder folder;
  const std::string junctions = folder.Write(
      "junctions.json", R"({"junctions": [{"position": [1, 2, 3], "degree": 4294967299}]})");
  const std::string drawing =
      folder.Write("drawing.json", R"({"format": "limn-drawing", "format_version": 1e300})");
  for (const auto& read : {std::function<void()>([&] { ReadJunctions(junctions); }),
                           std::function<void()>([&] { ReadDrawingJson(drawing); })}) {
    try {
      read();
      ADD_FAILURE() << "was accepted";
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(".json: an integer expected, not "));
    }
  }
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
