#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/run/drawing_export.h"
#include "colmap_ext/run/interrupt.h"
#include "limn/util/printable.h"

namespace limn::colmap_ext {

int RunDrawingExporter(int argc, const char* const* argv) {
  ExporterOptions options;
  OptionParser parser("drawing_exporter", "write a drawing in the format of another program");
  options.AddOptions(&parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  options.Check();
  const auto [drawing, format] = PrepareExport(options);
  const InterruptWatch interrupts;  // reading may need one of its own
  WriteDrawing(options.output_path, drawing.graph, drawing.metadata, format);
  std::cout << "Written: " << Printable(options.output_path) << " (" << drawing.graph.links.size()
            << " links)\n";
  return 0;
}

}  // namespace limn::colmap_ext
