#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/verbs/export_drawing.h"

namespace limn::colmap_ext {

int RunDrawingExporter(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  ExporterOptions options;
  OptionParser parser("drawing_exporter", "write a drawing in the format of another program");
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.Check();
  const auto console = make_console(/*num_threads=*/-1, /*speaks=*/true);
  const size_t num_links = ExportDrawing(options, console.get());
  console->Say("Written: " + options.output_path + " (" + std::to_string(num_links) + " links)");
  return 0;
}

}  // namespace limn::colmap_ext
