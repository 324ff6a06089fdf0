// SPDX-License-Identifier: BSD-3-Clause
#include "limn/viewer/page_reader.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include <nlohmann/json.hpp>

#include "limn/files/json_text.h"
#include "limn/files/json_value.h"
#include "limn/files/whole_file.h"
#include "limn/formats/json_place.h"
#include "limn/util/errors.h"
#include "limn/viewer/packing.h"
#include "limn/viewer/payload.h"

namespace limn {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint64_t kMaxPageBytes = uint64_t{1} << 28;
constexpr size_t kMaxPayloadBytes = size_t{1} << 29;
// JPEG files do not pack, curves and headers at most so much.
constexpr size_t kMaxPacking = 100;
constexpr size_t kSmallPayloadBytes = size_t{1} << 24;
// Those of 50,000 views.
constexpr size_t kMaxHeaderValues = size_t{1} << 21;
constexpr size_t kMaxHeaderBytes = size_t{1} << 26;

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kSpaces = " \r\n\t";
  const size_t begin = std::min(text.find_first_not_of(kSpaces), text.size());
  return text.substr(begin, text.find_last_not_of(kSpaces) + 1 - begin);
}

// The text of the payload's element.
std::string_view PayloadOf(std::string_view page) {
  constexpr std::string_view kBegin = "id=\"payload\">", kEnd = "</script>";
  const size_t begin = page.find(kBegin);
  const bool is_page = page.starts_with("<!doctype html>") && begin != std::string_view::npos;
  if (!is_page) throw InputError("is not a page of limn");
  const std::string_view rest = page.substr(begin + kBegin.size());
  const size_t end = rest.find(kEnd);
  if (end == std::string_view::npos) throw InputError("is cut off");
  return Trimmed(rest.substr(0, end));
}

std::string UnpackedPayload(const std::string& path) {
  std::string packed;
  {
    const std::string page = ReadWholeFile(path, kMaxPageBytes);
    packed = Unbase64(PayloadOf(page));
  }
  const size_t most = std::max(kSmallPayloadBytes, kMaxPacking * packed.size());
  return Gunzip(packed, std::min(kMaxPayloadBytes, most));
}

// The arrays that a header names (payload.h).
class StoredArrays {
 public:
  StoredArrays(JsonValue entries, std::string_view data) : entries_(entries), data_(data) {}

  std::string_view Bytes(const char* name) const { return Find(name, "u8", 1); }

  std::vector<float> Floats(const char* name) const {
    const std::string_view bytes = Find(name, "f32", sizeof(float));
    std::vector<float> values(bytes.size() / sizeof(float));
    for (size_t i = 0; i < values.size(); ++i) {
      char raw[sizeof(float)];
      for (size_t plane = 0; plane < sizeof(float); ++plane) {
        raw[plane] = bytes[plane * values.size() + i];
      }
      std::memcpy(&values[i], raw, sizeof(float));
    }
    return values;
  }

 private:
  std::string_view Find(const char* name, std::string_view type, size_t width) const {
    const JsonValue entry = entries_.At(name);
    if (entry.At("type").Text() != type) entry.At("type").Fail("another type expected");
    const int offset = entry.At("offset").Integer(), length = entry.At("length").Integer();
    const bool is_within = offset >= 0 && length >= 0 &&
                           static_cast<size_t>(offset) <= data_.size() &&
                           static_cast<size_t>(length) <= (data_.size() - offset) / width;
    if (!is_within) entry.Fail("is not in the file");
    return data_.substr(offset, width * length);
  }

  JsonValue entries_;
  std::string_view data_;
};

Eigen::Vector2d PixelOf(const JsonValue& value) {
  Eigen::Vector2d pixel;
  value.Numbers(2, pixel.data());
  return pixel;
}

Similarity3d SimilarityOf(const JsonValue& value) {
  Similarity3d similarity;
  similarity.scale = value.At("scale").Number();
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows;
  value.At("rotation").Numbers(9, rows.data());
  similarity.rotation = rows;
  similarity.translation = PlaceOf(value.At("translation"));
  if (!(similarity.scale > 0)) value.At("scale").Fail("a number above zero expected");
  return similarity;
}

PagePhoto PhotoOf(const JsonValue& view, const JsonValue& thumbnail, std::string_view pictures) {
  PagePhoto photo;
  photo.name = view.At("name").Text();
  photo.camera = {view.At("fx").Number(), view.At("fy").Number(),     view.At("cx").Number(),
                  view.At("cy").Number(), view.At("width").Integer(), view.At("height").Integer()};
  photo.region.min_px = PixelOf(view.At("region").At("min"));
  photo.region.max_px = PixelOf(view.At("region").At("max"));
  photo.thumbnail.min_px = PixelOf(thumbnail.At("min"));
  photo.thumbnail.max_px = PixelOf(thumbnail.At("max"));
  const int offset = thumbnail.At("offset").Integer(), length = thumbnail.At("length").Integer();
  const bool is_within = offset >= 0 && length >= 0 &&
                         static_cast<size_t>(offset) <= pictures.size() &&
                         static_cast<size_t>(length) <= pictures.size() - offset;
  if (!is_within) thumbnail.Fail("is not in the file");
  photo.thumbnail.jpeg = pictures.substr(offset, length);
  return photo;
}

// No two have the same bytes.
std::vector<PagePhoto> PhotosOf(const JsonValue& views, std::string_view pictures) {
  std::vector<PagePhoto> photos;
  size_t num_bytes = 0;
  for (const JsonValue& view : views.Items()) {
    const JsonValue thumbnail = view.At("thumbnail");
    if (thumbnail.IsNull()) continue;
    photos.push_back(PhotoOf(view, thumbnail, pictures));
    num_bytes += photos.back().thumbnail.jpeg.size();
    if (num_bytes > pictures.size()) thumbnail.Fail("is in the bytes of others");
  }
  return photos;
}

std::vector<ViewerPoint> CloudOf(const JsonValue& header, const StoredArrays& arrays) {
  const std::vector<float> positions = arrays.Floats("cloudPositions");
  const std::string_view colors = arrays.Bytes("cloudColors");
  if (positions.size() % 3 != 0 || colors.size() != positions.size()) {
    header.At("arrays").Fail("positions and colors of points differ in number");
  }
  const Eigen::Vector3d center = PlaceOf(header.At("center"));
  const Similarity3d model_from_shown = Inverse(SimilarityOf(header.At("shownFromModel")));
  std::vector<ViewerPoint> cloud(positions.size() / 3);
  for (size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f at(positions.data() + 3 * i);
    cloud[i].position = model_from_shown * (center + at.cast<double>());
    if (!cloud[i].position.allFinite()) header.At("arrays").Fail("points that are nowhere");
    for (int c = 0; c < 3; ++c) cloud[i].color[c] = static_cast<uint8_t>(colors[3 * i + c]);
  }
  return cloud;
}

std::string TextOf(const JsonValue& header, const char* name) {
  const auto object = header.Find(name);
  if (!object || object->IsNull()) return "";
  object->ExpectObject();
  return object->Json().dump();
}

StoredPage PageOf(const JsonValue& header, std::string_view data) {
  if (header.At("format").Text() != kPageFormat) header.At("format").Fail("is another format");
  if (header.At("version").Integer() != kPageVersion) {
    header.At("version").Fail("is of another version of limn");
  }
  const StoredArrays arrays(header.At("arrays"), data);
  StoredPage page;
  if (const auto drawing = header.Find("drawing")) {
    page.drawing = {drawing->At("name").Text(), drawing->At("fingerprint").Text()};
  }
  page.detail = DetailFromName(header.At("detail").Text());
  page.report_json = TextOf(header, "report");
  page.settings_json = TextOf(header, "settings");
  page.photos = PhotosOf(header.At("views"), arrays.Bytes("thumbnails"));
  page.cloud = CloudOf(header, arrays);
  return page;
}

StoredPage ParsePayload(const std::string& path, const std::string& payload) {
  uint32_t size = 0;
  if (payload.size() < sizeof(size)) throw InputError("is cut off");
  std::memcpy(&size, payload.data(), sizeof(size));
  const bool is_within = size <= kMaxHeaderBytes && size <= payload.size() - sizeof(size);
  if (!is_within) throw InputError("is damaged: its header is not in the file");
  const Json header = ParseJson(path, payload.substr(sizeof(size), size), kMaxHeaderValues);
  return PageOf(JsonValue(header), std::string_view(payload).substr(sizeof(size) + size));
}

}  // namespace

StoredPage ReadViewerPage(const std::string& path) {
  try {
    return ParsePayload(path, UnpackedPayload(path));
  } catch (const std::bad_alloc&) {
    throw IoError(path, "is too large for the memory");
  } catch (const OptionError& error) {
    throw IoError(path, error.what());
  } catch (const std::exception&) {
    RethrowJsonError(path);
  }
}

}  // namespace limn
