// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/model/model.h"
#include "colmap_ext/workspace/photo_store.h"
#include "colmap_ext/workspace/view_set.h"
#include "limn/util/parallel.h"

namespace limn::colmap_ext {

// Finds out how the pixels of files become the photographs of a model (ViewFile::form and, where
// they are turned, stored_size, which is as stored before the call), and tells the user in `notes`.
// `images` are the indices of the files into model.images.
//
// Orientation: COLMAP and others leave pictures as they are stored, others again turn them as EXIF
// says. Files whose sides fit their camera in only one of these ways decide: if some fit only when
// they are turned, they are, and so are all others with an orientation unless some fit only as
// stored. Levels: files of 16 bits of one size that use less than half of the range are stretched
// (RangeToShow), by the values of up to twelve of them. Alpha: a mask, if it hides something.
//
// Reads the headers of all files, and decodes those with alpha and of more than 8 bits. Throws
// IoError.
void SetForms(const SparseModel& model, const std::vector<int>& images, const PhotoStore& photos,
              const RunContext& context, std::vector<ViewFile>* files,
              std::vector<std::string>* notes);

}  // namespace limn::colmap_ext
