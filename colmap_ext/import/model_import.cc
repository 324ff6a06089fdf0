// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/import/model_import.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "colmap_ext/import/formats.h"
#include "colmap_ext/import/stated_size.h"
#include "colmap_ext/workspace/find_masks.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

std::filesystem::path ImagePath(const ImporterOptions& options) {
  if (!options.image_path.empty()) return options.image_path;
  std::error_code ignored;
  const std::filesystem::path input = options.input_path;
  if (std::filesystem::is_directory(input, ignored)) return input;
  return std::filesystem::absolute(input).parent_path();
}

PixelCenters PixelCentersOf(const ImportFormat& format, PixelCentersOption option) {
  if (option == PixelCentersOption::kOfTheFormat) return format.pixel_centers;
  return option == PixelCentersOption::kInteger ? PixelCenters::kInteger : PixelCenters::kHalf;
}

// How many they are and the first of them.
void NoteLeftOut(const std::vector<std::string>& names, const std::string& what,
                 std::vector<std::string>* notes) {
  constexpr size_t kMaxNames = 8;
  if (names.empty()) return;
  std::string note = std::to_string(names.size()) + " images " + what + " and are left out: ";
  for (size_t i = 0; i < std::min(names.size(), kMaxNames); ++i) {
    note += (i > 0 ? ", " : "") + names[i];
  }
  notes->push_back(note + (names.size() > kMaxNames ? ", ..." : ""));
}

// Of the images directly in the folder.
std::vector<std::string> WithoutCamera(const ImageFolder& images, const ImportedScene& scene) {
  std::set<std::string> with_camera;
  for (const ImportedImage& image : scene.images) with_camera.insert(image.name);
  std::vector<std::string> names = images.Names();
  std::erase_if(names, [&](const std::string& name) { return with_camera.contains(name); });
  return names;
}

ImageMasks MasksOf(const ImportedScene& scene) {
  ImageMasks masks;
  for (const ImportedImage& image : scene.images) {
    if (!image.mask.empty()) masks[image.name] = image.mask;
  }
  return masks;
}

}  // namespace

void ImporterOptions::AddOptions(OptionParser* parser) {
  std::vector<std::string> types = {"auto"};
  for (const ImportFormat& format : ImportFormats()) types.emplace_back(format.name);
  parser->AddOption("input_path", &input_path,
                    BasicOption("cameras: a file, or a folder of files"));
  parser->AddOption("input_type", &input_type, types,
                    BasicOption("format of the cameras; auto = recognize it"));
  parser->AddOption("image_path", &image_path,
                    BasicOption("folder of the images; default: the folder of the cameras"));
  parser->AddOption("output_path", &output_path,
                    BasicOption("folder for the model, new or empty, e.g. my_project/sparse/0"));
  parser->AddOption("output_type", &output_type,
                    {{"bin", ModelFlavor::kBinary}, {"txt", ModelFlavor::kText}},
                    BasicOption("binary or text files"));
  parser->AddOption("list_path", &list_path,
                    BasicOption("text file with the image names in the order of the cameras, for "
                                "bundler, projection_matrices and intrinsic_extrinsic"));
  parser->AddOption("pixel_centers", &pixel_centers,
                    {{"auto", PixelCentersOption::kOfTheFormat},
                     {"integer", PixelCentersOption::kInteger},
                     {"half", PixelCentersOption::kHalf}},
                    "the center of the top-left pixel is (0, 0) or (0.5, 0.5) in the input; auto = "
                    "integer for projection_matrices, intrinsic_extrinsic, middlebury and openmvg, "
                    "else half");
  parser->AddOption("share_cameras_px", &share_cameras_px,
                    "images share a camera if that moves no pixel by more, pixels");
  parser->AddOption("skip_missing_images", &skip_missing_images,
                    BasicOption("leave out cameras without an image"));
  parser->AddOption(
      "model_index", &model_index,
      "which model of an nvm file, reconstruction of opensfm or chunk of metashape; -1 = the "
      "one with the most images");
}

void ImporterOptions::Check() const {
  if (input_path.empty()) throw OptionError("--input_path must be given");
  if (output_path.empty()) throw OptionError("--output_path must be given");
  LIMN_CHECK_RANGE(share_cameras_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(model_index, >= -1, <= 1e6);
}

ImportedModel ImportModel(const ImporterOptions& options, std::vector<std::string>* notes) {
  const ImportFormat& format = options.input_type == "auto" ? RecognizeFormat(options.input_path)
                                                            : *FindImportFormat(options.input_type);
  ImageFolder images(ImagePath(options), options.skip_missing_images);
  ImportedScene scene =
      format.read({options.input_path, &images, options.list_path, options.model_index});
  if (scene.images.empty()) throw IoError(options.input_path, "no image with a camera");
  const PixelCenters pixel_centers = PixelCentersOf(format, options.pixel_centers);
  notes->push_back(std::string("Format ") + format.name + ", center of the top-left pixel at " +
                   (pixel_centers == PixelCenters::kInteger ? "(0, 0)" : "(0.5, 0.5)"));
  notes->insert(notes->end(), scene.notes.begin(), scene.notes.end());
  if (const std::string note = NoteResized(scene.images); !note.empty()) notes->push_back(note);
  NoteLeftOut(images.missing(), "are missing", notes);
  NoteLeftOut(WithoutCamera(images, scene), "have no camera", notes);
  ImageMasks masks = MasksOf(scene);
  if (!masks.empty()) {
    notes->push_back(std::to_string(masks.size()) + " of " + std::to_string(scene.images.size()) +
                     " images have masks, which " + kMaskList + " of the model lists for drawing");
  }
  return {ToSparseModel(std::move(scene), {pixel_centers, options.share_cameras_px}),
          std::move(masks)};
}

}  // namespace limn::colmap_ext
