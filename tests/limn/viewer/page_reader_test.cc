// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/page_reader.h"

#include <cstring>
#include <functional>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "colmap_ext/temp_dir.h"
#include "limn/formats/small_drawing.h"
#include "limn/util/errors.h"
#include "limn/viewer/packing.h"
#include "limn/viewer/payload.h"
#include "limn/viewer/viewer_page.h"

namespace limn {
namespace {

using ::testing::HasSubstr;

ViewerScene SceneToStore() {
  ViewerScene scene;
  scene.graph = SmallDrawing();
  scene.views.resize(3);
  for (size_t v = 0; v < scene.views.size(); ++v) {
    scene.views[v].name = "view " + std::to_string(v);
    scene.views[v].camera = {500.25, 501, 319.5, 239.5, 640, 480};
    scene.views[v].region.max_px = {639, 479};
  }
  scene.thumbnails.resize(3);
  scene.thumbnails[0] = {{-0.5, -0.5}, {639.5, 479.5}, "first"};
  scene.thumbnails[2] = {{1, 2}, {3, 4}, std::string("third\0picture", 13)};
  scene.drawing = {"drawing.json", "0123456789abcdef"};
  scene.detail = Detail::kAll;
  scene.report_json = R"({"warnings": ["one"]})";
  scene.settings_json = R"({"thumbnail_size": 640})";
  scene.shown_from_model.scale = 2;
  scene.shown_from_model.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  scene.shown_from_model.translation = {10, 20, 30};
  for (const Eigen::Vector3d& in_model : {Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(-1, 0, 0.5)}) {
    scene.cloud.push_back({scene.shown_from_model * in_model, {7, 8, 255}});
  }
  return scene;
}

class StoredPages : public ::testing::Test {
 protected:
  std::string PathOf(const std::string& text) const { return dir_.WriteFile("drawing.html", text); }

  // A page as this and earlier versions write it.
  static std::string PageOf(const std::string& payload) {
    return "<!doctype html><script type=\"application/octet-stream\" id=\"payload\">\n      " +
           Base64(Gzip(payload)) + "\n    </script></html>";
  }

  // With another header.
  static std::string PageWith(const std::function<void(nlohmann::ordered_json*)>& change) {
    const std::string payload = EncodePayload(SceneToStore());
    uint32_t size = 0;
    std::memcpy(&size, payload.data(), sizeof(size));
    auto header = nlohmann::ordered_json::parse(payload.substr(sizeof(size), size));
    change(&header);
    const std::string text = header.dump();
    const auto new_size = static_cast<uint32_t>(text.size());
    const std::string begin(reinterpret_cast<const char*>(&new_size), sizeof(new_size));
    return PageOf(begin + text + payload.substr(sizeof(size) + size));
  }

  std::string ComplaintOf(const std::string& text) const {
    const std::string path = PathOf(text);
    try {
      ReadViewerPage(path);
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path));
      return error.what();
    }
    return "";
  }

 private:
  TempDir dir_;
};

void ExpectStoredScene(const StoredPage& page) {
  const ViewerScene scene = SceneToStore();
  EXPECT_EQ(page.detail, Detail::kAll);
  EXPECT_EQ(page.drawing.name, "drawing.json");
  EXPECT_EQ(page.drawing.fingerprint, "0123456789abcdef");
  EXPECT_EQ(nlohmann::json::parse(page.report_json), nlohmann::json::parse(scene.report_json));
  EXPECT_EQ(nlohmann::json::parse(page.settings_json), nlohmann::json::parse(scene.settings_json));
  ASSERT_EQ(page.photos.size(), 2u);
  EXPECT_EQ(page.photos[1].name, "view 2");
  EXPECT_EQ(page.photos[1].camera.fx, 500.25);
  EXPECT_EQ(page.photos[1].camera.height, 480);
  EXPECT_EQ(page.photos[1].region.max_px, Eigen::Vector2d(639, 479));
  EXPECT_EQ(page.photos[1].thumbnail.min_px, Eigen::Vector2d(1, 2));
  EXPECT_EQ(page.photos[1].thumbnail.max_px, Eigen::Vector2d(3, 4));
  EXPECT_EQ(page.photos[0].thumbnail.jpeg, "first");
  EXPECT_EQ(page.photos[1].thumbnail.jpeg, scene.thumbnails[2].jpeg);
  ASSERT_EQ(page.cloud.size(), 2u);
  EXPECT_LT((page.cloud[0].position - Eigen::Vector3d(1, 2, 3)).norm(), 1e-3);
  EXPECT_LT((page.cloud[1].position - Eigen::Vector3d(-1, 0, 0.5)).norm(), 1e-3);
  EXPECT_EQ(page.cloud[0].color, (std::array<uint8_t, 3>{7, 8, 255}));
}

TEST_F(StoredPages, AreReadBack) {
  ExpectStoredScene(ReadViewerPage(PathOf(PageOf(EncodePayload(SceneToStore())))));
  if (!HasViewerPage()) return;
  std::ostringstream page;
  WriteViewerPage(SceneToStore(), page);
  ExpectStoredScene(ReadViewerPage(PathOf(page.str())));
}

TEST_F(StoredPages, OfEarlierVersionsHaveNoSettings) {
  const StoredPage page = ReadViewerPage(PathOf(PageWith([](nlohmann::ordered_json* header) {
    header->erase("settings");
    header->erase("drawing");
    header->at("report") = nullptr;
  })));
  EXPECT_EQ(page.settings_json, "");
  EXPECT_EQ(page.drawing.fingerprint, "");
  EXPECT_EQ(page.report_json, "");
  EXPECT_EQ(page.photos.size(), 2u);
}

TEST_F(StoredPages, OthersAndDamagedOnesAreRefused) {
  const std::string whole = PageOf(EncodePayload(SceneToStore()));
  EXPECT_THAT(ComplaintOf(""), HasSubstr("is not a page of limn"));
  EXPECT_THAT(ComplaintOf("<!doctype html><title>Limn</title>"), HasSubstr("is not a page"));
  EXPECT_THAT(ComplaintOf(whole.substr(0, whole.size() / 2)), HasSubstr("cut off"));
  std::string damaged = whole;
  damaged[damaged.size() / 2] = '*';
  EXPECT_THAT(ComplaintOf(damaged), HasSubstr("no base64"));
  damaged[damaged.size() / 2] = 'A';
  damaged[damaged.size() / 2 + 1] = 'A';
  EXPECT_THAT(ComplaintOf(damaged), HasSubstr("damaged"));
  EXPECT_THAT(ComplaintOf(PageOf("abc")), HasSubstr("cut off"));
  EXPECT_THAT(ComplaintOf(PageOf(std::string("\xff\xff\xff\xff{}"))), HasSubstr("header"));
  EXPECT_THAT(ComplaintOf(PageOf(std::string("\2\0\0\0{}", 6))), HasSubstr("format"));
}

TEST_F(StoredPages, WhatIsNotInTheFileIsRefused) {
  using Json = nlohmann::ordered_json;
  const auto complaint = [&](const std::string& pointer, const Json& value) {
    return ComplaintOf(
        PageWith([&](Json* header) { header->at(Json::json_pointer(pointer)) = value; }));
  };
  EXPECT_THAT(complaint("/version", 2), HasSubstr("another version"));
  EXPECT_THAT(complaint("/arrays/cloudPositions/offset", -8), HasSubstr("not in the file"));
  EXPECT_THAT(complaint("/arrays/cloudPositions/offset", 1 << 30), HasSubstr("not in the file"));
  EXPECT_THAT(complaint("/arrays/cloudPositions/length", 1 << 30), HasSubstr("not in the file"));
  EXPECT_THAT(complaint("/arrays/cloudPositions/length", 5), HasSubstr("differ in number"));
  EXPECT_THAT(complaint("/arrays/thumbnails/type", "f32"), HasSubstr("type"));
  EXPECT_THAT(complaint("/views/0/thumbnail/length", 1 << 30), HasSubstr("not in the file"));
  EXPECT_THAT(complaint("/views/0/thumbnail/offset", -1), HasSubstr("not in the file"));
  // All pictures, of which another view has one.
  EXPECT_THAT(complaint("/views/0/thumbnail/length", 18), HasSubstr("in the bytes of others"));
  EXPECT_THAT(complaint("/shownFromModel/scale", 0), HasSubstr("scale"));
  EXPECT_THAT(complaint("/shownFromModel/rotation", Json::array({1})), HasSubstr("rotation"));
  EXPECT_THAT(complaint("/report", 7), HasSubstr("report"));
  EXPECT_THAT(complaint("/detail", "some"), HasSubstr("detail"));
}

TEST_F(StoredPages, ABombIsRefused) {
  const std::string zeros(size_t{1} << 25, '\0');
  EXPECT_THAT(ComplaintOf(PageOf(zeros)), HasSubstr("unpacks to more than"));
}

TEST(ViewerPacking, GunzipAndUnbase64AreTheWayBack) {
  std::string bytes;
  for (int i = 0; i < 1000000; ++i) bytes += static_cast<char>(int64_t{i} * i >> 7);
  for (const std::string& original : {std::string(), std::string("a"), bytes}) {
    EXPECT_EQ(Gunzip(Gzip(original), 1000000), original);
    EXPECT_EQ(Unbase64(Base64(original)), original);
  }
  EXPECT_EQ(Unbase64(Base64("ab")), "ab");
  EXPECT_THROW(Gunzip(Gzip(bytes), 999999), InputError);
  EXPECT_THROW(Gunzip(Gzip(bytes).substr(0, 1000), 1000000), InputError);
  EXPECT_THROW(Gunzip("no gzip", 100), InputError);
  for (const char* bad : {"Zm9", "Zm9v!A==", "Zm 9", "====", "Z==="}) {
    EXPECT_THROW(Unbase64(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace limn
