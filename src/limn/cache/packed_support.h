// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "limn/cache/packed_numbers.h"
#include "limn/model/curve3d.h"
#include "limn/util/byte_stream.h"

namespace limn {

// The edgels of fragments as they follow each other: fragment by fragment, along each.
std::vector<EdgelId> EdgelsAlongFragments(const ImageCurves& curves);

// Writes and reads the support of curves, except their own edgels. Successive samples are supported
// by successive edgels of a fragment, which takes a byte or less each. `views` are the ids of the
// views, ascending, as the file counts them; those of others than the writer's are -1 where a view
// is gone: its edgels are left out. `curves` are the image curves by id.
void PutPackedSupport(const std::vector<Curve3D>& sketched, const std::vector<ViewId>& views,
                      const std::vector<ImageCurves>& curves, ByteWriter* out);
// Of curves that have no support yet.
void GetPackedSupport(const std::vector<ViewId>& views, const std::vector<ImageCurves>& curves,
                      ByteReader* in, std::vector<Curve3D>* sketched);

}  // namespace limn
