#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/verbs/extract_truth.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/files/atomic_file.h"
#include "limn/formats/ply_curves_writer.h"

namespace limn::colmap_ext {

int RunTruthExtractor(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  RunOptions options;
  ExtractorOptions extractor;
  if (!ParseRunOptions(
          "truth_extractor",
          "ground truth from a surface or a dense cloud: what the images show of it",
          {.linking = true, .overwrites = true, .output_help = "file of the truth, .ply"}, argc,
          argv, &options, [&](OptionParser* more) { extractor.AddOptions(more); })) {
    return 0;
  }
  extractor.Check();
  const std::string output_path = TakeTruthPath(&options.layout);
  CheckNamedOutput(output_path, {extractor.mesh_path, extractor.cloud_path}, options.overwrite);
  const auto console = make_console(options.num_threads, /*speaks=*/true);
  const TruthSource source = ReadTruthSource(extractor, console.get());
  const Project project(options, console.get());
  const ExtractedTruth truth =
      ExtractProjectTruth(project, options, source, extractor.truth, console.get());
  WriteFileAtomically(output_path, [&](std::ostream& out) { WriteCurvesPly(truth.set, out); });
  console->Say("wrote " + output_path);
  return 0;
}

}  // namespace limn::colmap_ext
