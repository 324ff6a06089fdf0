// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/layout.h"

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "colmap_ext/workspace/camera_files.h"
#include "colmap_ext/workspace/folder_search.h"
#include "colmap_ext/workspace/model_folder.h"
#include "colmap_ext/workspace/pmvs_model.h"
#include "colmap_ext/workspace/refined_folder.h"
#include "limn/util/errors.h"
#include "limn/util/parse_number.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMaxListed = 20;

// Where a project may have its models, or numbered folders of them, the first that has counts:
// those of COLMAP, of nerfstudio, and of instant-ngp.
constexpr std::array kSparseFolders = {"sparse", "colmap/sparse", "colmap_sparse", "colmap_text"};

struct Candidate {
  fs::path model_dir;
  fs::path image_dir;
  fs::path base_dir;   // results go here
  fs::path dense_dir;  // empty for a sparse model
  int index = 0;
  size_t num_rivals = 0;  // models it was chosen from
};

bool IsFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

std::vector<fs::path> SortedEntries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    entries.push_back(it->path());
  }
  if (error) throw IoError(folder.string(), "cannot be listed: " + error.message());
  std::sort(entries.begin(), entries.end());
  return entries;
}

// The sub-folders whose names are numbers, ascending.
std::vector<std::pair<int, fs::path>> NumberedFolders(const fs::path& folder) {
  std::vector<std::pair<int, fs::path>> folders;
  if (!IsFolder(folder)) return folders;
  for (const fs::path& entry : SortedEntries(folder)) {
    const auto index = ParseNumber<int>(entry.filename().string());
    if (index && *index >= 0 && IsFolder(entry)) folders.emplace_back(*index, entry);
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

// "a/ b.txt ..." for messages; folders with a slash.
std::string Listing(const fs::path& folder) {
  const std::vector<fs::path> entries = SortedEntries(folder);
  if (entries.empty()) return "nothing";
  std::string text;
  for (size_t i = 0; i < std::min(entries.size(), kMaxListed); ++i) {
    text +=
        (i > 0 ? ", " : "") + entries[i].filename().string() + (IsFolder(entries[i]) ? "/" : "");
  }
  if (entries.size() > kMaxListed) {
    text += " and " + std::to_string(entries.size() - kMaxListed) + " more";
  }
  return text;
}

// Where a workspace may have models.
std::vector<fs::path> FoldersOfModels(const fs::path& workspace) {
  std::vector<fs::path> folders = {workspace / "dense" / "sparse", workspace, workspace / "pmvs"};
  std::vector<fs::path> parents(kSparseFolders.begin(), kSparseFolders.end());
  for (const char* parent : {"distorted/sparse", ""}) parents.emplace_back(parent);
  for (const fs::path& parent : parents) {
    folders.push_back(workspace / parent);
    for (const auto& [index, folder] : NumberedFolders(workspace / parent)) {
      folders.push_back(folder);
      for (const auto& [inner, inner_folder] : NumberedFolders(folder)) {
        folders.push_back(inner_folder);
      }
    }
  }
  for (const auto& [index, folder] : NumberedFolders(workspace / "dense")) {
    folders.push_back(folder / "sparse");
  }
  return folders;
}

// Throws if some folder of the workspace lacks only one file to be a model.
void CheckForIncompleteModels(const fs::path& workspace) {
  for (const fs::path& folder : FoldersOfModels(workspace)) {
    const std::string missing = MissingModelFile(folder);
    if (!missing.empty()) throw IoError(folder.string(), "not a COLMAP model: " + missing);
  }
}

// Where a project may have its images, the best first: `images`, `input` of gaussian-splatting
// (before it undistorts), and shrunk ones of nerfstudio and mip-NeRF 360.
constexpr char kInputFolder[] = "input";
constexpr std::array kImageFolders = {"images", kInputFolder, "images_2", "images_4", "images_8"};

// The first that exists; `images` if none does. With `distorted`, `input` belongs to the model
// there.
fs::path ImageFolderIn(const fs::path& folder) {
  for (const std::string_view name : kImageFolders) {
    if (name == kInputFolder && IsFolder(folder / "distorted")) continue;
    if (IsFolder(folder / name)) return folder / name;
  }
  return folder / kImageFolders.front();
}

fs::path ImageFolderOrNone(const fs::path& folder) {
  const fs::path images = ImageFolderIn(folder);
  return IsFolder(images) ? images : fs::path();
}

std::string HowToImportNear(const CameraFile& file) {
  const fs::path folder = file.path.parent_path();
  return HowToImport({file}, folder, ImageFolderOrNone(folder));
}

// Those in the workspace and up to three folders below.
std::vector<fs::path> ModelsBelow(const FolderSearch& found) {
  std::vector<fs::path> models;
  std::ranges::copy_if(found.folders, std::back_inserter(models), HoldsModel);
  return models;
}

// The folder that has the first image of a model; empty if none has.
fs::path FolderWithImagesOf(const fs::path& model, const FolderSearch& found) {
  std::string name;
  try {
    const SparseModel read = ReadModel(model);
    if (!read.images.empty())
      name = read.images[0].file.empty() ? read.images[0].name : read.images[0].file;
  } catch (const std::exception&) {
    return {};  // what is wrong with it is told when it is used
  }
  std::error_code ignored;
  const auto has_it = [&](const fs::path& folder) {
    return !name.empty() && fs::is_regular_file(folder / name, ignored);
  };
  const auto first = std::ranges::find_if(found.folders, has_it);
  return first == found.folders.end() ? fs::path() : *first;
}

// What to do with what the workspace holds instead of a model with its images, in one sentence that
// begins in lower case; empty if it holds nothing of use.
std::string WayOut(const fs::path& workspace, const LayoutOptions& options) {
  const FolderSearch found = SearchFolder(workspace, 3);
  const std::vector<fs::path> models = ModelsBelow(found);
  if (!models.empty()) {
    const fs::path images = options.image_path.empty() ? FolderWithImagesOf(models[0], found)
                                                       : fs::path(options.image_path);
    const std::string model =
        "there is a model in " + models[0].string() + ": --input_path " + ShellWord(models[0]);
    return images.empty() ? model + " --image_path <folder of its photographs> uses it"
                          : model + " --image_path " + ShellWord(images) + " uses it";
  }
  const std::vector<CameraFile> files = FindCameraFiles(workspace);
  if (!files.empty()) {
    return HowToImport(
        files, workspace,
        options.image_path.empty() ? ImageFolderOrNone(workspace) : fs::path(options.image_path));
  }
  std::error_code ignored;
  if (fs::exists(workspace / "database.db", ignored)) {
    const fs::path images = ImageFolderIn(workspace);
    return "database.db holds no cameras: `colmap mapper --database_path " +
           ShellWord(workspace / "database.db") + " --image_path " + ShellWord(images) +
           " --output_path " + ShellWord(workspace / "sparse") + "` makes a model";
  }
  return "";
}

[[noreturn]] void FailNothingFits(const fs::path& workspace, const LayoutOptions& options) {
  CheckForIncompleteModels(workspace);
  std::string found = "found " + Listing(workspace);
  for (const char* name : {"sparse", "dense"}) {
    if (IsFolder(workspace / name)) {
      found += std::string("; in ") + name + ": " + Listing(workspace / name);
    }
  }
  const std::string asked =
      options.model_index < 0 ? "" : " with model_index " + std::to_string(options.model_index);
  const std::string way_out = WayOut(workspace, options);
  throw IoError(
      workspace.string(),
      "no COLMAP model with its images" + asked +
          " (expected sparse/ and images/, dense/<i>/, sparse/<i>/ and images/, or pmvs/): " +
          found + (way_out.empty() ? "" : "; " + way_out));
}

// The first one that has most registered images.
Candidate MostRegistered(const std::vector<Candidate>& found) {
  size_t best = 0;
  uint64_t most = 0;
  for (size_t i = 0; i < found.size() && found.size() > 1; ++i) {
    const uint64_t count = CountRegisteredImages(found[i].model_dir);
    if (count > most) {
      most = count;
      best = i;
    }
  }
  Candidate chosen = found[best];
  chosen.num_rivals = found.size();
  return chosen;
}

class Finder {
 public:
  Finder(fs::path workspace, const LayoutOptions& options)
      : workspace_(std::move(workspace)), options_(options) {}

  Candidate Find() const {
    std::vector<Candidate> found;
    AddDense(workspace_, kNoIndex, &found);
    if (found.empty()) {
      for (const auto& [index, folder] : NumberedFolders(workspace_ / "dense")) {
        AddDense(folder, index, &found);
      }
    }
    if (found.empty()) AddDense(workspace_ / "dense", kNoIndex, &found);
    for (const char* sparse : kSparseFolders) {
      if (found.empty()) AddSparse(workspace_ / sparse, ImagesIn(workspace_), &found);
    }
    if (found.empty()) AddDistorted(&found);
    for (const fs::path& folder : {workspace_, workspace_ / "pmvs"}) {
      if (found.empty()) AddPmvs(folder, &found);
    }
    if (found.empty()) AddModelFolder(&found);
    if (found.empty()) FailNothingFits(workspace_, options_);
    return MostRegistered(found);
  }

 private:
  static constexpr int kNoIndex = -1;

  fs::path ImagesIn(const fs::path& folder) const {
    return options_.image_path.empty() ? ImageFolderIn(folder) : fs::path(options_.image_path);
  }

  void AddDense(const fs::path& folder, int index, std::vector<Candidate>* found) const {
    Add({folder / "sparse", ImagesIn(folder), folder, folder, index}, found);
  }

  // Numbered models in a folder, also one deeper (where the mapper was told to write to
  // sparse/0), else the folder itself.
  void AddSparse(const fs::path& folder, const fs::path& image_dir,
                 std::vector<Candidate>* found) const {
    for (const auto& [index, model_dir] : NumberedFolders(folder)) {
      Add({model_dir, image_dir, workspace_, {}, index}, found);
      if (HoldsModel(model_dir)) continue;
      for (const auto& [inner, inner_dir] : NumberedFolders(model_dir)) {
        Add({inner_dir, image_dir, workspace_, {}, inner}, found);
      }
    }
    if (found->empty()) Add({folder, image_dir, workspace_, {}, kNoIndex}, found);
  }

  // What gaussian-splatting starts from: its images are in `input`, and those in `images`, if any,
  // undistorted.
  void AddDistorted(std::vector<Candidate>* found) const {
    const fs::path image_dir =
        options_.image_path.empty() ? workspace_ / kInputFolder : fs::path(options_.image_path);
    AddSparse(workspace_ / "distorted" / "sparse", image_dir, found);
  }

  void AddPmvs(const fs::path& folder, std::vector<Candidate>* found) const {
    const fs::path image_dir =
        options_.image_path.empty() ? folder / "visualize" : fs::path(options_.image_path);
    if (HoldsPmvsModel(folder)) Add({folder, image_dir, folder, {}, kNoIndex}, found);
  }

  // The workspace is `sparse` or a model itself, with the images in it or up to two folders above.
  void AddModelFolder(std::vector<Candidate>* found) const {
    const fs::path absolute = fs::weakly_canonical(workspace_);
    for (const fs::path& folder :
         {workspace_, absolute.parent_path(), absolute.parent_path().parent_path()}) {
      if (found->empty()) AddSparse(workspace_, ImagesIn(folder), found);
    }
  }

  void Add(const Candidate& candidate, std::vector<Candidate>* found) const {
    if (options_.model_index >= 0 && candidate.index != options_.model_index) return;
    if (HoldsModel(candidate.model_dir) && IsFolder(candidate.image_dir)) {
      found->push_back(candidate);
    }
  }

  fs::path workspace_;
  const LayoutOptions& options_;
};

// A model folder given by the user: the folder itself, or the best of its numbered sub-folders.
Candidate GivenModelFolder(const fs::path& given, int model_index) {
  Candidate direct;
  direct.model_dir = given;
  direct.num_rivals = 1;
  if (HoldsModel(given)) return direct;
  std::vector<Candidate> found;
  for (const auto& [index, folder] : NumberedFolders(given)) {
    if (!HoldsModel(folder) || (model_index >= 0 && index != model_index)) continue;
    found.push_back(direct);
    found.back().model_dir = folder;
  }
  if (!found.empty()) return MostRegistered(found);
  if (const auto file = RecognizeCameraFile(given)) {
    throw IoError(given.string(), "not a COLMAP model; " + HowToImportNear(*file));
  }
  if (!IsFolder(given)) throw IoError(given.string(), "no such folder");
  throw IoError(given.string(), "no COLMAP model (cameras and images): found " + Listing(given));
}

// A model given by the user: its images are beside it or its parent folder, else in the workspace.
Candidate GivenModel(const LayoutOptions& options) {
  Candidate result = GivenModelFolder(options.input_path, options.model_index);
  const fs::path absolute = fs::weakly_canonical(result.model_dir);
  const fs::path parent = absolute.parent_path();
  const bool dense =
      absolute.filename() == "sparse" && IsFolder(parent / "images") && IsFolder(parent / "stereo");
  if (dense) result.dense_dir = parent;
  result.base_dir = dense ? parent : fs::path(options.workspace_path);
  result.image_dir = options.image_path;
  if (!options.image_path.empty()) return result;
  result.image_dir = result.model_dir / "visualize";
  if (HoldsPmvsModel(result.model_dir)) return result;
  for (const fs::path& folder : {parent, parent.parent_path(), fs::path(options.workspace_path)}) {
    result.image_dir = ImageFolderIn(folder);
    if (IsFolder(result.image_dir)) return result;
  }
  throw IoError(options.input_path,
                "no folder `images` near this model; name it with --image_path");
}

// By their names: what is a link makes no difference.
bool IsBelow(const fs::path& folder, const fs::path& above) {
  const fs::path relative = folder.lexically_relative(above);
  return !relative.empty() && *relative.begin() != "..";
}

// The folder with the refined cameras of this name that a result fits. Empty if they are gone.
fs::path FindRefinedCameras(const std::string& name, const fs::path& result,
                            const OutputLayout& output) {
  for (const fs::path& folder : {output.drawing_dir, result.parent_path()}) {
    if (NameOfRefinedCameras(folder / kRefinedFolder) == name) return folder / kRefinedFolder;
  }
  return {};
}

OutputLayout OutputIn(const fs::path& base, const LayoutOptions& options) {
  const fs::path workspace = options.workspace_path;
  const bool is_inside = options.output_path.empty() && IsBelow(base, workspace);
  return {is_inside ? workspace : base, base, base / "curves"};
}

void ChooseCameras(const LayoutOptions& options, WorkspaceLayout* layout) {
  const fs::path start = NewestFile(layout->output.drawing_dir, options.starts_from);
  const std::string name = RefinedCamerasOf(start);
  if (name.empty()) return;
  if (options.input_path.empty() && TakeRefinedCameras(start, layout)) {
    layout->note =
        "Cameras: the refined ones that " + start.string() + " fits, " + layout->model_dir.string();
    return;
  }
  if (NameOfRefinedCameras(layout->model_dir) == name) return;
  const fs::path folder = FindRefinedCameras(name, start, layout->output);
  layout->note = "WARNING: " + start.string() + " fits refined cameras, not those of this model: " +
                 (folder.empty() ? "those are gone from " +
                                       (layout->output.drawing_dir / kRefinedFolder).string() +
                                       ", or were changed: draw again"
                                 : "--input_path " + folder.string() + " has them");
}

std::string Describe(const WorkspaceLayout& layout, const std::string& model, uint64_t num_images,
                     const std::string& choice) {
  return "Model " + model + " (" + std::to_string(num_images) + " registered images" + choice +
         "), images in " + layout.image_dir.string() + ", results to " +
         layout.output.drawing_dir.string();
}

void CheckImageFolder(const fs::path& folder) {
  if (!IsFolder(folder)) throw IoError(folder.string(), "no such folder (image_path)");
}

}  // namespace

void LayoutOptions::Check() const {
  LIMN_CHECK_RANGE(model_index, >= -1, <= 1e6);
  const bool complete = !input_path.empty() && !image_path.empty() && !output_path.empty();
  if (workspace_path.empty() && !complete) {
    throw OptionError(
        "workspace_path is missing: give it, or all of input_path, image_path and output_path");
  }
}

OutputPath OutputLayout::Drawing() const {
  const fs::path below = drawing_dir.lexically_relative(named_dir);
  return {named_dir, below == "." ? fs::path() : below};
}

OutputPath OutputLayout::Curves() const { return Drawing() / "curves"; }

WorkspaceLayout ResolveLayout(const LayoutOptions& options) {
  options.Check();
  if (!options.image_path.empty()) CheckImageFolder(options.image_path);
  if (!options.workspace_path.empty() && !IsFolder(options.workspace_path)) {
    const fs::path workspace = options.workspace_path;
    if (const auto file = RecognizeCameraFile(workspace)) {
      throw IoError(workspace.string(), "not a folder (workspace_path); " + HowToImportNear(*file));
    }
    throw IoError(options.workspace_path, "no such folder (workspace_path)");
  }
  const Candidate chosen = options.input_path.empty()
                               ? Finder(options.workspace_path, options).Find()
                               : GivenModel(options);
  WorkspaceLayout layout;
  layout.model_dir = layout.given_model_dir = chosen.model_dir;
  layout.image_dir = chosen.image_dir;
  layout.dense_dir = chosen.dense_dir;
  const fs::path base =
      options.output_path.empty() ? chosen.base_dir : fs::path(options.output_path);
  layout.output = OutputIn(base, options);
  ChooseCameras(options, &layout);
  layout.description = Describe(
      layout, layout.model_dir.string(), CountRegisteredImages(layout.model_dir),
      chosen.num_rivals < 2 ? "" : ", most of " + std::to_string(chosen.num_rivals) + " models");
  return layout;
}

bool TakeRefinedCameras(const fs::path& result, WorkspaceLayout* layout) {
  const std::string name = RefinedCamerasOf(result);
  if (name.empty()) return false;
  const fs::path folder = FindRefinedCameras(name, result, layout->output);
  if (folder.empty()) return false;
  layout->model_dir = folder;
  return true;
}

SparseModel ReadModelOf(const WorkspaceLayout& layout) {
  SparseModel model = ReadModel(layout.model_dir);
  if (layout.model_dir == layout.given_model_dir || !HoldsPmvsModel(layout.given_model_dir)) {
    return model;
  }
  // Their images have other names than their files, which only the PMVS folder knows.
  std::map<std::string, std::string> files;
  for (const ModelImage& image : ReadModel(layout.given_model_dir).images) {
    files[image.name] = image.file;
  }
  for (ModelImage& image : model.images) image.file = files[image.name];
  return model;
}

fs::path NewestFile(const fs::path& folder, const std::vector<std::string>& names) {
  fs::path newest;
  std::error_code ignored;
  for (const std::string& name : names) {
    const fs::path path = folder / name;
    if (!fs::exists(path, ignored)) continue;
    if (newest.empty() || fs::last_write_time(path) > fs::last_write_time(newest)) newest = path;
  }
  return newest;
}

bool HoldsSomeModel(const fs::path& workspace) {
  const std::vector<fs::path> folders = FoldersOfModels(workspace);
  return std::any_of(folders.begin(), folders.end(), [](const fs::path& folder) {
    return HoldsModel(folder) || !MissingModelFile(folder).empty();
  });
}

WorkspaceLayout LayoutInMemory(const LayoutOptions& options, size_t num_images) {
  for (const auto& [name, path] :
       {std::pair("image_path", options.image_path), {"output_path", options.output_path}}) {
    if (path.empty()) throw OptionError(std::string(name) + " is missing: the model is in memory");
  }
  CheckImageFolder(options.image_path);
  WorkspaceLayout layout;
  layout.image_dir = options.image_path;
  layout.output = OutputIn(options.output_path, options);
  layout.description = Describe(layout, "in memory", num_images, "");
  return layout;
}

}  // namespace limn::colmap_ext
