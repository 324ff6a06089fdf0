// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "colmap_ext/import/import_input.h"
#include "fuzz/fuzz_target.h"

namespace limn::fuzz {

// An importer of colmap_ext/import.
using ReadScene = colmap_ext::ImportedScene (*)(const colmap_ext::ImportInput&);

// Reads the cameras at `path` for the images a.png and b.png, of 40 x 30 pixels, with every list of
// images naming these two, and makes a model of them. Other images are left out.
int FuzzImport(const std::string& path, ReadScene read);

// A file of cameras of its own.
int FuzzImportFile(const uint8_t* data, size_t size, ReadScene read);

}  // namespace limn::fuzz
