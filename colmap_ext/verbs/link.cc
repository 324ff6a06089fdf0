// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/link.h"

#include "colmap_ext/host/job.h"

namespace limn::colmap_ext {

void LinkVerb::AddFileOptions(OptionParser* parser) {
  parser->AddOption("format", &format_, {{"none", EdgeFormat::kNone}, {"cem", EdgeFormat::kCem}},
                    BasicOption("also write fragments as curves/fragments/<image name>.cem"));
}

void LinkVerb::Run(const Project& project, const RunOptions& options, Console* console) {
  CheckEdgeResults(project, format_, options.overwrite);
  ExtractImageCurves(JobOf(project, options, console),
                     format_ == EdgeFormat::kCem ? CemWriter(project) : FragmentsObserver());
  SayEdgeResults(project, format_, console);
}

}  // namespace limn::colmap_ext
