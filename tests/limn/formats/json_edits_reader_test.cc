// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/json_edits_reader.h"

#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kRef = R"({"id": 4, "closed": false, "points": [[0, 0, 0], [1, 0.5, 0]]})";

std::string FileOf(const std::string& edits) {
  return R"({"format": "limn_edits", "format_version": 1, "edits": [)" + edits + "]}";
}

// What the reader complains of; empty if nothing.
std::string ComplaintOf(const std::string& text) {
  try {
    ParseJsonEdits("e.json", text);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

TEST(JsonEdits, ReadsEveryEdit) {
  const std::string place = R"({"link": )" + kRef + R"(, "at": [1, 2, 3]})";
  const std::vector<Edit> edits =
      ParseJsonEdits(
          "e.json",
          FileOf(R"({"edit": "delete", "links": [)" + kRef + ", " + kRef +
                 R"(]}, {"edit": "restore", "links": [)" + kRef +
                 R"(]}, {"edit": "set_kind", "links": [)" + kRef + R"(], "kind": "shadow"},)" +
                 R"({"edit": "split", "link": )" + kRef + R"(, "at": [1, 2, 3]},)" +
                 R"({"edit": "join", "ends": [{"link": )" + kRef + R"(, "end": 0}, {"link": )" +
                 kRef + R"(, "end": 1}]}, {"edit": "merge", "links": [)" + kRef + ", " + kRef +
                 R"(]}, {"edit": "dimension", "from": )" + place + R"(, "to": )" + place +
                 R"(, "shift": [0, 0, 2]},)" +
                 R"({"edit": "remove_dimension", "from": [1, 0, 0], "to": [0, 1, 0]})"))
          .edits;
  ASSERT_EQ(edits.size(), 8u);
  const auto& links = std::get<DeleteLinks>(edits[0]).links;
  ASSERT_EQ(links.size(), 2u);
  EXPECT_EQ(links[0].id, 4);
  EXPECT_FALSE(links[0].closed);
  EXPECT_THAT(links[0].points, ElementsAre(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0.5, 0)));
  EXPECT_EQ(std::get<RestoreLinks>(edits[1]).links.size(), 1u);
  EXPECT_EQ(std::get<SetLinkKind>(edits[2]).kind, LinkKind::kShadow);
  EXPECT_EQ(std::get<SplitLink>(edits[3]).place.at, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<JoinEnds>(edits[4]).ends[1].end, 1);
  EXPECT_EQ(std::get<MergeLinks>(edits[5]).links[1].id, 4);
  EXPECT_EQ(std::get<AddDimension>(edits[6]).shift, Eigen::Vector3d(0, 0, 2));
  EXPECT_EQ(std::get<AddDimension>(edits[6]).from.at, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<RemoveDimension>(edits[7]).to, Eigen::Vector3d(0, 1, 0));
  std::vector<std::string> names;
  for (const Edit& edit : edits) names.emplace_back(EditName(edit));
  EXPECT_THAT(names, ElementsAre("delete", "restore", "set_kind", "split", "join", "merge",
                                 "dimension", "remove_dimension"));
  EXPECT_TRUE(ParseJsonEdits("e.json", FileOf("")).edits.empty());
}

TEST(JsonEdits, TellsTheDrawingOfThePage) {
  EXPECT_EQ(ParseJsonEdits("e.json", FileOf("")).drawing.fingerprint, "");
  const EditsFile file = ParseJsonEdits("e.json", R"({"format": "limn_edits", "format_version": 1,
                    "drawing": {"name": "drawing.json", "fingerprint": "00ff"}, "edits": []})");
  EXPECT_EQ(file.drawing.name, "drawing.json");
  EXPECT_EQ(file.drawing.fingerprint, "00ff");
  EXPECT_THAT(ComplaintOf(R"({"format": "limn_edits", "format_version": 1,
                              "drawing": {"name": 1, "fingerprint": ""}, "edits": []})"),
              HasSubstr("drawing.name"));
}

TEST(JsonEdits, ComplaintsNameThePlace) {
  const auto of_edit = [](const std::string& edit) { return ComplaintOf(FileOf(edit)); };
  const auto of_points = [&](const std::string& points) {
    return of_edit(R"({"edit": "delete", "links": [{"id": 1, "closed": true, "points": )" + points +
                   "}]}");
  };
  EXPECT_EQ(ComplaintOf("[]"), "e.json: an object expected");
  EXPECT_EQ(ComplaintOf(R"({"format": "limn-drawing"})"), "e.json: format: not \"limn_edits\"");
  EXPECT_EQ(ComplaintOf(R"({"format": "limn_edits", "format_version": 2})"),
            "e.json: format_version: version 2; this program reads version 1");
  EXPECT_EQ(ComplaintOf(R"({"format": "limn_edits", "format_version": 1, "edits": 3})"),
            "e.json: edits: a list expected");
  EXPECT_EQ(of_edit("{}"), "e.json: edits[0]: no \"edit\"");
  EXPECT_EQ(of_edit(R"({"edit": "move"})"), "e.json: edits[0].edit: unknown edit \"move\"");
  EXPECT_EQ(of_edit(R"({"edit": "delete"})"), "e.json: edits[0]: no \"links\"");
  EXPECT_EQ(of_edit(R"({"edit": "delete", "links": []})"),
            "e.json: edits[0].links: a list of 1 or more expected, not of 0");
  EXPECT_EQ(of_edit(R"({"edit": "merge", "links": [)" + kRef + "]}"),
            "e.json: edits[0].links: a list of 2 expected, not of 1");
  EXPECT_EQ(of_edit(R"({"edit": "set_kind", "links": [)" + kRef + R"(], "kind": "red"})"),
            "e.json: edits[0].kind: unknown kind of link \"red\"");
  EXPECT_EQ(of_edit(R"({"edit": "split", "link": )" + kRef + R"(, "at": [1, 2]})"),
            "e.json: edits[0].at: a list of 3 numbers expected");
  EXPECT_EQ(of_edit(R"({"edit": "join", "ends": [{"link": )" + kRef + R"(, "end": 2}, 1]})"),
            "e.json: edits[0].ends[0].end: 0 or 1 expected");
  EXPECT_EQ(of_points("[[0, 0, 0]]"),
            "e.json: edits[0].links[0].points: a list of 2 to 16 expected, not of 1");
  EXPECT_EQ(of_points(R"([[0, 0, 0], [0, "x", 0]])"),
            "e.json: edits[0].links[0].points[1][1]: a number expected");
  EXPECT_EQ(of_points("[[0, 0, 0], [0, 1e300, 0]]"),
            "e.json: edits[0].links[0].points[1][1]: a number from -1e15 to 1e15 expected");
  EXPECT_EQ(of_points("[[1, 0, 0], [1, 0, 0], [1, 0, 0]]"),
            "e.json: edits[0].links[0].points: all points are at one place");
  EXPECT_EQ(of_points("[[1, 0, 0], [0, 0, 0], [0, 0, 0]]"), "");
  EXPECT_EQ(of_edit(R"({"edit": "delete", "links": [{"id": 1.5}]})"),
            "e.json: edits[0].links[0].id: an integer expected");
  EXPECT_EQ(of_edit(R"({"edit": "delete", "links": [{"id": 1, "closed": 0}]})"),
            "e.json: edits[0].links[0].closed: true or false expected");
  EXPECT_NE(ComplaintOf(R"({"format": )"), "");
}

}  // namespace
}  // namespace limn
