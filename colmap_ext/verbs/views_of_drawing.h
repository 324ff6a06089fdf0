// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "colmap_ext/model/model.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/model/view.h"

namespace limn::colmap_ext {

// The graph of a drawing whose links are supported by `views`, those of the model, instead of the
// drawing's, which may be only some of them in another order. Images of the model that have no
// view, such as duplicates, support nothing. Throws IoError if the drawing has an image that the
// model has not.
DrawingGraph WithViewsOf(const SparseModel& model, const std::vector<View>& views,
                         DrawingFile drawing);

}  // namespace limn::colmap_ext
