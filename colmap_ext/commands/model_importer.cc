#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/import/model_import.h"
#include "colmap_ext/import/new_model_folder.h"
#include "colmap_ext/run/interrupt.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {

int RunModelImporter(int argc, const char* const* argv) {
  ImporterOptions options;
  OptionParser parser("model_importer", "make a COLMAP model from cameras in another format");
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.Check();
  const InterruptWatch interrupts;
  CheckNewModelFolder(options.output_path);
  const SparseModel model = ImportModel(options, std::cout);
  for (const std::string& warning : model.warnings)
    std::cout << "WARNING: " << Printable(warning) << "\n";
  WriteNewModel(model, options.output_path, options.output_type);
  std::cout << "Written: " << Printable(options.output_path) << " with " << model.cameras.size()
            << " cameras, " << model.images.size() << " images, " << model.points.size()
            << " points\n";
  return 0;
}

}  // namespace limn::colmap_ext
