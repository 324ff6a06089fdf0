#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/drawing_export.h"

namespace limn::colmap_ext {

int RunDrawingExporter(int argc, const char* const* argv, const ConsoleMaker& make_console) {
  ExporterOptions options;
  OptionParser parser("drawing_exporter", "write a drawing in the format of another program");
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.Check();
  const auto console = make_console(/*num_threads=*/-1, /*speaks=*/true);
  const auto [drawing, format] = PrepareExport(options, console.get());
  WriteDrawing(options.output_path, drawing.graph, drawing.metadata, format);
  console->Say("Written: " + options.output_path + " (" +
               std::to_string(drawing.graph.links.size()) + " links)");
  return 0;
}

}  // namespace limn::colmap_ext
