// SPDX-License-Identifier: BSD-3-Clause
#include "limn/formats/svg/svg_drawing_writer.h"

#include <regex>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/formats/picture_scene.h"
#include "limn/formats/svg/path.h"
#include "limn/model/drawing_transform.h"
#include "limn/util/errors.h"
#include "limn/visibility/render_depth.h"
#include "support/synthetic_scene.h"

namespace limn {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

template <typename Where>
std::string WrittenSvg(const DrawingGraph& graph, const Where& where, const IsHidden& is_hidden,
                       const SvgOptions& options, SvgSummary* summary = nullptr) {
  std::ostringstream out;
  const SvgSummary counts = WriteDrawingSvg(graph, where, is_hidden, options, out);
  if (summary) *summary = counts;
  return out.str();
}

int Count(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), {}));
}

std::string PathOf(const std::string& svg, int link) {
  std::smatch match;
  const std::regex regex("id=\"link_" + std::to_string(link) + "\"[^>]* d=\"([^\"]*)\"");
  return std::regex_search(svg, match, regex) ? match[1].str() : "";
}

SvgSheet SceneSheet(SvgProjection projection, double scale = 20) {
  SheetOptions options;
  options.projection = projection;
  options.unit = LengthUnit::kMeter;
  options.sheet_scale = scale;
  return MakeSheet(PictureScene(), options);
}

TEST(PictureScene, IsValid) { EXPECT_THAT(Validate(PictureScene()), ::testing::IsEmpty()); }

TEST(WriteDrawingSvg, EveryLinkAndJunctionHasItsElement) {
  const DrawingGraph graph = PictureScene();
  SvgSummary summary;
  const std::string view = WrittenSvg(graph, SceneView(), {}, {}, &summary);
  EXPECT_EQ(Count(view, "<path id=\"link_[0-9]+\""), 9);
  EXPECT_EQ(summary.num_drawn, 9);
  EXPECT_EQ(Count(view, "<circle id=\"node_"), 1);
  EXPECT_THAT(view, HasSubstr("width=\"640\" height=\"480\" viewBox=\"0 0 640 480\""));
  for (const char* type : {"line", "circle", "arc", "spline", "polyline"}) {
    EXPECT_THAT(view, HasSubstr(std::string("class=\"") + type + "\"")) << type;
  }
  EXPECT_THAT(view, Not(HasSubstr("<image")));
  EXPECT_EQ(view, WrittenSvg(graph, SceneView(), {}, {}));
}

TEST(WriteDrawingSvg, ParallelProjectionKeepsShapes) {
  const std::string svg =
      WrittenSvg(PictureScene(), SceneSheet(SvgProjection::kAxonometric), {}, {});
  EXPECT_EQ(Count(PathOf(svg, 0), "l"), 1);
  EXPECT_EQ(Count(PathOf(svg, 0), "[ca]"), 0);
  EXPECT_EQ(Count(PathOf(svg, 3), "[lc]"), 0);  // arcs only
  EXPECT_EQ(Count(PathOf(svg, 3), "a"), 1);     // the letter is not repeated
  EXPECT_EQ(Count(PathOf(svg, 4), "[lc]"), 0);
  EXPECT_EQ(Count(PathOf(svg, 5), "[la]"), 0);
  // Three knot intervals, three places each.
  EXPECT_EQ(Count(PathOf(svg, 5), "-?[0-9.]+"), 2 + 3 * 6);
  SvgOptions options;
  options.use_primitives = false;
  const std::string points =
      WrittenSvg(PictureScene(), SceneSheet(SvgProjection::kAxonometric), {}, options);
  EXPECT_EQ(Count(PathOf(points, 3), "a"), 0);
}

TEST(WriteDrawingSvg, ACircleSeenFromItsSideIsALine) {
  DrawingGraph graph;
  const CircularArc arc = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, 2 * M_PI};
  AddLink(SampleShape(arc, 1e-4), CurveShape(arc), &graph);
  RebuildIncidence(&graph);
  SheetOptions options;
  options.projection = SvgProjection::kFront;
  const std::string svg = WrittenSvg(graph, MakeSheet(graph, options), {}, {});
  EXPECT_EQ(Count(PathOf(svg, 0), "[ac]"), 0);
  EXPECT_GE(Count(PathOf(svg, 0), "l"), 1);
}

TEST(WriteDrawingSvg, SheetsAreToScale) {
  const DrawingGraph graph = PictureScene();
  for (const SvgProjection projection :
       {SvgProjection::kTop, SvgProjection::kFront, SvgProjection::kRight}) {
    const std::string svg = WrittenSvg(graph, SceneSheet(projection), {}, {});
    std::smatch match;
    ASSERT_TRUE(std::regex_search(
        svg, match,
        std::regex("width=\"([0-9.]+)mm\" height=\"([0-9.]+)mm\" viewBox=\"([-0-9.]+) ([-0-9.]+) "
                   "([0-9.]+) ([0-9.]+)\"")));
    // 1:20: a unit is 50 mm.
    EXPECT_NEAR(std::stod(match[1]), 50 * std::stod(match[5]), 0.02);
    EXPECT_NEAR(std::stod(match[2]), 50 * std::stod(match[6]), 0.02);
    EXPECT_THAT(svg, HasSubstr(">1:20<"));
    EXPECT_THAT(svg, HasSubstr("id=\"legend\""));
  }
}

TEST(MakeSheet, TakesAScaleThatFitsOnA3) {
  DrawingGraph graph;
  for (const double size : {0.003, 0.3, 7.0, 40.0, 90'000.0}) {
    graph = {};
    AddLink({{0, 0, 0}, {size, 0, 0}, {size, 0.4 * size, 0}}, std::nullopt, &graph);
    RebuildIncidence(&graph);
    const SvgSheet sheet = MakeSheet(graph, {});
    EXPECT_LE(sheet.PaperMm().x(), 400.01) << size;
    EXPECT_LE(sheet.PaperMm().y(), 277.01) << size;
    // The next larger scale would not fit.
    EXPECT_GT(sheet.PaperMm().x() - 20, 380 / 2.5 - 0.01) << size;
  }
  SvgSheet sheet;
  sheet.unit = LengthUnit::kFoot;
  sheet.scale_denominator = 50;
  EXPECT_EQ(ScaleText(sheet), "1:50");
  sheet.scale_denominator = 0.2;
  EXPECT_EQ(ScaleText(sheet), "5:1");
  EXPECT_THROW(MakeSheet({}, {}), InputError);
}

TEST(MakeSheet, ProjectionsShowTheirAxes) {
  const Eigen::Vector3d point(1, 2, 4);
  const auto place = [&](SvgProjection projection) {
    return SceneSheet(projection).ToSheet(point);
  };
  EXPECT_EQ(place(SvgProjection::kTop), Eigen::Vector2d(1, -2));
  EXPECT_EQ(place(SvgProjection::kFront), Eigen::Vector2d(1, -4));
  EXPECT_EQ(place(SvgProjection::kRight), Eigen::Vector2d(2, -4));
  // Isometric from the front right: x and y to the right, z up, all of the same length.
  const SvgSheet sheet = SceneSheet(SvgProjection::kAxonometric);
  EXPECT_LT((sheet.ToSheet({1, 0, 0}) - Eigen::Vector2d(std::sqrt(0.5), std::sqrt(1 / 6.0))).norm(),
            1e-12);
  EXPECT_LT(
      (sheet.ToSheet({0, 1, 0}) - Eigen::Vector2d(std::sqrt(0.5), -std::sqrt(1 / 6.0))).norm(),
      1e-12);
  EXPECT_LT((sheet.ToSheet({0, 0, 1}) - Eigen::Vector2d(0, -std::sqrt(2 / 3.0))).norm(), 1e-12);
  for (const SvgProjection projection : {SvgProjection::kTop, SvgProjection::kFront,
                                         SvgProjection::kRight, SvgProjection::kAxonometric}) {
    const Eigen::Matrix3d axes = SceneSheet(projection).axes;
    EXPECT_LT((axes * axes.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(axes.determinant(), 1, 1e-12);  // right, down, forward
  }
}

// A letter on a wall, read by who stands before it and looks `forward`.
DrawingGraph LetterF(const Eigen::Vector3d& forward, const Eigen::Vector3d& up) {
  const Eigen::Vector3d right = forward.cross(up);
  const Eigen::Vector3d top = 2 * up, middle = up, o = Eigen::Vector3d::Zero();
  DrawingGraph graph;
  for (const auto& [from, to] : {std::pair(o, top), {top, top + right}, {middle, middle + right}}) {
    AddLink({from, to}, std::nullopt, &graph);
  }
  RebuildIncidence(&graph);
  return graph;
}

TEST(MakeSheet, LettersAreNotMirrored) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  for (const Eigen::Vector3d& front :
       {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0.6, -0.8, 0)}) {
    const Eigen::Vector3d to_the_right = front.cross(up);
    using enum SvgProjection;
    const std::tuple<SvgProjection, Eigen::Vector3d, Eigen::Vector3d> views[] = {
        {kFront, front, up},       {kBack, -front, up}, {kRight, -to_the_right, up},
        {kLeft, to_the_right, up}, {kTop, -up, front},  {kBottom, up, -front}};
    for (const auto& [projection, forward, up_on_paper] : views) {
      SCOPED_TRACE(static_cast<int>(projection));
      SheetOptions options;
      options.projection = projection;
      options.front = front;
      const DrawingGraph letter = LetterF(forward, up_on_paper);
      const SvgSheet sheet = MakeSheet(letter, options);
      const auto place = [&](int link, int point) {
        return sheet.ToSheet(letter.links[link].points_in_world[point]);
      };
      const Eigen::Vector2d stem = place(0, 1) - place(0, 0);
      const Eigen::Vector2d arm = place(1, 1) - place(1, 0);
      EXPECT_LT((stem - Eigen::Vector2d(0, -2)).norm(), 1e-12);  // y is down
      EXPECT_LT((arm - Eigen::Vector2d(1, 0)).norm(), 1e-12);
    }
  }
}

TEST(MakeSheet, WithoutAUnitThereIsNoScale) {
  const DrawingGraph graph = PictureScene();
  const std::string svg = WrittenSvg(graph, MakeSheet(graph, {}), {}, {});
  EXPECT_EQ(Count(svg, "1:[0-9]"), 0);
  EXPECT_EQ(Count(svg, "[0-9] k?[cm]?m<"), 0);
  EXPECT_THAT(svg, HasSubstr("model units<"));
  EXPECT_THAT(svg, HasSubstr("Without a scale"));
  SheetOptions options;
  options.sheet_scale = 20;
  EXPECT_THAT(ErrorText<OptionError>([&] { MakeSheet(graph, options); }),
              HasSubstr("the unit of the drawing is not known"));
}

TEST(MakeSheet, TheScaleIsThatOfTheUnit) {
  const DrawingGraph in_meters = PictureScene();
  const Eigen::Vector2d paper = SceneSheet(SvgProjection::kTop).PaperMm();
  for (const LengthUnit unit : {LengthUnit::kMillimeter, LengthUnit::kFoot}) {
    SheetOptions options;
    options.unit = unit;
    options.sheet_scale = 20;
    const DrawingGraph graph = Transformed(in_meters, 1000 / Millimeters(unit),
                                           Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
    const SvgSheet sheet = MakeSheet(graph, options);
    EXPECT_LT((sheet.PaperMm() - paper).norm(), 1e-9);
    EXPECT_THAT(WrittenSvg(graph, sheet, {}, {}),
                HasSubstr(unit == LengthUnit::kFoot ? " ft<" : " m<"));
  }
}

TEST(MakeSheet, FarFromTheOriginNumbersStayShort) {
  DrawingGraph graph = PictureScene();
  const Eigen::Vector3d shift(4'500'000.25, 651'234.5, 100);
  for (DrawingNode& node : graph.nodes) node.position_in_world += shift;
  for (DrawingLink& link : graph.links) {
    for (Eigen::Vector3d& point : link.points_in_world) point += shift;
    if (link.primitive) {
      link.primitive->shape =
          Transformed(link.primitive->shape, 1, Eigen::Matrix3d::Identity(), shift);
    }
  }
  const SvgSheet sheet = MakeSheet(graph, {});
  EXPECT_LT(sheet.paper_max.norm(), 10);
  EXPECT_EQ(sheet.origin, Eigen::Vector2d(sheet.origin.array().round()));
  const std::string svg = WrittenSvg(graph, sheet, {}, {});
  EXPECT_THAT(svg,
              HasSubstr(SvgNumber(sheet.origin.x(), 0) + ", " + SvgNumber(sheet.origin.y(), 0)));
  EXPECT_EQ(Count(svg, "id=\"link_"), 9);
}

TEST(WriteDrawingSvg, HiddenPartsAreRemovedOrDashed) {
  const DrawingGraph graph = PictureScene();
  const View view = SceneView();
  const IsHidden hidden = HiddenInView(view, RenderDepth(SceneWall(), view, 1));
  const std::string removed = WrittenSvg(graph, view, hidden, {});
  EXPECT_EQ(Count(PathOf(removed, 8), "m"), 2);  // a gap in the middle
  EXPECT_EQ(Count(PathOf(removed, 0), "m"), 1);
  EXPECT_EQ(Count(removed, "class=\"hidden\""), 0);
  SvgOptions options;
  options.hidden_parts = SvgHiddenParts::kDashed;
  const std::string dashed = WrittenSvg(graph, view, hidden, options);
  EXPECT_EQ(Count(dashed, "<g id=\"link_8\""), 1);
  EXPECT_EQ(Count(dashed, "class=\"hidden\""), 1);
  EXPECT_EQ(Count(dashed, "id=\"link_"), 9);
}

TEST(WriteDrawingSvg, CountsWhatIsHiddenOrOutside) {
  DrawingGraph graph;
  AddLink({{-0.2, 0, 5}, {0.2, 0, 5}}, std::nullopt, &graph);  // behind
  AddLink({{-0.2, 0, 1}, {0.2, 0.1, 1}}, std::nullopt, &graph);
  AddLink({{50, 0, 1}, {51, 0.1, 1}}, std::nullopt, &graph);
  AddLink({{0, 0, -1}, {0, 0.1, -1}}, std::nullopt, &graph);
  RebuildIncidence(&graph);
  const View view = testing::ForwardView();
  const TriangleMesh wall = MakeTriangleMesh({{-9, -9, 3}, {9, -9, 3}, {0, 9, 3}}, {{0, 1, 2}});
  SvgSummary summary;
  const std::string svg =
      WrittenSvg(graph, view, HiddenInView(view, RenderDepth(wall, view, 1)), {}, &summary);
  EXPECT_EQ(summary.num_drawn, 1);
  EXPECT_EQ(summary.num_hidden, 1);
  EXPECT_EQ(summary.num_outside, 2);
  EXPECT_EQ(PathOf(svg, 1), "m30.5 50.5l40 10");
}

TEST(WriteDrawingSvg, PhotographAndTitleAreEscaped) {
  SvgOptions options;
  options.title = "a < b & \"c\"";
  options.photo = "sub dir/50%&#1.jpg";
  const std::string svg = WrittenSvg(PictureScene(), SceneView(), {}, options);
  EXPECT_THAT(svg, HasSubstr("<title>a &lt; b &amp; &quot;c&quot;</title>"));
  EXPECT_THAT(svg, HasSubstr("href=\"sub%20dir/50%25&amp;%231.jpg\""));
}

TEST(WriteDrawingSvg, ColorsAndClasses) {
  DrawingGraph graph = PictureScene();
  graph.links[3].dense = LinkDense{.dense_class = DenseClass::kBoundary};
  SvgOptions options;
  options.colors = SvgColors::kLink;
  EXPECT_EQ(Count(WrittenSvg(graph, SceneView(), {}, options), " stroke=\"#[0-9a-f]{6}\""), 9);
  options.colors = SvgColors::kClass;
  const std::string svg = WrittenSvg(graph, SceneView(), {}, options);
  EXPECT_THAT(svg, HasSubstr("class=\"circle boundary\""));
  EXPECT_THAT(svg, HasSubstr(".boundary{stroke:"));
  graph.links[3].kind = LinkKind::kShadow;
  graph.links[3].tentative = true;
  options.colors = SvgColors::kKind;
  const std::string kinds = WrittenSvg(graph, SceneView(), {}, options);
  EXPECT_THAT(kinds, HasSubstr("class=\"circle boundary kind-shadow tentative\""));
  EXPECT_THAT(kinds, HasSubstr(".kind-shadow{stroke:"));
}

TEST(WriteDrawingSvg, RodsHaveTheirRadius) {
  DrawingGraph graph = PictureScene();
  graph.links[3].kind = LinkKind::kRod;
  graph.links[3].rod_radius = 0.375;
  SvgOptions options;
  options.colors = SvgColors::kKind;
  const std::string svg = WrittenSvg(graph, SceneView(), {}, options);
  EXPECT_THAT(svg, HasSubstr("id=\"link_3\" class=\"circle kind-rod\" data-radius=\"0.375\""));
  EXPECT_THAT(svg, HasSubstr(".kind-rod{stroke:"));
  EXPECT_EQ(Count(svg, "data-radius"), 1);
}

TEST(WriteDrawingSvg, RefusesOptionsOutOfRange) {
  SvgOptions options;
  options.line_width_px = 0;
  EXPECT_THROW(WrittenSvg(PictureScene(), SceneView(), {}, options), OptionError);
  options = {};
  options.tolerance_px = std::nan("");
  EXPECT_THROW(WrittenSvg(PictureScene(), SceneView(), {}, options), OptionError);
  SheetOptions sheet;
  sheet.elevation_deg = 91;
  EXPECT_THROW(MakeSheet(PictureScene(), sheet), OptionError);
  sheet = {};
  sheet.unit = LengthUnit::kMeter;
  sheet.sheet_scale = 0.001;  // four kilometers of paper
  EXPECT_THAT(ErrorText<OptionError>([&] { MakeSheet(PictureScene(), sheet); }),
              StartsWith("sheet_scale = 0.001"));
  sheet.sheet_scale = -1;
  EXPECT_THROW(MakeSheet(PictureScene(), sheet), OptionError);
}

TEST(FindRuns, ShortRunsGoWithWhatIsAround) {
  std::vector<CurveSample> samples;
  for (int k = 0; k <= 100; ++k) samples.push_back({0.01 * k, static_cast<double>(k)});
  const auto point_at = [](double t) { return Eigen::Vector3d(t, 0, 0); };
  // Hidden: 0.2 to 0.22 (short), 0.5 to 0.9 but for 0.7 to 0.72 (short).
  const IsHidden hidden = [](const Eigen::Vector3d& p) {
    return (p.x() > 0.2 && p.x() < 0.22) ||
           (p.x() > 0.5 && p.x() < 0.9 && !(p.x() > 0.7 && p.x() < 0.72));
  };
  const std::vector<ShownRun> runs = FindRuns(point_at, samples, hidden, 6);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_FALSE(runs[0].hidden);
  EXPECT_NEAR(runs[0].to, 0.5, 0.001);
  EXPECT_TRUE(runs[1].hidden);
  EXPECT_NEAR(runs[1].to, 0.9, 0.001);
  EXPECT_EQ(runs[2].to, 1);
  EXPECT_EQ(FindRuns(point_at, samples, hidden, 0).size(), 7u);
}

TEST(SvgPath, NumbersAreShortAndErrorsDoNotAddUp) {
  EXPECT_EQ(SvgNumber(0.5, 2), ".5");
  EXPECT_EQ(SvgNumber(-0.25, 2), "-.25");
  EXPECT_EQ(SvgNumber(100, 2), "100");
  EXPECT_EQ(SvgNumber(-0.001, 2), "0");
  EXPECT_EQ(DecimalsFor(0.005), 2);
  EXPECT_EQ(DecimalsFor(5), 0);
  SvgPath path(1);
  path.MoveTo({0.04, 0});
  for (int k = 1; k <= 4; ++k) path.LineTo({0.04 + 0.14 * k, -1.0 * k});
  EXPECT_EQ(path.text(), "m0 0l.2-1 .1-1 .2-1 .1-1");  // 0, .2, .3, .5, .6
}

}  // namespace
}  // namespace limn
