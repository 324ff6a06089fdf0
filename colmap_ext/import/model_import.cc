#include "colmap_ext/import/model_import.h"

#include <filesystem>
#include <ostream>
#include <utility>
#include <vector>

#include "colmap_ext/import/formats.h"
#include "limn/util/errors.h"
#include "limn/util/printable.h"

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

void NoteMissing(const std::vector<std::string>& names, std::ostream& notes) {
  if (names.empty()) return;
  notes << names.size() << " images are missing and left out: " << Printable(names.front())
        << (names.size() > 1 ? ", ..." : "") << "\n";
}

}  // namespace

void ImporterOptions::AddOptions(OptionParser* parser) {
  std::vector<std::string> types = {"auto"};
  for (const ImportFormat& format : ImportFormats()) types.emplace_back(format.name);
  parser->AddOption("input_path", &input_path,
                    BasicOption("cameras: a file, or the folder of them"));
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
                    "integer for projection_matrices, intrinsic_extrinsic and middlebury, else "
                    "half");
  parser->AddOption("share_cameras_px", &share_cameras_px,
                    "images share a camera if that moves no pixel by more, pixels");
  parser->AddOption("skip_missing_images", &skip_missing_images,
                    BasicOption("leave out cameras without an image"));
  parser->AddOption("model_index", &model_index,
                    "which model of an nvm file; -1 = the one with the most images");
}

void ImporterOptions::Check() const {
  if (input_path.empty()) throw OptionError("--input_path must be given");
  if (output_path.empty()) throw OptionError("--output_path must be given");
  LIMN_CHECK_RANGE(share_cameras_px, >= 0, <= 1e5);
  LIMN_CHECK_RANGE(model_index, >= -1, <= 1e6);
}

SparseModel ImportModel(const ImporterOptions& options, std::ostream& notes) {
  const ImportFormat& format = options.input_type == "auto" ? RecognizeFormat(options.input_path)
                                                            : *FindImportFormat(options.input_type);
  ImageFolder images(ImagePath(options), options.skip_missing_images);
  ImportedScene scene =
      format.read({options.input_path, &images, options.list_path, options.model_index});
  if (scene.images.empty()) throw IoError(options.input_path, "no image with a camera");
  const PixelCenters pixel_centers = PixelCentersOf(format, options.pixel_centers);
  notes << "Format " << format.name << ", center of the top-left pixel at "
        << (pixel_centers == PixelCenters::kInteger ? "(0, 0)" : "(0.5, 0.5)") << "\n";
  for (const std::string& note : scene.notes) notes << Printable(note) << "\n";
  NoteMissing(images.missing(), notes);
  return ToSparseModel(std::move(scene), {pixel_centers, options.share_cameras_px});
}

}  // namespace limn::colmap_ext
