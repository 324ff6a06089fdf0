#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/import/model_import.h"
#include "colmap_ext/import/new_model_folder.h"

namespace limn::colmap_ext {

int RunModelImporter(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  ImporterOptions options;
  OptionParser parser("model_importer", "make a COLMAP model from cameras in another format");
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.Check();
  const auto console = make_console(/*num_threads=*/-1, /*speaks=*/true);
  CheckNewModelFolder(options.output_path);
  std::vector<std::string> notes;
  const SparseModel model = ImportModel(options, &notes);
  for (const std::string& note : notes) console->Say(note);
  for (const std::string& warning : model.warnings) console->Say("WARNING: " + warning);
  WriteNewModel(model, options.output_path, options.output_type);
  console->Say("Written: " + options.output_path + " with " + std::to_string(model.cameras.size()) +
               " cameras, " + std::to_string(model.images.size()) + " images, " +
               std::to_string(model.points.size()) + " points");
  return 0;
}

}  // namespace limn::colmap_ext
