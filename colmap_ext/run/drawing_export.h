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
  // In the world, by the alignment of the drawing, and not in the coordinates of its model.
  bool aligned = false;
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

// Reads the drawing and what is exported with it, aligned, rotated and scaled. Throws IoError, also
// if the output must not be replaced or the drawing has no alignment that is asked for, and
// OptionError for a view that does not exist.
ExportedDrawing PrepareExport(const ExporterOptions& options, Console* console);

}  // namespace limn::colmap_ext
