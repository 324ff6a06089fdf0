// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/output_folder.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/host/scene.h"
#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// A COLMAP project: what is read from it, and the locked folder that results are written to.
class Project : public OutputFolder, public Scene {
 public:
  // Finds the folders, reports them, locks the output and reads the scene. Throws what
  // OutputFolder, Scene and ResolveLayout throw.
  Project(const RunOptions& options, Console* console);
  // The same with a model in memory, for which only image_path and output_path of the layout count.
  Project(SparseModel model, const RunOptions& options, Console* console);

  // The model in its own coordinates, read again, since keeping it would cost memory. Throws
  // IoError.
  SparseModel ReadModel() const;

 private:
  Project(const WorkspaceLayout& layout, const RunOptions& options, Console* console);
  Project(const WorkspaceLayout& layout, SparseModel model, const RunOptions& options,
          Console* console);

  std::optional<SparseModel> given_model_;
};

// ResolveLayout, and reports what was chosen.
WorkspaceLayout ChooseLayout(const LayoutOptions& options, Console* console);

}  // namespace limn::colmap_ext
