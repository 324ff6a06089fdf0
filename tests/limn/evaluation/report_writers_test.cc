// SPDX-License-Identifier: BSD-3-Clause
#include "limn/evaluation/report_writers.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

EvaluationReport SmallReport() {
  EvaluationReport report;
  TauResult row;
  row.tau = 0.01;
  row.precision = 0.875;
  row.recall = 0.5;
  row.f = 0.636;
  row.accuracy = 0.002;
  report.rows = {row, row};
  report.rows[1].precision.reset();
  report.num_links = 12;
  report.num_components = 3;
  report.nodes_by_degree = {{1, 4}, {3, 2}};
  return report;
}

TEST(ReportWriters, TableShowsPercentAndAbsentShares) {
  std::ostringstream out;
  PrintReport(SmallReport(), out);
  EXPECT_THAT(out.str(), HasSubstr("87.5"));
  EXPECT_THAT(out.str(), HasSubstr(" - "));
  EXPECT_THAT(out.str(), HasSubstr("links 12"));
  EXPECT_THAT(out.str(), HasSubstr("1: 4 3: 2"));
}

TEST(ReportWriters, StructureIsToldWhereKnown) {
  EvaluationReport report = SmallReport();
  report.rows[0].precision_interval = Interval{0.75, 0.9375};
  StructureScores& scores = report.rows[0].structure;
  scores.links_per_chain = 1.625;
  scores.curves_per_chain = 1.375;
  scores.num_chains = 9;
  scores.num_free_ends = 25;
  scores.num_false_ends = 17;
  scores.false_junctions_per_length = 0.125;
  scores.right_degrees = 0.625;
  scores.arm_precision = 0.5;
  scores.connectivity = 0.375;
  std::ostringstream table, csv, json;
  PrintReport(report, table);
  EXPECT_THAT(table.str(), HasSubstr("75.0-93.8"));
  EXPECT_THAT(table.str(), HasSubstr(" 1.62 "));
  EXPECT_THAT(table.str(), HasSubstr(" 1.38 "));
  EXPECT_THAT(table.str(), HasSubstr(" 17 "));
  EXPECT_THAT(table.str(), HasSubstr(" 0.125 "));
  EXPECT_THAT(table.str(), HasSubstr(" 62.5 "));
  EXPECT_THAT(table.str(), HasSubstr(" 37.5 "));
  WriteReportCsv(report, csv);
  EXPECT_THAT(csv.str(), HasSubstr(",links_per_chain,curves_per_chain,num_chains,"));
  EXPECT_THAT(csv.str(), HasSubstr(",1.625,1.375,9,"));
  WriteReportJson(report, json);
  const nlohmann::json rows = nlohmann::json::parse(json.str()).at("rows");
  EXPECT_EQ(rows.at(0).at("precision_low"), 0.75);
  EXPECT_EQ(rows.at(0).at("precision_high"), 0.9375);
  EXPECT_TRUE(rows.at(0).at("recall_low").is_null());
  EXPECT_EQ(rows.at(0).at("num_false_ends"), 17);
  EXPECT_EQ(rows.at(0).at("connectivity"), 0.375);
  EXPECT_TRUE(rows.at(1).at("links_per_chain").is_null());
  EXPECT_TRUE(rows.at(1).at("num_false_ends").is_null());
}

TEST(ReportWriters, FeaturesAreInTextAtTheMiddleTauAndInJson) {
  EvaluationReport report = SmallReport();
  std::ostringstream without, with_none, csv, table, json;
  PrintReport(report, without);
  for (const char* word : {"circles", "crossings", "corners", "pairs"}) {
    EXPECT_THAT(without.str(), Not(HasSubstr(word)));
  }
  FeatureScores& features = report.rows[1].features;
  features.circles = {{4, 6, 7, 0.375, 5, 3, 2},
                      {30, std::numeric_limits<double>::infinity(), 1, 1, 1, 1, std::nullopt}};
  features.crossings = {81, 40, 20};
  features.tees = {60, 50, 1};
  features.corners = {12, 11, 2};
  features.pairs = {{2, 2.5, 0, std::nullopt}, {2.5, 4, 1.5, 0.625}};
  features.drawn_corners = {10, 4, 30, 6, 5};
  WriteReportCsv(SmallReport(), with_none);
  WriteReportCsv(report, csv);
  EXPECT_EQ(csv.str(), with_none.str());
  PrintReport(report, table);
  EXPECT_THAT(table.str(), HasSubstr("     4 to 6           7        37.5           5           3 "
                                     "          2 \n"));
  EXPECT_THAT(table.str(), HasSubstr("    from 30           1       100.0           1           1 "
                                     "          - \n"));
  EXPECT_THAT(table.str(), HasSubstr("40 of 81 crossings (20 with one of degree 4), 50 of 60 T "
                                     "junctions, 11 of 12 corners"));
  EXPECT_THAT(table.str(), HasSubstr("4 of 10 drawn corners, 6 of 30 meetings, 5 with"));
  EXPECT_THAT(table.str(), HasSubstr(": 62.5 % of those 2.5 to 4 rho apart\n"));
  WriteReportJson(report, json);
  const nlohmann::json row = nlohmann::json::parse(json.str()).at("rows").at(1);
  EXPECT_EQ(row.at("circles").at(0).at("covered"), 0.375);
  EXPECT_EQ(row.at("circles").at(0).at("circle"), 2);
  EXPECT_TRUE(row.at("circles").at(1).at("to").is_null());
  EXPECT_FALSE(row.at("circles").at(1).contains("circle"));
  EXPECT_EQ(row.at("crossings").at("with_degree_4"), 20);
  EXPECT_EQ(row.at("t_junctions").at("found"), 50);
  EXPECT_EQ(row.at("corners").at("count"), 12);
  EXPECT_EQ(row.at("corners").at("open_meetings_near"), 5);
  EXPECT_TRUE(row.at("pairs").at(0).at("recall").is_null());
  EXPECT_EQ(row.at("pairs").at(1).at("recall"), 0.625);
}

TEST(ReportWriters, RodsAreInTextAtTheMiddleTauAndInJson) {
  EvaluationReport report = SmallReport();
  std::ostringstream without, table, json;
  PrintReport(report, without);
  EXPECT_THAT(without.str(), Not(HasSubstr("rods")));
  report.rows[1].features.rods = RodScores{40.5, 37.25, 0.875, 1.0625, 0.125, 0.375, 1.25};
  PrintReport(report, table);
  EXPECT_THAT(table.str(),
              HasSubstr("rods, at tau 0.01: 87.5 % of 40.5 told as rods, drawn 1.06 times, false "
                        "rods 0.125 per true length, median error 0.375, radius 1.25 of the true "
                        "one\n"));
  WriteReportJson(report, json);
  const nlohmann::json rows = nlohmann::json::parse(json.str()).at("rows");
  EXPECT_TRUE(rows.at(0).at("rods").is_null());
  const nlohmann::json& rods = rows.at(1).at("rods");
  EXPECT_EQ(rods.at("true_length"), 40.5);
  EXPECT_EQ(rods.at("drawn_length"), 37.25);
  EXPECT_EQ(rods.at("recall"), 0.875);
  EXPECT_EQ(rods.at("links_per_length"), 1.0625);
  EXPECT_EQ(rods.at("false_per_length"), 0.125);
  EXPECT_EQ(rods.at("median_error"), 0.375);
  EXPECT_EQ(rods.at("median_radius_ratio"), 1.25);
  report.rows[1].features.rods = RodScores{40.5, 0, 0, 2, 0, std::nullopt, std::nullopt};
  std::ostringstream of_none, json_of_none;
  PrintReport(report, of_none);
  EXPECT_THAT(of_none.str(), HasSubstr("false rods 0 per true length\n"));
  WriteReportJson(report, json_of_none);
  EXPECT_TRUE(nlohmann::json::parse(json_of_none.str())
                  .at("rows")
                  .at(1)
                  .at("rods")
                  .at("median_error")
                  .is_null());
}

TEST(ReportWriters, ReliabilityIsInTextAndJson) {
  EvaluationReport report = SmallReport();
  Reliability reliability;
  reliability.tau = 2;
  reliability.bins[3] = {4, 1.4, 1};
  reliability.bins[9] = {12, 11.4, 11.6};
  report.reliability = reliability;
  std::ostringstream table, json;
  PrintReport(report, table);
  EXPECT_THAT(table.str(), HasSubstr("calibration error 0.037"));  // (0.4 + 0.2) / 16
  EXPECT_THAT(table.str(), HasSubstr("0.3 to 0.4     0.350   0.250   0.250"));
  WriteReportJson(report, json);
  const nlohmann::json written = nlohmann::json::parse(json.str()).at("reliability");
  EXPECT_NEAR(written.at("calibration_error"), 0.6 / 16, 1e-12);
  EXPECT_EQ(written.at("bins").at(9).at("right"), 11.6);
}

TEST(ReportWriters, KindsAreInTextAndJson) {
  EvaluationReport report = SmallReport();
  KindConfusion kinds;
  kinds.tau = 2;
  kinds.length[static_cast<int>(LinkKind::kPaint)][static_cast<int>(LinkKind::kShadow)] = 1.5;
  report.kinds = kinds;
  std::ostringstream table, json;
  PrintReport(report, table);
  EXPECT_THAT(table.str(), HasSubstr("kind of the true curve within 2"));
  WriteReportJson(report, json);
  const nlohmann::json written = nlohmann::json::parse(json.str()).at("kinds");
  EXPECT_EQ(written.at("tau"), 2);
  EXPECT_EQ(written.at("length").at("paint").at("shadow"), 1.5);
  EXPECT_EQ(written.at("length").at("none").at("edge"), 0);
}

TEST(ReportWriters, CsvHasAsManyCellsAsColumns) {
  std::ostringstream out;
  WriteReportCsv(SmallReport(), out);
  std::istringstream lines(out.str());
  std::string header, first, second, rest;
  std::getline(lines, header);
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_FALSE(std::getline(lines, rest));
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(first), commas(header));
  EXPECT_EQ(commas(second), commas(header));
  EXPECT_THAT(header, ::testing::StartsWith("tau,precision,recall,f,"));
  EXPECT_THAT(first, ::testing::StartsWith("0.01,0.875,0.5,0.636,"));
  EXPECT_THAT(second, ::testing::StartsWith("0.01,,0.5,"));
}

TEST(ReportWriters, JsonHasNullForAbsentShares) {
  std::ostringstream out;
  WriteReportJson(SmallReport(), out);
  const nlohmann::json json = nlohmann::json::parse(out.str());
  EXPECT_EQ(json.at("unit"), "world");
  EXPECT_EQ(json.at("rows").at(0).at("precision"), 0.875);
  EXPECT_TRUE(json.at("rows").at(1).at("precision").is_null());
  EXPECT_EQ(json.at("nodes_by_degree").at("3"), 2);
  EXPECT_TRUE(json.at("saw_teeth").is_null());
}

TEST(ReportWriters, NormalizedErrorsAreToldWhereKnown) {
  EvaluationReport report;
  std::ostringstream without;
  PrintReport(report, without);
  EXPECT_EQ(without.str().find("normalised errors"), std::string::npos);
  report.normalized_errors = NormalizedErrors{40, 2, 1.25, 1.5, 0.75};
  std::ostringstream text;
  PrintReport(report, text);
  EXPECT_NE(text.str().find("mean 1.25, by the median 0.75 of 40 vertices"), std::string::npos);
  std::ostringstream json;
  WriteReportJson(report, json);
  const nlohmann::json errors = nlohmann::json::parse(json.str()).at("normalised_errors");
  EXPECT_EQ(errors.at("variance"), 1.25);
  EXPECT_EQ(errors.at("variance_with_false"), 1.5);
  EXPECT_EQ(errors.at("num_false"), 2);
}

TEST(ReportWriters, CamerasAreToldWhereKnown) {
  EvaluationReport report = SmallReport();
  std::ostringstream without, table, json;
  PrintReport(report, without);
  EXPECT_THAT(without.str(), Not(HasSubstr("cameras")));
  report.cameras = CameraAccuracy{28, 1, 0.0625, 0.125, 1.5, 0.75, 0.0025};
  PrintReport(report, table);
  EXPECT_THAT(table.str(), HasSubstr("median of 28: centers 0.0625, rotations 0.125 degrees = "
                                     "1.5 px, rays 0.75 px, focal lengths 0.25 %; 1 "));
  WriteReportJson(report, json);
  const nlohmann::json cameras = nlohmann::json::parse(json.str()).at("cameras");
  EXPECT_EQ(cameras.at("num_images"), 28);
  EXPECT_EQ(cameras.at("num_wrong"), 1);
  EXPECT_EQ(cameras.at("center"), 0.0625);
  EXPECT_EQ(cameras.at("rotation_px"), 1.5);
  EXPECT_EQ(cameras.at("focal"), 0.0025);
}

TEST(ReportWriters, SawTeethAreToldWhereKnown) {
  EvaluationReport report = SmallReport();
  std::ostringstream without, table, csv, json;
  PrintReport(report, without);
  EXPECT_THAT(without.str(), ::testing::Not(HasSubstr("saw-teeth")));
  report.saw_teeth = SawTeeth{1.25, 1.5, 1.125, {}, 11};
  PrintReport(report, table);
  EXPECT_THAT(table.str(), HasSubstr("median 1.25, 90th percentile 1.5 of 11 links"));
  WriteReportCsv(report, csv);
  EXPECT_THAT(csv.str(), HasSubstr(",1.25,1.5\n"));
  WriteReportJson(report, json);
  const nlohmann::json teeth = nlohmann::json::parse(json.str()).at("saw_teeth");
  EXPECT_EQ(teeth.at("median"), 1.25);
  EXPECT_TRUE(teeth.at("p90_by_length").is_null());
}

EvaluationReport ReportOfFaces() {
  EvaluationReport report;
  FaceScores& scores = report.faces.emplace();
  scores.rows = {{0.5, 0.25, 0.5, 0.3333, 1, 2}, {2, std::nullopt, 0.75, std::nullopt, 3, 4}};
  scores.max_angle_deg = 10;
  scores.area = 1.25;
  scores.true_area = 2.5;
  scores.faces = {{0, 1.0, {0.25, 0.5}}, {4, 0.25, {0.125, 1}}};
  scores.regions = {{7, 2.0, {0, 0.875}}};
  return report;
}

TEST(ReportWriters, FacesAreInTextAndJson) {
  std::ostringstream table, json;
  PrintReport(ReportOfFaces(), table);
  EXPECT_THAT(table.str(), HasSubstr("   0.5 rho       25.0       50.0       33.3          1"));
  EXPECT_THAT(table.str(), HasSubstr("     2 rho          -       75.0          -          3"));
  EXPECT_THAT(table.str(), HasSubstr("faces 2, area 1.25; true surface that is seen 2.5, smooth"));
  EXPECT_THAT(table.str(), Not(HasSubstr("links")));
  WriteReportJson(ReportOfFaces(), json);
  const nlohmann::json faces = nlohmann::json::parse(json.str()).at("faces");
  EXPECT_EQ(faces.at("rows").at(0).at("precision"), 0.25);
  EXPECT_TRUE(faces.at("rows").at(1).at("precision").is_null());
  EXPECT_EQ(faces.at("faces").at(1).at("face"), 4);
  EXPECT_EQ(faces.at("faces").at(1).at("within"), nlohmann::json({0.125, 1.0}));
  EXPECT_EQ(faces.at("regions").at(0).at("area"), 2.0);
  std::ostringstream without;
  WriteReportJson(SmallReport(), without);
  EXPECT_TRUE(nlohmann::json::parse(without.str()).at("faces").is_null());
}

TEST(ReportWriters, CsvIsOfFacesWhereThereAreNoCurves) {
  std::ostringstream csv;
  WriteReportCsv(ReportOfFaces(), csv);
  EXPECT_EQ(csv.str(),
            "tau,precision,recall,f,num_right_faces,num_covered_regions,"
            "max_angle_deg,faces,area,true_area,regions\n"
            "0.5,0.25,0.5,0.3333,1,2,10,2,1.25,2.5,1\n"
            "2.0,,0.75,,3,4,10,2,1.25,2.5,1\n");
}

TEST(ReportWriters, WireframesAreAllThatIsToldOfThem) {
  EvaluationReport report;
  report.hss = HssScores();
  HssScores& scores = *report.hss;
  scores.num_corners = 8;
  scores.num_true_corners = 5;
  scores.num_right_corners = 4;
  scores.corner_precision = 0.5;
  scores.corner_recall = 0.8;
  scores.corner_f1 = 0.6154;
  scores.edges = {2, 3, 1.25, 0.00005};
  scores.edge_iou = 0.3333;
  scores.hss = 0.4324;
  std::ostringstream table, csv, json;
  PrintReport(report, table);
  EXPECT_THAT(table.str(),
              HasSubstr("    8        50.0        80.0        61.5        33.3        43.2"));
  EXPECT_THAT(table.str(), HasSubstr("corners right 4 of 8, true 5;"));
  EXPECT_THAT(
      table.str(),
      HasSubstr("volume 2 m3, true 3, common 1.25 (denser lines changed the IoU by 0.005 %)"));
  EXPECT_THAT(table.str(), Not(HasSubstr("links")));
  WriteReportCsv(report, csv);
  EXPECT_THAT(csv.str(), ::testing::StartsWith("corner_f1,edge_iou,hss,"));
  EXPECT_THAT(csv.str(), HasSubstr("\n0.6154,0.3333,0.4324,0.5,0.8,8,5,4,"));
  EXPECT_EQ(std::ranges::count(csv.str(), '\n'), 2);
  WriteReportJson(report, json);
  const nlohmann::json all = nlohmann::json::parse(json.str());
  EXPECT_EQ(all.at("hss").at("common_edge_volume"), 1.25);
  EXPECT_EQ(all.at("unit"), "m");
  EXPECT_EQ(all.size(), 2u);
}

}  // namespace
}  // namespace limn
