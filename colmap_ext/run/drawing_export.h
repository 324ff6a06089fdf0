#pragma once

#include <string>

#include "colmap_ext/options/option_parser.h"
#include "colmap_ext/run/console.h"
#include "colmap_ext/run/selection_options.h"
#include "colmap_ext/run/svg_source.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/formats/write_drawing.h"
#include "limn/model/drawing_transform.h"

namespace limn::colmap_ext {

// The options of drawing_exporter.
struct ExporterOptions {
  std::string input_path, output_path;
  // Replace an output that is an input, a drawing.json or not ours.
  bool overwrite = false;
  bool junctions = true;
  SelectionOptions selection;
  std::string cloud_path;
  DrawingFormatOptions format;
  double scale = 1;
  SignedAxis up_axis = SignedAxis::kZ;
  SvgSource svg;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

// A drawing in the coordinates of its file, and the options it is written with.
struct ExportedDrawing {
  DrawingFile drawing;
  DrawingFormatOptions format;
};

// The drawing as the options say, with what is exported beside it. Throws IoError, also if the
// output must not be replaced, and OptionError for a view that does not exist.
ExportedDrawing PrepareExport(DrawingFile drawing, const ExporterOptions& options,
                              Console* console);
// The same for the drawing of the options' input_path.
ExportedDrawing PrepareExport(const ExporterOptions& options, Console* console);

}  // namespace limn::colmap_ext
