// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/extract_truth.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "colmap_ext/host/job.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/files/atomic_file.h"
#include "limn/files/whole_file.h"
#include "limn/formats/mesh_reader.h"
#include "limn/formats/ply_curves_writer.h"
#include "limn/formats/read_curves.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

void SayAccount(const TruthAccount& account, int min_views, bool is_cloud, Console* console) {
  char line[240];
  std::snprintf(line, sizeof(line),
                is_cloud
                    ? "points: %.0f found, %.0f visible in %d or more images, %.0f shown by that "
                      "many, %.0f written"
                    : "length of curves in units of the model: %.6g found, %.6g visible in %d "
                      "or more images, %.6g shown by that many, %.6g written",
                account.found, account.visible, min_views, account.shown, account.kept);
  console->Say(line);
}

// Takes the file that is to be written. Throws OptionError.
std::string TakeTruthPath(LayoutOptions* layout) {
  std::string path = std::move(layout->output_path);
  if (path.empty()) throw OptionError("--output_path must be given");
  if (FileExtension(path) != ".ply" || path.ends_with(".gz")) {
    throw OptionError("output_path = " + path + ": must be a file .ply");
  }
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  layout->output_path = folder.empty() ? "." : folder.string();
  return path;
}

TruthSource ReadTruthSource(const std::string& mesh_path, const std::string& cloud_path,
                            const SharpEdgeOptions& sharp_edges, Console* console) {
  TruthSource source;
  if (!cloud_path.empty()) {
    CurveSet set = ReadCurves(cloud_path);
    if (set.points.empty()) throw IoError(cloud_path, "has no points");
    source.cloud = std::move(set.points);
    return source;
  }
  source.mesh = ReadMesh(mesh_path);
  const TriangleMesh& mesh = source.mesh;
  console->Say(mesh_path + ": " + std::to_string(mesh.polygons.size()) + " faces, " +
               std::to_string(mesh.vertices.size()) + " vertices");
  if (mesh.num_degenerate > 0 || mesh.num_copies > 0) {
    console->Say("WARNING: left out " + std::to_string(mesh.num_degenerate) +
                 " faces without area and " + std::to_string(mesh.num_copies) + " copies of faces");
  }
  source.edges = FindSharpEdges(mesh, sharp_edges);
  if (source.edges.empty()) {
    throw IoError(mesh_path, "has no edge as sharp as min_dihedral_deg and no border");
  }
  return source;
}

}  // namespace

void ExtractTruthVerb::AddOptions(OptionParser* parser) {
  parser->AddOption("mesh_path", &mesh_path_,
                    BasicOption("surface, .ply or .obj: its sharp edges"));
  parser->AddOption("cloud_path", &cloud_path_,
                    BasicOption("or a dense cloud, .ply or .txt: its points near image edges"));
  parser->AddOption("min_dihedral_deg", &sharp_edges_.min_dihedral_deg,
                    BasicOption("smallest angle by which the surface bends at a sharp edge"));
  parser->AddOption("min_corner_deg", &sharp_edges_.min_corner_deg,
                    "curves end where they turn by more");
  parser->AddOption("min_views", &truth_.min_views,
                    BasicOption("number of views that must show what is kept"));
  parser->AddOption("require_edges", &truth_.require_edges,
                    BasicOption("a view shows what has edgels along it; 0 = whatever is visible"));
  parser->AddOption("max_distance_px", &truth_.max_distance_px, "farthest edgel, px");
  parser->AddOption("max_angle_deg", &truth_.max_angle_deg,
                    "largest difference in direction of an edgel");
  parser->AddOption("occlusion_px", &truth_.occlusion_px,
                    "visible points may be this far behind the surface, pixel footprints");
  parser->AddOption("max_gap_px", &truth_.max_gap_px, "shorter gaps of curves are closed, px");
  parser->AddOption("min_length_px", &truth_.min_length_px, "shorter runs are dropped, px");
  parser->AddOption("splat_px", &truth_.splat_px,
                    "a point of the cloud hides a disc of this radius, px");
  parser->AddOption("max_chance", &truth_.max_chance,
                    "largest probability that the edgels near a point of the cloud are accidental");
}

void ExtractTruthVerb::Prepare(RunOptions* options, Console* console) {
  if (mesh_path_.empty() == cloud_path_.empty()) {
    throw OptionError("one of --mesh_path and --cloud_path must be given, and not both");
  }
  sharp_edges_.Check();
  truth_.Check();
  options->view.max_scale = 1;  // its lengths are in pixels of the images
  output_path_ = TakeTruthPath(&options->layout);
  CheckNamedOutput(output_path_, {mesh_path_, cloud_path_}, options->overwrite);
  source_ = ReadTruthSource(mesh_path_, cloud_path_, sharp_edges_, console);
}

void ExtractTruthVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  const Job job = JobOf(project, options, console);
  CurvesResult image_curves;
  if (truth_.require_edges) image_curves = ExtractImageCurves(job);
  const bool is_cloud = !source_.cloud.empty();
  const ExtractedTruth truth = is_cloud
                                   ? ExtractTruthPoints(source_.cloud, job.views(),
                                                        image_curves.curves, truth_, job.context())
                                   : ExtractTruthCurves(source_.edges, source_.mesh, job.views(),
                                                        image_curves.curves, truth_, job.context());
  SayAccount(truth.account, truth_.min_views, is_cloud, console);
  if (!(truth.account.kept > 0)) throw InputError("nothing of the truth is shown by the images");
  WriteFileAtomically(output_path_, [&](std::ostream& out) { WriteCurvesPly(truth.set, out); });
  console->Say("wrote " + output_path_);
}

}  // namespace limn::colmap_ext
