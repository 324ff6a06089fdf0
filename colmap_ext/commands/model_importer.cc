#include <algorithm>
#include <iostream>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/import/formats.h"
#include "colmap_ext/import/new_model_folder.h"
#include "colmap_ext/options/option_parser.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

enum class PixelCentersOption { kOfTheFormat, kInteger, kHalf };

struct ImporterOptions {
  std::string input_path, image_path, output_path, list_path;
  std::string input_type = "auto";
  ModelFlavor output_type = ModelFlavor::kBinary;
  PixelCentersOption pixel_centers = PixelCentersOption::kOfTheFormat;
  double share_cameras_px = SparseModelOptions().share_cameras_px;
  bool skip_missing_images = false;
  int model_index = -1;
};

void AddOptions(ImporterOptions* options, OptionParser* parser) {
  std::vector<std::string> types = {"auto"};
  for (const ImportFormat& format : ImportFormats()) types.emplace_back(format.name);
  parser->AddOption("input_path", &options->input_path, "cameras: a file, or the folder of them");
  parser->AddOption("input_type", &options->input_type, types,
                    "format of the cameras; auto = recognize it");
  parser->AddOption("image_path", &options->image_path,
                    "folder of the images; default: the folder of the cameras");
  parser->AddOption("output_path", &options->output_path,
                    "folder for the model, new or empty, e.g. my_project/sparse/0");
  parser->AddOption("output_type", &options->output_type,
                    {{"bin", ModelFlavor::kBinary}, {"txt", ModelFlavor::kText}},
                    "binary or text files");
  parser->AddOption("list_path", &options->list_path,
                    "text file with the image names in the order of the cameras, for bundler, "
                    "projection_matrices and intrinsic_extrinsic");
  parser->AddOption("pixel_centers", &options->pixel_centers,
                    {{"auto", PixelCentersOption::kOfTheFormat},
                     {"integer", PixelCentersOption::kInteger},
                     {"half", PixelCentersOption::kHalf}},
                    "the center of the top-left pixel is (0, 0) or (0.5, 0.5) in the input; auto = "
                    "integer for projection_matrices, intrinsic_extrinsic and middlebury, else "
                    "half");
  parser->AddOption("share_cameras_px", &options->share_cameras_px,
                    "images share a camera if that moves no pixel by more, pixels");
  parser->AddOption("skip_missing_images", &options->skip_missing_images,
                    "leave out cameras without an image");
  parser->AddOption("model_index", &options->model_index,
                    "which model of an nvm file; -1 = the one with most images");
}

void Check(const ImporterOptions& options) {
  if (options.input_path.empty()) throw OptionError("--input_path must be given");
  if (options.output_path.empty()) throw OptionError("--output_path must be given");
  CheckOption(options.share_cameras_px >= 0, "share_cameras_px", options.share_cameras_px, ">= 0");
  CheckOption(options.model_index >= -1, "model_index", options.model_index, ">= -1");
}

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

void SayMissing(const std::vector<std::string>& names) {
  if (names.empty()) return;
  std::cout << names.size() << " images are missing and left out: " << names.front()
            << (names.size() > 1 ? ", ..." : "") << "\n";
}

}  // namespace

int RunModelImporter(int argc, const char* const* argv) {
  ImporterOptions options;
  OptionParser parser("model_importer", "make a COLMAP model from cameras in another format");
  AddOptions(&options, &parser);
  if (parser.Parse(argc, argv, std::cout) == OptionParser::Outcome::kHelp) return 0;
  Check(options);
  CheckNewModelFolder(options.output_path);
  const ImportFormat& format = options.input_type == "auto" ? RecognizeFormat(options.input_path)
                                                            : *FindImportFormat(options.input_type);
  ImageFolder images(ImagePath(options), options.skip_missing_images);
  ImportedScene scene =
      format.read({options.input_path, &images, options.list_path, options.model_index});
  if (scene.images.empty()) throw IoError(options.input_path, "no image with a camera");
  const PixelCenters pixel_centers = PixelCentersOf(format, options.pixel_centers);
  std::cout << "Format " << format.name << ", center of the top-left pixel at "
            << (pixel_centers == PixelCenters::kInteger ? "(0, 0)" : "(0.5, 0.5)") << "\n";
  for (const std::string& note : scene.notes) std::cout << note << "\n";
  SayMissing(images.missing());
  const SparseModel model =
      ToSparseModel(std::move(scene), {pixel_centers, options.share_cameras_px});
  for (const std::string& warning : model.warnings) std::cout << "WARNING: " << warning << "\n";
  WriteNewModel(model, options.output_path, options.output_type);
  std::cout << "Written: " << options.output_path << " with " << model.cameras.size()
            << " cameras, " << model.images.size() << " images, " << model.points.size()
            << " points\n";
  return 0;
}

}  // namespace limn::colmap_ext
