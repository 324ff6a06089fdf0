// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/edge_results.h"

#include "colmap_ext/workspace/file_set.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/edges/given_edgels.h"
#include "limn/files/atomic_file.h"
#include "limn/formats/cem_file.h"
#include "limn/formats/edg_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

const char* FolderOf(EdgeFormat format) {
  return format == EdgeFormat::kEdg ? "edges" : "fragments";
}

OutputPath PathOf(const Project& project, EdgeFormat format, const std::string& image_name) {
  const char* extension = format == EdgeFormat::kEdg ? ".edg" : ".cem";
  return project.CurvesPath(FolderOf(format)) / (image_name + extension);
}

// An image that was used as if enlarged has the edges of its pixels.
void ShrinkToImage(const Project& project, ViewId view, EdgeMap* edge_map) {
  const double scale = project.views()[view].scale;
  if (scale == 1) return;
  const ImageSize image = project.view_set().ReadSize(view);
  ResizeEdgeMap(image.width, image.height, edge_map);
  for (Edgel& edgel : edge_map->edgels) edgel.strength *= static_cast<float>(scale);
}

}  // namespace

void CheckEdgeResults(const Project& project, EdgeFormat format, bool overwrite) {
  if (format == EdgeFormat::kNone) return;
  const FileSet inputs(project.edge_files());
  for (const View& view : project.views()) {
    const OutputPath path = PathOf(project, format, view.name);
    CheckResultFile(path, overwrite);
    if (inputs.Contains(path.string())) {
      throw IoError(path.string(), "would be replaced, but is an input (edges_path)");
    }
  }
}

void WriteEdgResult(const Project& project, ViewId view, EdgeMap edge_map) {
  ShrinkToImage(project, view, &edge_map);
  WriteFileAtomically(PathOf(project, EdgeFormat::kEdg, project.views()[view].name),
                      [&](std::ostream& out) { WriteEdg(edge_map, out); });
}

FragmentsObserver CemWriter(const Project& project) {
  return [&project](ViewId view, ImageCurves curves) {
    ShrinkToImage(project, view, &curves.edge_map);
    WriteFileAtomically(PathOf(project, EdgeFormat::kCem, project.views()[view].name),
                        [&](std::ostream& out) { WriteCem(curves, out); });
  };
}

void SayEdgeResults(const Project& project, EdgeFormat format, Console* console) {
  if (format == EdgeFormat::kNone) return;
  console->Say("Written: " + project.CurvesPath(FolderOf(format)).string());
}

}  // namespace limn::colmap_ext
