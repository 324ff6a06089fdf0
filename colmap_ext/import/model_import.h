// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include "colmap_ext/import/imported_scene.h"
#include "colmap_ext/import/mask_list.h"
#include "colmap_ext/import/new_model_folder.h"
#include "colmap_ext/options/option_parser.h"

namespace limn::colmap_ext {

enum class PixelCentersOption { kOfTheFormat, kInteger, kHalf };

// The options of model_importer.
struct ImporterOptions {
  std::string input_path, image_path, output_path, list_path;
  std::string input_type = "auto";
  ModelFlavor output_type = ModelFlavor::kBinary;
  PixelCentersOption pixel_centers = PixelCentersOption::kOfTheFormat;
  double share_cameras_px = SparseModelOptions().share_cameras_px;
  bool skip_missing_images = false;
  int model_index = -1;

  void AddOptions(OptionParser* parser);
  // Throws OptionError.
  void Check() const;
};

struct ImportedModel {
  SparseModel model;
  ImageMasks masks;  // of the formats that name them
};

// Reads cameras in the given format, or in the one recognized from the path. Appends what the user
// should know to `notes`, one line each. Throws IoError.
ImportedModel ImportModel(const ImporterOptions& options, std::vector<std::string>* notes);

}  // namespace limn::colmap_ext
