// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colmap_ext/host/console.h"
#include "colmap_ext/import/model_import.h"

namespace limn::colmap_ext {

// model_importer: a COLMAP model of another program's cameras, in a new folder.
void RunImporter(const ImporterOptions& options, Console* console);

}  // namespace limn::colmap_ext
