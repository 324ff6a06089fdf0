// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/model/model.h"

namespace colmap {
class Reconstruction;
}

namespace limn::colmap_ext {

// The registered images, cameras and points of a reconstruction, sorted by their ids: what
// ReadColmapModel reads from its files, bit for bit except for the order. (A rotation that COLMAP
// up to 3.10 has neither read nor normalized itself may differ in its last bits.) Throws IoError as
// ReadColmapModel does for a model that cannot be used: with "reconstruction" and the id in place
// of file and line.
SparseModel ToSparseModel(const colmap::Reconstruction& reconstruction);

// Adds to the reconstruction the points of the model from index `first` on, with color, error and
// track, and the 2D points that their tracks refer to: those of `model` that an image of the
// reconstruction lacks. Precondition: `model` is ToSparseModel(*reconstruction) with observations
// and points appended (AddCurvePoints), and the reconstruction has been torn down: no mapper is
// using it.
void AppendPoints(const SparseModel& model, size_t first, colmap::Reconstruction* reconstruction);

}  // namespace limn::colmap_ext
