// SPDX-License-Identifier: BSD-3-Clause
#include "limn/files/json_value.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/json_junctions_reader.h"
#include "limn/formats/temporary_folder.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using ParsedJson = nlohmann::ordered_json;

// What is said of a value of this text that is taken so.
std::string SaidOf(const char* text, const std::function<void(const JsonValue&)>& take) {
  const ParsedJson json = ParsedJson::parse(text);
  try {
    take(JsonValue(json));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(JsonValue, GivesWhatIsThere) {
  const ParsedJson json = ParsedJson::parse(
      R"({"n": 1.5, "i": -7, "b": true, "t": "x", "l": [1, 2, 3], "e": null, "o": {"n": 2}})");
  const JsonValue value(json);
  EXPECT_EQ(value.At("n").Number(), 1.5);
  EXPECT_EQ(value.At("i").Integer(), -7);
  EXPECT_TRUE(value.At("b").Bool());
  EXPECT_EQ(value.At("t").Text(), "x");
  EXPECT_THAT(value.At("l").Numbers(), ElementsAre(1, 2, 3));
  EXPECT_TRUE(value.At("e").IsNull());
  EXPECT_EQ(value.At("o").At("n").Place(), "o.n");
  EXPECT_FALSE(value.Find("none"));
  EXPECT_TRUE(value.Find("e"));
  EXPECT_FALSE(value.FindNonNull("e"));
  EXPECT_FALSE(value.FindNonNull("none"));
  EXPECT_EQ(value.FindNonNull("n")->Number(), 1.5);
  EXPECT_EQ(value.Members().size(), 7u);
  EXPECT_EQ(value.Members()[6].first, "o");
  EXPECT_EQ(value.Members()[6].second.Place(), "o");
  EXPECT_EQ(value.NumberOr("none", 4), 4);
  EXPECT_EQ(value.NumberOr("n", 4), 1.5);
  EXPECT_TRUE(value.ItemsOf("none").empty());
}

TEST(JsonValue, ComplaintsNameThePlaceAndTheTypeExpected) {
  const auto number = [](const JsonValue& value) { value.Number(); };
  const auto list = [](const JsonValue& value) { value.Items(2, 3); };
  EXPECT_EQ(SaidOf("\"1\"", number), "a number expected");
  EXPECT_EQ(SaidOf("null", number), "a number expected");
  EXPECT_EQ(SaidOf("1e15", number), "");
  EXPECT_EQ(SaidOf("-1.1e15", number), "a number from -1e15 to 1e15 expected");
  EXPECT_EQ(SaidOf("[1]", list), "a list of 2 to 3 expected, not of 1");
  EXPECT_EQ(SaidOf("{}", list), "a list expected");
  EXPECT_EQ(SaidOf("3", [](const JsonValue& value) { value.At("x"); }), "an object expected");
  EXPECT_EQ(SaidOf("{}", [](const JsonValue& value) { value.At("x"); }), "no \"x\"");
  EXPECT_EQ(
      SaidOf(R"({"a": [{"b": [0, "x"]}]})",
             [](const JsonValue& value) { value.At("a").Items()[0].At("b").Items()[1].Number(); }),
      "a[0].b[1]: a number expected");
  EXPECT_EQ(
      SaidOf(R"({"k": "soap"})", [](const JsonValue& value) { value.At("k").FailUnknown("kind"); }),
      "k: unknown kind \"soap\"");
}

TEST(JsonValue, TakesIntegersInRangeOnly) {
  const auto integer = [](const JsonValue& value) { value.Integer(); };
  for (const char* text : {"-7", "2147483647", "-2147483648"}) EXPECT_EQ(SaidOf(text, integer), "");
  for (const char* text : {"2147483648", "-2147483649", "4294967296", "18446744073709551615", "1.5",
                           "1e300", "\"1\"", "null", "[1]"}) {
    EXPECT_EQ(SaidOf(text, integer), "an integer expected") << text;
  }
}

TEST(JsonValue, TakesIndicesUpToTheIntegersOfADouble) {
  const auto index_of = [](const char* text) { return JsonValue(ParsedJson::parse(text)).Index(); };
  EXPECT_EQ(index_of("0"), 0u);
  EXPECT_EQ(index_of("7.0"), 7u);
  EXPECT_EQ(index_of("2147483649"), 2147483649u);
  EXPECT_EQ(index_of("9007199254740992"), 9007199254740992u);
  const auto index = [](const JsonValue& value) { value.Index(); };
  for (const char* text :
       {"-1", "1.5", "9007199254740994", "18446744073709551615", "1e300", "\"1\"", "null", "[1]"}) {
    EXPECT_EQ(SaidOf(text, index), "an integer from 0 to 2^53 expected") << text;
  }
}

// The readers that use it say which file it was.
TEST(ReadersOfJson, RefuseNumbersThatAreNoInt) {
  const TemporaryFolder folder;
  const std::string junctions = folder.Write(
      "junctions.json", R"({"junctions": [{"position": [1, 2, 3], "degree": 4294967299}]})");
  const std::string drawing =
      folder.Write("drawing.json", R"({"format": "limn-drawing", "format_version": 1e300})");
  EXPECT_THAT([&] { ReadJunctions(junctions); },
              ::testing::ThrowsMessage<IoError>(
                  HasSubstr("junctions.json: junctions[0].degree: an integer expected")));
  EXPECT_THAT([&] { ReadDrawingJson(drawing); },
              ::testing::ThrowsMessage<IoError>(
                  HasSubstr("drawing.json: format_version: an integer expected")));
}

}  // namespace
}  // namespace limn
