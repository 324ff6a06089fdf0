// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// A camera of a model with distortion of the size found in practice, 800 x 600 pixels, focal length
// about 500.
Camera MakeCamera(CameraModelId model, uint32_t id);

// Two PINHOLE cameras (800 x 600, principal point at the center), three images in an order that is
// neither that of their ids nor of their names ("c.png", "sub/a b.png", "b.png"), one of them
// without 2D points, and two points with tracks.
SparseModel MakeModel();

// Exactly equal except for rotations, which may differ by a few rounding errors. Reports
// differences as test failures.
void ExpectSameModel(const SparseModel& actual, const SparseModel& expected);

// Runs the `colmap` program with its output in a log file; true on exit code 0.
bool HaveColmap();
bool RunColmap(const std::string& arguments, const std::filesystem::path& log);

}  // namespace limn::colmap_ext
