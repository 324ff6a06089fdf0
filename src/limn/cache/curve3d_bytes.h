// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/model/curve3d.h"
#include "limn/util/byte_stream.h"

namespace limn {

// A curve with its support in a stage file:
//   i32 anchor view, fragment, begin | u8 closed | f64 total support | u64 samples, each: f64[3]
//   point | f64[3] tangent | f64 depth sigma | u8 certain | u32 supporting edgels, each: i32 view |
//   i32 edgel
// The smallest size of a curve in bytes.
constexpr size_t kCurve3dBytes = 3 * sizeof(int32_t) + 1 + sizeof(double) + sizeof(uint64_t);

// Throws InputError if the curve's lists differ in length.
void PutCurve3d(const Curve3D& curve, ByteWriter* out);

// `curves` are the image curves of all views. Everything read is checked (anchor and edgels among
// them, numbers finite except unknown sigmas); throws IoError.
Curve3D GetCurve3d(ByteReader* in, const std::vector<ImageCurves>& curves);

}  // namespace limn
