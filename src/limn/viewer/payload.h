// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "limn/viewer/viewer_scene.h"

namespace limn {

constexpr const char* kPageFormat = "limn-viewer";
constexpr int kPageVersion = 1;

// A scene as the bytes that page/src/payload.js decodes:
//   u32 size of the header | header (JSON, padded with spaces to 8 bytes) | arrays, each at a
//   multiple of 8 bytes
// The header names the arrays: {"arrays": {name: {"type": "f32"|"f64"|"u32"|"i32"|"u8", "offset",
// "length"}}}, offsets counted from the end of the header. Numbers of several bytes are stored in
// planes, the first bytes of all numbers, then the second bytes, ..., which compresses better.
// Positions are relative to the header's "center", so that 32 bits are enough even far from the
// origin; "shownFromModel" is ViewerScene::shown_from_model: {"scale", "rotation": nine numbers,
// row by row, "translation"}, before the center is subtracted; "drawing" is ViewerScene::drawing:
// {"name", "fingerprint"}.
//
// Throws InputError if the scene is inconsistent: thumbnails or supporting views without views, a
// report that is not an object; IoError if the report is no JSON.
std::string EncodePayload(const ViewerScene& scene);

}  // namespace limn
