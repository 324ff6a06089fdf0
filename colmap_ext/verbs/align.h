#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/scene.h"
#include "colmap_ext/options/option_parser.h"
#include "limn/alignment/align_drawing.h"
#include "limn/formats/json_drawing_reader.h"

namespace limn::colmap_ext {

// The options of commands that align a drawing.
struct AlignOptions {
  enum class Mode { kNone, kAuto };
  Mode mode = Mode::kNone;
  // Empty: the one found near the model.
  std::string database_path;
  // See ParseKnownLengths.
  std::vector<std::string> known_lengths;

  // Known lengths name links, so only commands that start from a drawing have them; these commands
  // align in any case.
  void AddOptions(bool of_drawing, OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

// Up, axes and scale of the drawings of a scene.
class SceneAligner {
 public:
  // Before work starts: reads the priors of the views if there is to be an alignment, and says
  // which. Throws IoError for a given database that cannot be read, and OptionError; of a database
  // that was found it only warns. The scene must outlive the aligner.
  SceneAligner(const Scene& scene, const LayoutOptions& layout, const AlignOptions& options,
               Console* console);

  // Says how it was found. `views`, which the drawing fits, and the graph are relative to the
  // scene's origin; the alignment is of the model's coordinates. Nothing if none is asked for.
  // Throws OptionError for a known length that the graph does not have.
  std::optional<Alignment> Align(const std::vector<View>& views, const DrawingGraph& graph,
                                 Console* console) const;

 private:
  const Scene& scene_;
  bool is_asked_ = false;
  std::vector<KnownLength> lengths_;
  std::vector<ViewPrior> priors_;
};

// The drawings of an output folder to align: the newest, in which is measured, then drawing.json if
// that is not the newest. An older drawing-fused.json is not aligned, and warned of. Throws IoError
// if there is none.
std::vector<std::string> DrawingsToAlign(const std::filesystem::path& folder, Console* console);

// Stores the alignment in drawings, whose graphs stay as they are, and so do their times of change,
// by which commands take the newest. All are read before the first is written. Throws IoError.
void StoreAlignment(const std::vector<std::string>& drawing_paths, const Alignment& alignment);

// The alignment of a drawing that shall be shown or exported with it. Throws IoError naming the
// file if it has none.
const Alignment& RequireAlignment(const std::string& path, const DrawingMetadata& metadata);

}  // namespace limn::colmap_ext
