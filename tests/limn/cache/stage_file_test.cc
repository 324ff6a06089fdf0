#include "limn/cache/stage_file.h"

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
  curves.link_graph = {{0, 1, 3}, {0, 2, 1}, {8, 9, 2}};
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
    EXPECT_EQ(read->link_graph[i].a, written.link_graph[i].a);
    EXPECT_EQ(read->link_graph[i].b, written.link_graph[i].b);
    EXPECT_EQ(read->link_graph[i].votes, written.link_graph[i].votes);
  }
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
  const size_t saved = 10 * 6 * sizeof(float);
  EXPECT_EQ(std::filesystem::file_size(folder.Path("a.bin")) + saved,
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

// Of view 0.
ViewSketch SmallViewSketch() {
  const CurveSketch sketch = SmallSketch();
  ViewSketch of_view = {{sketch.curves[0], sketch.curves[2]}, {}};
  of_view.fates.assign(13, EdgelFate::kSketched);
  of_view.fates[1] = EdgelFate::kNoPartner;
  return of_view;
}

TEST(ViewSketchFile, RoundTrip) {
  const TemporaryFolder folder;
  const ViewSketch written = SmallViewSketch();
  WriteViewSketch(folder.Path("a.bin"), written, "x");
  const std::vector<ImageCurves> curves = SketchedCurves();
  const std::optional<ViewSketch> read =
      ReadViewSketch(folder.Path("a.bin"), 0, PointersTo(curves), "x");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->fates, written.fates);
  ASSERT_EQ(read->curves.size(), 2u);
  WriteViewSketch(folder.Path("b.bin"), *read, "x");
  EXPECT_EQ(TemporaryFolder::Read(folder.Path("a.bin")),
            TemporaryFolder::Read(folder.Path("b.bin")));
  EXPECT_FALSE(ReadViewSketch(folder.Path("a.bin"), 0, PointersTo(curves), "y"));
  EXPECT_THROW(ReadViewSketch(folder.Path("a.bin"), 1, PointersTo(curves), "x"), IoError);
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
  refuse_curves([](ImageCurves* curves) { curves->link_graph[0].b = 0; });
  refuse_curves(
      [](ImageCurves* curves) { std::swap(curves->link_graph[0], curves->link_graph[1]); });
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
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[1].view = 2; });
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[1].edgel = 13; });
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[0].edgel = 4; });
  refuse_sketch([](Curve3D* curve) { curve->support.edgels[0].edgel = -5; });
  refuse_sketch([](Curve3D* curve) { curve->points_in_world[0].y() = INFINITY; });
  refuse_sketch([](Curve3D* curve) { curve->depth_sigma[0] = NAN; });
  refuse_sketch([](Curve3D* curve) { curve->total_support = NAN; });
  const auto refuse_view = [&](const std::function<void(ViewSketch*)>& spoil) {
    ViewSketch sketch = SmallViewSketch();
    spoil(&sketch);
    WriteViewSketch(folder.Path("v.bin"), sketch, "id");
    const std::vector<ImageCurves> of_views = SketchedCurves();
    EXPECT_THROW(ReadViewSketch(folder.Path("v.bin"), 0, PointersTo(of_views), "id"), IoError);
  };
  refuse_view([](ViewSketch* sketch) { sketch->fates[3] = EdgelFate(kNumEdgelFates); });
  refuse_view([](ViewSketch* sketch) { sketch->fates.pop_back(); });
  refuse_view([](ViewSketch* sketch) { sketch->fates.push_back(EdgelFate::kDrawn); });
  refuse_view([](ViewSketch* sketch) { sketch->curves[1].anchor.view = 1; });
  CurveSketch uneven = SmallSketch();
  uneven.curves[1].certain.pop_back();
  EXPECT_THROW(WriteCurveSketch(folder.Path("s.bin"), uneven, kMetadata, "id"), InputError);
}

}  // namespace
}  // namespace limn
