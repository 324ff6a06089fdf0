// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// What a list of images names.
struct ListedImages {
  std::set<std::string> names;  // of images of the model
  std::string unknown;          // the first line that names none of them; empty: all do
};

// Reads a text file with the name of an image per line. A line names the image of that name; else,
// as lists made by other programs have it, the image whose name is the end of the line (paths such
// as images/a.jpg and C:\photos\a.jpg), or of whose name it is the end if there is only one such
// image, in any encoding (NameEncodings). Throws IoError.
ListedImages ReadListedImages(const std::string& path, const SparseModel& model);

}  // namespace limn::colmap_ext
