// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/camera_files.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

#include "colmap_ext/workspace/folder_search.h"
#include "limn/util/lower_case.h"
#include "limn/util/name_list.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr size_t kHeadBytes = size_t{1} << 16;
constexpr int kMaxHeads = 1000;  // read of a folder

struct Kind {
  const char* end;  // of the name, in lower case
  // Words that the first bytes have, and how these begin after white space.
  std::vector<const char*> words;
  const char* start;
  const char* program;
  const char* input_type;
  const char* way_out;
};

constexpr char kMeshroomWay[] =
    "aliceVision_exportColmap of AliceVision writes a COLMAP model of it";
constexpr char kMetashapeWay[] =
    "File > Export > Export Cameras, type Agisoft XML, writes a file that model_importer reads";
constexpr char kRealityCaptureWay[] =
    "Alignment > Export > Registration, type Internal/External camera parameters, writes a .csv "
    "that model_importer reads";

// The first that fits counts.
const std::vector<Kind>& Kinds() {
  static const std::vector<Kind> kinds = {
      {".nvm", {}, "NVM_V3", "VisualSFM", kNvmType, ""},
      {".out", {}, "# Bundle file", "Bundler", kBundlerType, ""},
      {".json", {"\"sfm_data_version\""}, "{", "openMVG", kOpenmvgType, ""},
      {".json",
       {"\"frames\"", "\"transform_matrix\""},
       "{",
       "nerfstudio, instant-ngp or NeRF",
       kNerfTransformsType,
       ""},
      {"transforms.json", {}, "{", "nerfstudio, instant-ngp or NeRF", kNerfTransformsType, ""},
      {"transforms_train.json", {}, "{", "nerfstudio or NeRF", kNerfTransformsType, ""},
      {"transforms_test.json", {}, "{", "nerfstudio or NeRF", kNerfTransformsType, ""},
      {"transforms_val.json", {}, "{", "nerfstudio or NeRF", kNerfTransformsType, ""},
      {".json", {"\"cameras\""}, "[", "OpenSfM", kOpensfmType, ""},
      {"reconstruction.json", {}, "[", "OpenSfM", kOpensfmType, ""},
      {".xml", {"<document", "<chunk"}, "<", "Metashape", kMetashapeType, ""},
      {".csv", {"heading", "pitch", "roll"}, "#", "RealityCapture", kRealityCaptureType, ""},
      {".sfm", {}, "", "Meshroom", "", kMeshroomWay},
      {".json", {"\"views\"", "\"viewId\""}, "{", "Meshroom", "", kMeshroomWay},
      {".abc", {}, "", "Meshroom", "", kMeshroomWay},
      {".mvs", {}, "MVSI", "OpenMVS", "", "InterfaceCOLMAP of OpenMVS writes a COLMAP model of it"},
      {".mvs", {}, "", "OpenMVS", "", "InterfaceCOLMAP of OpenMVS writes a COLMAP model of it"},
      {"sfm_data.bin",
       {},
       "",
       "openMVG",
       "",
       "openMVG_main_ConvertSfM_DataFormat makes a .json of it that model_importer reads"},
      {"poses_bounds.npy",
       {},
       "",
       "LLFF",
       "",
       "it names no images and has no lens: use the COLMAP model (sparse/0) it was made from"},
      {".psx", {}, "", "Metashape", "", kMetashapeWay},
      {".psz", {}, "", "Metashape", "", kMetashapeWay},
      {".rcproj", {}, "", "RealityCapture", "", kRealityCaptureWay},
      {".rsproj", {}, "", "RealityScan", "", kRealityCaptureWay},
      {".xmp", {"xcr:"}, "<", "RealityCapture", "", kRealityCaptureWay},
      {".p4d",
       {},
       "",
       "Pix4D",
       "",
       "its calibrated external parameters are not read: export undistorted images to COLMAP"},
  };
  return kinds;
}

std::string HeadOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(kHeadBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<size_t>(in.gcount()));
  return head;
}

std::string_view WithoutSpace(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

bool Fits(const Kind& kind, std::string_view head) {
  return WithoutSpace(head).starts_with(kind.start) &&
         std::ranges::all_of(kind.words,
                             [&](const char* word) { return head.find(word) != head.npos; });
}

bool HasEnd(const fs::path& file, const Kind& kind) {
  return LowerCase(file.filename().string()).ends_with(kind.end);
}

// By its name.
bool MayHoldCameras(const fs::path& file) {
  return std::ranges::any_of(Kinds(), [&](const Kind& kind) { return HasEnd(file, kind); });
}

}  // namespace

std::string ShellWord(const fs::path& path) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-+,:=@%";
  const std::string text = path.string();
  if (text.find_first_not_of(kPlain) == text.npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::optional<CameraFile> RecognizeCameraFile(const fs::path& file) {
  std::error_code ignored;
  if (!MayHoldCameras(file) || !fs::is_regular_file(file, ignored)) return std::nullopt;
  const std::string head = HeadOf(file);
  for (const Kind& kind : Kinds()) {
    if (!HasEnd(file, kind) || !Fits(kind, head)) continue;
    return CameraFile{file, kind.program, kind.input_type, kind.way_out};
  }
  return std::nullopt;
}

bool HoldsCameraFile(const fs::path& path, const std::string& input_type) {
  const auto is_one = [&](const fs::path& file) {
    const auto found = RecognizeCameraFile(file);
    return found && found->input_type == input_type;
  };
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return is_one(path);
  const FolderSearch found = SearchFolder(path, 0);
  return std::ranges::any_of(found.files, is_one);
}

std::vector<CameraFile> FindCameraFiles(const fs::path& folder) {
  std::vector<CameraFile> found;
  int num_heads = 0;
  for (const fs::path& file : SearchFolder(folder, 3).files) {
    if (!MayHoldCameras(file)) continue;
    if (++num_heads > kMaxHeads) break;
    if (auto camera_file = RecognizeCameraFile(file)) found.push_back(std::move(*camera_file));
  }
  // openMVG has a file without poses beside its matches.
  std::ranges::stable_sort(found, {}, [](const CameraFile& file) {
    return std::pair(file.input_type.empty(), file.path.parent_path().filename() == "matches");
  });
  return found;
}

std::string HowToImport(const std::vector<CameraFile>& files, const fs::path& workspace,
                        const fs::path& image_dir) {
  const CameraFile& first = files.front();
  std::string text = first.path.string() + " is of " + first.program + ": ";
  if (first.input_type.empty()) {
    text += first.way_out;
  } else {
    text += "make a model of it by `limn model_importer --input_path " + ShellWord(first.path) +
            " --image_path " +
            (image_dir.empty() ? "<folder of the photographs>" : ShellWord(image_dir)) +
            " --output_path " + ShellWord(workspace / "sparse" / "0") + "`";
  }
  std::vector<std::string> others;
  for (size_t i = 1; i < files.size(); ++i) {
    others.push_back(files[i].path.lexically_relative(workspace).string() + " (" +
                     files[i].program + ")");
  }
  if (!others.empty()) text += "; there are also " + ListNames(others);
  return text;
}

}  // namespace limn::colmap_ext
