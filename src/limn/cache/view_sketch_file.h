// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limn/files/output_path.h"
#include "limn/model/view.h"
#include "limn/sketch/view_sketch.h"

namespace limn {

// Stores the sketch of one view: the depths that its curves follow from, and their support (see
// stage_file.h for the container and `identity`). `depends_on` are the view and those that the
// sketch depends on, ascending: the file counts views by this list, so that other views may come
// and go. `curves` are the image curves of all views.
void WriteViewSketch(const OutputPath& path, const ViewDepths& depths,
                     const std::vector<Curve3D>& sketched, const std::vector<ViewId>& depends_on,
                     const std::vector<ImageCurves>& curves, const std::string& identity);

// Nothing if the file is stale: made from other input or by another version of Limn. An empty
// `identity` accepts any. `depends_on` are the present ids of the views that the writer listed, -1
// for those that are gone, but for `id`, which was sketched. Everything read is checked (depths for
// the view's fragments, ids in range, numbers finite); throws IoError.
std::optional<ViewSketch> ReadViewSketch(const std::string& path, ViewId id,
                                         const std::vector<ViewId>& depends_on,
                                         const std::vector<View>& views,
                                         const std::vector<ImageCurves>& curves,
                                         const std::string& identity);

}  // namespace limn
