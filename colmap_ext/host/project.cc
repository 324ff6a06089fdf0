// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/project.h"

#include <utility>

namespace limn::colmap_ext {
namespace {

// Everything that can be checked before the images are read.
WorkspaceLayout ChooseLayoutInMemory(const SparseModel& model, const RunOptions& options,
                                     Console* console) {
  WorkspaceLayout layout = LayoutInMemory(options.layout, model.images.size());
  console->Say(layout.description);
  return layout;
}

}  // namespace

WorkspaceLayout ChooseLayout(const LayoutOptions& options, Console* console) {
  WorkspaceLayout layout = ResolveLayout(options);
  console->Say(layout.description);
  if (!layout.note.empty()) console->Say(layout.note);
  return layout;
}

Project::Project(const RunOptions& options, Console* console)
    : Project(ChooseLayout(options.layout, console), options, console) {}

// Braces evaluate from left to right.
Project::Project(SparseModel model, const RunOptions& options, Console* console)
    : Project{ChooseLayoutInMemory(model, options, console), std::move(model), options, console} {}

Project::Project(const WorkspaceLayout& layout, const RunOptions& options, Console* console)
    : OutputFolder(layout.output, options, console), Scene(layout, options, console) {}

Project::Project(const WorkspaceLayout& layout, SparseModel model, const RunOptions& options,
                 Console* console)
    : OutputFolder(layout.output, options, console),
      Scene(model, layout.image_dir, {}, options, console),
      given_model_(std::move(model)) {}

SparseModel Project::ReadModel() const {
  return given_model_ ? *given_model_ : ReadModelOf(layout());
}

}  // namespace limn::colmap_ext
