// SPDX-License-Identifier: BSD-3-Clause
#include "limn/cache/stage_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "limn/cache/curve_sketch_file.h"
#include "limn/cache/image_curves_file.h"
#include "limn/cache/view_sketch_file.h"
#include "limn/formats/temporary_folder.h"
#include "limn/sketch/sketch_of_depths.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

ImageCurves SmallImageCurves() {
  ImageCurves curves;
  curves.edge_map.width = 640;
  curves.edge_map.height = 360;
  curves.edge_map.gradient_noise = 0.75;
  curves.edge_map.num_outside_lens = 2;
  for (int i = 0; i < 10; ++i) {
    Edgel edgel;
    edgel.position_px = {i + 0.1, 2 * i + 1.0 / 3};
    edgel.tangent_rad = 0.3 * i - 1;
    edgel.strength = 5.5f;
    edgel.position_sigma_px = 0.1f;
    edgel.stored_px = {1.f * i, 2.f * i};
    edgel.stored_from_virtual << 1, 0.5f, -0.25f, 2;
    curves.edge_map.edgels.push_back(edgel);
  }
  curves.edge_map.texture = {4, 6};
  curves.fragments = {{{0, 1, 2, 3}, false}, {{9, 8, 7}, true}, {{}, false}};
  curves.num_unlinked = 3;
  return curves;
}

// What the sketch is made from: two views with a fragment of 13 edgels each.
std::vector<ImageCurves> SketchedCurves() {
  ImageCurves curves;
  curves.edge_map.edgels.resize(13);
  curves.fragments.resize(1);
  for (EdgelId id = 0; id < 13; ++id) curves.fragments[0].edgel_ids.push_back(id);
  return {curves, curves};
}

CurveSketch SmallSketch() {
  CurveSketch sketch;
  for (int c = 0; c < 3; ++c) {
    Curve3D curve;
    for (int i = 0; i < 5 * c; ++i) {
      curve.points_in_world.emplace_back(i, c, 1.0 / 3);
      curve.tangents_in_world.emplace_back(1, 0, 0);
      curve.depth_sigma.push_back(i == 2 ? std::numeric_limits<double>::infinity() : 0.5);
      curve.certain.push_back(i != 2);
      std::vector<EdgelRef> support;
      for (int view = 0; view < 2; ++view) support.push_back({view, 3 + i});
      curve.support.Append(support);
    }
    curve.anchor = {c % 2, 0, 3};
    curve.closed = c == 2;
    curve.total_support = 100.5 * c;
    sketch.curves.push_back(curve);
  }
  return sketch;
}

const DrawingMetadata kMetadata{{"a.png", "dir/b.png"}, "{\"a\": 1}"};

TEST(ImageCurvesFile, RoundTrip) {
  const TemporaryFolder folder;
  const ImageCurves written = SmallImageCurves();
  WriteImageCurves(folder.Path("a.bin"), written, "options 1");
  const std::optional<ImageCurves> read = ReadImageCurves(folder.Path("a.bin"), "options 1");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->edge_map.width, 640);
  EXPECT_EQ(read->edge_map.height, 360);
  EXPECT_EQ(read->edge_map.gradient_noise, 0.75);
  EXPECT_EQ(read->edge_map.num_outside_lens, 2);
  EXPECT_EQ(read->edge_map.texture, written.edge_map.texture);
  ASSERT_EQ(read->edge_map.edgels.size(), 10u);
  for (int i = 0; i < 10; ++i) {
    const Edgel& a = written.edge_map.edgels[i];
    const Edgel& b = read->edge_map.edgels[i];
    EXPECT_EQ(a.position_px, b.position_px);
    EXPECT_EQ(a.tangent_rad, b.tangent_rad);
    EXPECT_EQ(a.strength, b.strength);
    EXPECT_EQ(a.position_sigma_px, b.position_sigma_px);
    EXPECT_EQ(a.stored_px, b.stored_px);
    EXPECT_EQ(a.stored_from_virtual, b.stored_from_virtual);
  }
  ASSERT_EQ(read->fragments.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(read->fragments[i].edgel_ids, written.fragments[i].edgel_ids);
    EXPECT_EQ(read->fragments[i].closed, written.fragments[i].closed);
  }
  EXPECT_EQ(read->num_unlinked, 3);
  WriteImageCurves(folder.Path("b.bin"), *read, "options 1");
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("a.bin")),
            TemporaryFolder::Read(folder.Path("b.bin")));
}

TEST(ImageCurvesFile, WithoutLens) {
  const TemporaryFolder folder;
  ImageCurves written = SmallImageCurves();
  WriteImageCurves(folder.Path("lens.bin"), written, "");
  ApplyLens(nullptr, &written.edge_map);
  for (Edgel& edgel : written.edge_map.edgels) edgel.stored_from_virtual.setIdentity();
  WriteImageCurves(folder.Path("a.bin"), written, "");
  // What follows from the positions is not told again.
  EXPECT_LT(std::filesystem::file_size(folder.Path("a.bin")) + 100,
            std::filesystem::file_size(folder.Path("lens.bin")));
  const std::optional<ImageCurves> read = ReadImageCurves(folder.Path("a.bin"), "");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->edge_map.edgels.size(), 10u);
  for (int i = 0; i < 10; ++i) {
    const Edgel& a = written.edge_map.edgels[i];
    const Edgel& b = read->edge_map.edgels[i];
    EXPECT_EQ(a.position_px, b.position_px);
    EXPECT_EQ(a.strength, b.strength);
    EXPECT_EQ(a.stored_px, b.stored_px);
    EXPECT_EQ(a.stored_from_virtual, b.stored_from_virtual);
  }
}

TEST(CurveSketchFile, OptionsAreAnObject) {
  const TemporaryFolder folder;
  for (const char* options : {"", "[]", "{\"mo", "{\"a\": \"\xFF\"}"}) {
    DrawingMetadata metadata = kMetadata;
    metadata.options_json = options;
    WriteCurveSketch(folder.Path("a.bin"), SmallSketch(), metadata, "x");
    EXPECT_THROW(ReadCurveSketch(folder.Path("a.bin"), SketchedCurves(), ""), IoError) << options;
  }
}

TEST(CurveSketchFile, RoundTrip) {
  const TemporaryFolder folder;
  const CurveSketch written = SmallSketch();
  WriteCurveSketch(folder.Path("a.bin"), written, kMetadata, "x");
  const std::optional<StoredCurveSketch> read =
      ReadCurveSketch(folder.Path("a.bin"), SketchedCurves(), "");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->metadata.view_names, kMetadata.view_names);
  EXPECT_EQ(read->metadata.options_json, kMetadata.options_json);
  ASSERT_EQ(read->sketch.curves.size(), written.curves.size());
  for (size_t c = 0; c < written.curves.size(); ++c) {
    const Curve3D& a = written.curves[c];
    const Curve3D& b = read->sketch.curves[c];
    EXPECT_EQ(a.points_in_world, b.points_in_world);
    EXPECT_EQ(a.tangents_in_world, b.tangents_in_world);
    EXPECT_EQ(a.depth_sigma, b.depth_sigma);
    EXPECT_EQ(a.certain, b.certain);
    EXPECT_EQ(a.support.offsets, b.support.offsets);
    EXPECT_EQ(a.support.edgels, b.support.edgels);
    EXPECT_EQ(a.anchor.view, b.anchor.view);
    EXPECT_EQ(a.anchor.fragment, b.anchor.fragment);
    EXPECT_EQ(a.anchor.begin, b.anchor.begin);
    EXPECT_EQ(a.anchor.step, b.anchor.step);
    EXPECT_EQ(a.closed, b.closed);
    EXPECT_EQ(a.total_support, b.total_support);
  }
}

TEST(CurveSketchFile, BeginsWithTheRefinedCameras) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.bin");
  EXPECT_EQ(RefinedCamerasOfSketch(path), "");
  DrawingMetadata metadata = kMetadata;
  for (const char* cameras : {"", "0123456789abcdef"}) {
    metadata.refined_cameras = cameras;
    WriteCurveSketch(path, SmallSketch(), metadata, "x");
    EXPECT_EQ(ReadCurveSketch(path, SketchedCurves(), "")->metadata.refined_cameras, cameras);
    EXPECT_EQ(RefinedCamerasOfSketch(path), cameras);
  }
}

// A view that looks along z, with a fragment of 40 edgels in a row, and another one.
std::vector<View> SketchedViews() {
  View view;
  view.camera = {100, 100, 32, 24, 64, 48};
  return {view, view, view};
}

std::vector<ImageCurves> RowsOfEdgels() {
  ImageCurves curves;
  curves.fragments.resize(2);
  for (EdgelId id = 0; id < 50; ++id) {
    Edgel& edgel = curves.edge_map.edgels.emplace_back();
    edgel.position_px = {id % 40 + 0.25, 20.0 + id / 40};
    edgel.stored_px = edgel.position_px.cast<float>();
    curves.fragments[id / 40].edgel_ids.push_back(id);
  }
  return {curves, curves, curves};
}

// Of view 1: depths every 3 px of its first fragment, but for one.
ViewDepths SmallDepths() {
  ViewDepths depths;
  depths.spacing_px = 3;
  depths.of_fragment.resize(2);
  DepthProfile& profile = depths.of_fragment[0];
  for (int i = 0; i < 14; ++i) {
    profile.depths.push_back({i != 6, i > 2, 0.5 + 0.001 * i, 0, 3.0 + i, 80});
    profile.fates.push_back(EdgelFate::kNoPartner);
  }
  return depths;
}

// With every edgel supported by its own, most of them by view 0, and some by view 2.
std::vector<Curve3D> SmallCurves(const ViewDepths& depths) {
  const std::vector<ImageCurves> curves = RowsOfEdgels();
  ViewSketch sketch = SketchOfDepths(1, SketchedViews()[1], curves[1], depths);
  for (Curve3D& curve : sketch.curves) {
    for (int s = 0; s < static_cast<int>(curve.size()); ++s) {
      std::vector<EdgelRef> support;
      if (s % 5 != 0) support.push_back({0, s + 3});
      support.push_back({1, static_cast<EdgelId>(curve.anchor.VertexOf(s, 40))});
      if (s > 8) support.push_back({2, 30 - s});
      curve.support.Append(support);
    }
  }
  return sketch.curves;
}

void ExpectViewSketchRoundTrip(const ViewDepths& depths) {
  const TemporaryFolder folder;
  const std::vector<ImageCurves> curves = RowsOfEdgels();
  const std::vector<Curve3D> written = SmallCurves(depths);
  ASSERT_EQ(written.size(), 2u);
  const std::string path = folder.Path("a.bin");
  WriteViewSketch(path, depths, written, {0, 1, 2}, curves, "x");
  const std::optional<ViewSketch> read =
      ReadViewSketch(path, 1, {0, 1, 2}, SketchedViews(), curves, "x");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->curves.size(), 2u);
  for (size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(read->curves[c].points_in_world, written[c].points_in_world);
    EXPECT_EQ(read->curves[c].tangents_in_world, written[c].tangents_in_world);
    EXPECT_EQ(read->curves[c].depth_sigma, written[c].depth_sigma);
    EXPECT_EQ(read->curves[c].certain, written[c].certain);
    EXPECT_EQ(read->curves[c].support.offsets, written[c].support.offsets);
    EXPECT_EQ(read->curves[c].support.edgels, written[c].support.edgels);
  }
  EXPECT_EQ(read->fates[18], EdgelFate::kNoPartner);
  EXPECT_EQ(read->fates[39], EdgelFate::kSketched);
  EXPECT_EQ(read->fates[45], EdgelFate::kFragmentTooShort);
  EXPECT_FALSE(ReadViewSketch(path, 1, {0, 1, 2}, SketchedViews(), curves, "y"));
}

TEST(ViewSketchFile, RoundTrip) { ExpectViewSketchRoundTrip(SmallDepths()); }

TEST(ViewSketchFile, RoundTripOfEveryThirdVertex) {
  ViewDepths depths = SmallDepths();
  depths.sample_step = 3;
  ExpectViewSketchRoundTrip(depths);
}

TEST(ViewSketchFile, ViewsMayComeAndGo) {
  const TemporaryFolder folder;
  const std::vector<Curve3D> written = SmallCurves(SmallDepths());
  const std::string path = folder.Path("a.bin");
  WriteViewSketch(path, SmallDepths(), written, {0, 1, 2}, RowsOfEdgels(), "x");
  // View 0 is gone, two others have come.
  std::vector<View> views = SketchedViews();
  views.push_back(views[0]);
  std::vector<ImageCurves> curves = RowsOfEdgels();
  curves.push_back(curves[0]);
  const auto read = ReadViewSketch(path, 2, {-1, 2, 3}, views, curves, "x");
  ASSERT_TRUE(read);
  for (size_t c = 0; c < written.size(); ++c) {
    EXPECT_EQ(read->curves[c].anchor.view, 2);
    for (size_t s = 0; s < written[c].size(); ++s) {
      std::vector<EdgelRef> expected;
      for (const EdgelRef& ref : written[c].support.Of(s)) {
        if (ref.view > 0) expected.push_back({ref.view + 1, ref.edgel});
      }
      EXPECT_TRUE(std::ranges::equal(read->curves[c].support.Of(s), expected));
    }
  }
}

TEST(StageFile, OtherIdentityOrVersionMeansMakeItAnew) {
  const TemporaryFolder folder;
  WriteStageFile(folder.Path("a.bin"), StageKind::kImageCurves, "mine", "payload");
  EXPECT_EQ(ReadStageFile(folder.Path("a.bin"), StageKind::kImageCurves, "mine"), "payload");
  EXPECT_EQ(ReadStageFile(folder.Path("a.bin"), StageKind::kImageCurves, ""), "payload");
  EXPECT_EQ(ReadStageFile(folder.Path("a.bin"), StageKind::kImageCurves, "yours"), std::nullopt);
  EXPECT_THROW(ReadStageFile(folder.Path("a.bin"), StageKind::kCurveSketch, "mine"), IoError);
  std::string bytes = TemporaryFolder::Read(folder.Path("a.bin"));
  bytes[8] = 99;  // the format version
  EXPECT_EQ(ReadStageFile(folder.Write("v.bin", bytes), StageKind::kImageCurves, "mine"),
            std::nullopt);
}

TEST(StageFile, EveryCutAndEveryFlippedBitIsNoticed) {
  const TemporaryFolder folder;
  WriteImageCurves(folder.Path("a.bin"), SmallImageCurves(), "id");
  const std::string bytes = TemporaryFolder::Read(folder.Path("a.bin"));
  const auto is_refused = [&](const std::string& damaged) {
    const std::string path = folder.Write("damaged.bin", damaged);
    try {
      return !ReadImageCurves(path, "id").has_value();
    } catch (const IoError&) {
      return true;
    }
  };
  EXPECT_FALSE(is_refused(bytes));
  for (size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_TRUE(is_refused(bytes.substr(0, length))) << length;
  }
  for (size_t at = 0; at < bytes.size(); ++at) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    EXPECT_TRUE(is_refused(damaged)) << at;
  }
  EXPECT_TRUE(is_refused(bytes + "x"));
  EXPECT_THROW(ReadImageCurves(folder.Path("absent.bin"), "id"), IoError);
}

TEST(StageFile, NoNumberMayBeNegative) {
  const TemporaryFolder folder;
  const auto complaint = [&](double total_support, double sigma) -> std::string {
    CurveSketch sketch = SmallSketch();
    sketch.curves[2].total_support = total_support;
    sketch.curves[2].depth_sigma[0] = sigma;
    WriteCurveSketch(folder.Path("s.bin"), sketch, kMetadata, "id");
    try {
      ReadCurveSketch(folder.Path("s.bin"), SketchedCurves(), "id");
    } catch (const IoError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint(0, 0), "");
  for (const double bad : {-1.0, static_cast<double>(NAN)}) {
    EXPECT_TRUE(complaint(bad, 0).ends_with("total support is negative or no number"));
    EXPECT_TRUE(complaint(0, bad).ends_with("sigma is negative or no number"));
  }
}

// Files whose checksum is right but whose content is wrong.
TEST(StageFile, IdsOutOfRangeAreRefused) {
  const TemporaryFolder folder;
  const auto refuse_curves = [&](const std::function<void(ImageCurves*)>& spoil) {
    ImageCurves curves = SmallImageCurves();
    spoil(&curves);
    WriteImageCurves(folder.Path("c.bin"), curves, "id");
    EXPECT_THROW(ReadImageCurves(folder.Path("c.bin"), "id"), IoError);
  };
  refuse_curves([](ImageCurves* curves) { curves->fragments[0].edgel_ids[1] = 10; });
  refuse_curves([](ImageCurves* curves) { curves->fragments[0].edgel_ids[1] = -1; });
  refuse_curves([](ImageCurves* curves) { curves->num_unlinked = -1; });
  refuse_curves([](ImageCurves* curves) { curves->edge_map.width = -1; });
  refuse_curves([](ImageCurves* curves) { curves->edge_map.texture = {4, 10}; });
  refuse_curves([](ImageCurves* curves) { curves->edge_map.texture = {4, 4}; });
  refuse_curves([](ImageCurves* curves) { curves->edge_map.edgels[3].position_px.x() = NAN; });
  refuse_curves([](ImageCurves* curves) { curves->edge_map.edgels[3].position_px.x() = 642; });
  const auto refuse_sketch = [&](const std::function<void(Curve3D*)>& spoil) {
    CurveSketch sketch = SmallSketch();
    spoil(&sketch.curves[2]);
    WriteCurveSketch(folder.Path("s.bin"), sketch, kMetadata, "id");
    EXPECT_THROW(ReadCurveSketch(folder.Path("s.bin"), SketchedCurves(), "id"), IoError);
  };
  refuse_sketch([](Curve3D* curve) { curve->anchor.view = 2; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.view = -1; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.fragment = 1; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.fragment = -1; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.begin = 13; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.begin = -1; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.begin = 4; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.step = 0; });
  refuse_sketch([](Curve3D* curve) { curve->anchor.step = 1000; });
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[1].view = 2; });
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[1].edgel = 13; });
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[0].edgel = 4; });
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[0].edgel = -5; });
  refuse_sketch([](Curve3D* curve) { curve->points_in_world[0].y() = INFINITY; });
  refuse_sketch([](Curve3D* curve) { curve->depth_sigma[0] = NAN; });
  refuse_sketch([](Curve3D* curve) { curve->total_support = NAN; });
  CurveSketch uneven = SmallSketch();
  uneven.curves[1].certain.pop_back();
  EXPECT_THROW(WriteCurveSketch(folder.Path("s.bin"), uneven, kMetadata, "id"), InputError);
}

// Files whose checksum is right but whose content is wrong.
TEST(ViewSketchFile, DepthsOfOtherFragmentsAreRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("v.bin");
  const auto refuse = [&](const std::function<void(ViewDepths*)>& spoil) {
    ViewDepths depths = SmallDepths();
    spoil(&depths);
    WriteViewSketch(path, depths, {}, {0, 1, 2}, RowsOfEdgels(), "id");
    EXPECT_THROW(ReadViewSketch(path, 1, {0, 1, 2}, SketchedViews(), RowsOfEdgels(), "id"),
                 IoError);
  };
  refuse([](ViewDepths* depths) { depths->spacing_px = 0; });
  refuse([](ViewDepths* depths) { depths->sample_step = 0; });
  refuse([](ViewDepths* depths) { depths->of_fragment.pop_back(); });
  refuse([](ViewDepths* depths) { depths->of_fragment[0].depths.pop_back(); });
  refuse([](ViewDepths* depths) { depths->of_fragment[1] = depths->of_fragment[0]; });
  refuse([](ViewDepths* depths) { depths->of_fragment[0].depths[3].inverse_depth = NAN; });
  refuse([](ViewDepths* depths) { depths->of_fragment[0].depths[3].inverse_depth = 0; });
  refuse([](ViewDepths* depths) { depths->of_fragment[0].depths[3].weight = -1; });
  refuse([](ViewDepths* depths) { depths->of_fragment[0].fates[6] = EdgelFate(31); });
}

TEST(ViewSketchFile, SupportByOthersIsRefused) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("v.bin");
  std::vector<Curve3D> curves = SmallCurves(SmallDepths());
  const auto write = [&] {
    WriteViewSketch(path, SmallDepths(), curves, {0, 1, 2}, RowsOfEdgels(), "id");
  };
  write();
  // Of a view with fewer edgels.
  std::vector<ImageCurves> fewer = RowsOfEdgels();
  fewer[0].fragments[1].edgel_ids.clear();
  fewer[0].fragments[0].edgel_ids.resize(5);
  EXPECT_THROW(ReadViewSketch(path, 1, {0, 1, 2}, SketchedViews(), fewer, "id"), IoError);
  EXPECT_THROW(ReadViewSketch(path, 1, {0, 1}, SketchedViews(), RowsOfEdgels(), "id"), IoError);
  curves[0].support.edgels[1] = {5, 0};
  EXPECT_THROW(write(), InputError);
  curves[0].support.edgels[1] = {0, 50};
  EXPECT_THROW(write(), InputError);
}

}  // namespace
}  // namespace limn
