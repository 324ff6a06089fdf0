// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/refined_folder.h"

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "colmap_ext/model/model_reader.h"
#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/workspace/file_identity.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/cache/content_hash.h"
#include "limn/cache/curve_sketch_file.h"
#include "limn/files/atomic_file.h"
#include "limn/files/whole_file.h"
#include "limn/files/writable_folder.h"
#include "limn/formats/json_drawing_reader.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRecord = "limn.txt";
constexpr const char* kRecordHead = "# Files of this model as limn wrote them: SIZE, HASH, NAME\n";

bool Exists(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

// The names of all files that a model may have.
std::vector<std::string> ModelFileNames() {
  std::vector<std::string> names;
  for (const ModelFlavor flavor : {ModelFlavor::kBinary, ModelFlavor::kText}) {
    for (const ModelFile& file : ModelFilesOf(flavor)) names.push_back(file.name);
  }
  return names;
}

// A line of the record.
std::string Line(const std::string& name, const std::string& identity) {
  return identity + " " + name;
}

using Record = std::set<std::string>;

Record ReadRecord(const fs::path& folder) {
  std::istringstream in(ReadWholeFile((folder / kRecord).string(), kMaxListBytes));
  Record record;
  for (std::string line; std::getline(in, line);) record.insert(line);
  return record;
}

void WriteRecord(const Record& record, const OutputPath& folder) {
  WriteFileAtomically(folder / kRecord, [&](std::ostream& out) {
    out << kRecordHead;
    for (const std::string& line : record) out << line << '\n';
  });
}

// The lines of those model files that are limn's. Folders of earlier versions have no record, and
// text with a mark.
std::map<std::string, std::string> OwnFiles(const fs::path& folder) {
  const bool has_record = Exists(folder / kRecord) && IsFileOfLimn((folder / kRecord).string());
  const Record record = has_record ? ReadRecord(folder) : Record();
  std::map<std::string, std::string> own;
  for (const std::string& name : ModelFileNames()) {
    const std::string path = (folder / name).string();
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) continue;
    const std::string line = Line(name, FileIdentity(path));
    if (has_record ? record.contains(line) : IsFileOfLimn(path)) own.emplace(name, line);
  }
  return own;
}

// The lines of the files that a model will have.
std::map<std::string, std::string> NewFiles(const SparseModel& model) {
  std::map<std::string, std::string> files;
  for (const ModelFile& file : ModelFilesOf(model.flavor)) {
    if (file.is_of_rigs && model.rigs.empty()) continue;
    std::ostringstream bytes;
    file.write(model, bytes);
    files.emplace(file.name, Line(file.name, IdentityOfBytes(bytes.view())));
  }
  return files;
}

Record RecordOf(const std::map<std::string, std::string>& files) {
  Record record;
  for (const auto& [name, line] : files) record.insert(line);
  return record;
}

// Whatever the order and ids.
std::string NameOfCameras(const SparseModel& model) {
  std::map<std::string, const ModelImage*> images;
  for (const ModelImage& image : model.images) images.emplace(image.name, &image);
  ContentHash hash;
  for (const auto& [name, image] : images) {
    hash.AddText(name);
    for (const double value : image->cam_from_world.rotation.coeffs()) hash.AddNumber(value);
    for (const double value : image->cam_from_world.translation) hash.AddNumber(value);
    const Camera& camera = model.CameraOf(*image);
    hash.AddNumber(static_cast<int32_t>(camera.model));
    hash.AddNumber(camera.width);
    hash.AddNumber(camera.height);
    hash.AddNumbers(camera.params);
  }
  return hash.Hex();
}

}  // namespace

void CheckRefinedFolder(const OutputPath& folder, bool overwrite) {
  CheckResultFile(folder / kRecord, overwrite);
  const auto own = OwnFiles(folder.string());
  for (const std::string& name : ModelFileNames()) {
    const OutputPath path = folder / name;
    CheckTakesFile(path);
    if (overwrite || own.contains(name) || !Exists(path.string())) continue;
    throw IoError(path.string(),
                  "exists, and was not made by limn, or was changed since: --overwrite 1 replaces "
                  "it, --output_path writes elsewhere");
  }
}

std::string WriteRefinedFolder(const SparseModel& model, const OutputPath& folder) {
  if (model.flavor == ModelFlavor::kText) CheckTextNames(model);
  const std::map<std::string, std::string> files = NewFiles(model);
  const Record record = RecordOf(files);
  // Whenever the run is killed, old and new files are known.
  Record with_old = RecordOf(OwnFiles(folder.string()));
  with_old.insert(record.begin(), record.end());
  WriteRecord(with_old, folder);
  WriteModel(model, model.flavor, folder);
  for (const std::string& name : ModelFileNames()) {
    if (!files.contains(name)) RemoveFile(folder / name);
  }
  if (with_old != record) WriteRecord(record, folder);
  return NameOfRefinedCameras(folder.string());
}

bool RemoveRefinedFolder(const OutputPath& folder) {
  for (const auto& [name, line] : OwnFiles(folder.string())) RemoveFile(folder / name);
  for (const std::string& name : ModelFileNames()) {
    if (Exists((folder / name).string())) return false;
  }
  const std::string record = (folder / kRecord).string();
  if (Exists(record) && IsFileOfLimn(record)) RemoveFile(folder / kRecord);
  // Stays if it is not empty.
  const auto above = WritableFolder::Find(folder.Folder());
  if (above) above->RemoveEmptyFolder(folder.Name());
  return true;
}

std::string NameOfRefinedCameras(const fs::path& folder) {
  if (!HoldsColmapModel(folder)) return "";
  try {
    return NameOfCameras(ReadColmapModel(folder));
  } catch (const IoError&) {
    return "";
  }
}

std::string RefinedCamerasOf(const fs::path& result) {
  // The same drawing, in a format without a place for the name.
  if (result.filename() == "drawing.ply" || result.filename() == "drawing.obj") {
    return RefinedCamerasOf(result.parent_path() / "drawing.json");
  }
  return result.extension() == ".bin" ? RefinedCamerasOfSketch(result.string())
                                      : RefinedCamerasOfDrawing(result.string());
}

}  // namespace limn::colmap_ext
