#include "colmap_ext/workspace/output_check.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "colmap_ext/workspace/file_set.h"
#include "limn/files/atomic_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace fs = std::filesystem;

namespace {

// The generator of a .glb comes after the list of all its links.
constexpr size_t kSearchedBytes = 1 << 24;
// Most files tell it in their first lines.
constexpr size_t kFirstBytes = 1 << 12;
constexpr std::string_view kDrawingMark = "{\"format\": \"limn-drawing\"";

// What limn writes for users begins with `begin`, and `mark` follows.
struct Mark {
  std::string_view begin;
  std::string_view mark = "";
};

constexpr Mark kMarks[] = {
    {"limnfile"},  // results of stages
    {"{\"format\": \"limn-drawing\",\n"},
    {"ply\nformat binary_little_endian 1.0\ncomment 3D drawing by limn: "},
    {"ply\nformat binary_little_endian 1.0\ncomment curves by limn\n"},
    {"ply\nformat binary_little_endian 1.0\ncomment curve sketch by limn\n"},
    {"# 3D drawing by limn: "},                                         // .obj
    {"ISO-10303-21;\n", "'limn "},                                      // .step: the system
    {"glTF", "\"generator\":\"limn "},                                  // .glb
    {"0\nSECTION\n2\nHEADER\n", "\nAcDbRegAppTableRecord\n2\nLIMN\n"},  // .dxf
    {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg ", "<path id=\"link_"},
    {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml ",
     "<key id=\"link\" for=\"edge\" attr.name=\"link\""},
    {"<!doctype html>", "<title>Limn</title>"},
    {"tau,precision,recall,"},  // of drawing_evaluator
    {"{\n  \"unit\": ", "\"reconstructed_length\": "},
    {"# Curve tracks: links of drawing.json "},
    {"# EDGE_MAP v3.0\n\n# Format :  ", " by limn\n"},
    {".CEM v2.0\n# Curve fragments by limn\n"},
    {"view,not linked,"},  // account.csv
    {"image,moved px,"},   // cameras.csv
    {"workspace_path="},   // project.ini
    {"# Files of this model as limn wrote them"},
    {"# CAMERA_ID, MODEL,"},  // refined/, where COLMAP begins with other comments
    {"# IMAGE_ID, QW,"},
    {"# POINT3D_ID, X, Y, Z,"},
    {"# RIG_ID, NUM_SENSORS,"},
    {"# FRAME_ID, RIG_ID,"},
};

// Empty if the file cannot be read.
std::string BeginningOf(const std::string& path, size_t max_bytes = kSearchedBytes) {
  std::string bytes(max_bytes, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(in.gcount()));
  return bytes;
}

bool IsMadeByLimn(std::string_view beginning) {
  return std::any_of(std::begin(kMarks), std::end(kMarks), [&](const Mark& mark) {
    return beginning.starts_with(mark.begin) && beginning.find(mark.mark) != std::string_view::npos;
  });
}

bool IsModelFile(const fs::path& path) {
  const std::string stem = path.stem().string();
  const std::string extension = path.extension().string();
  constexpr std::string_view kStems[] = {"cameras", "images", "points3D", "rigs", "frames"};
  return (extension == ".bin" || extension == ".txt") &&
         std::find(std::begin(kStems), std::end(kStems), stem) != std::end(kStems);
}

bool IsEmptyButForLock(const fs::path& folder) {
  std::error_code ignored;
  const fs::directory_iterator entries(folder, ignored);
  return std::all_of(begin(entries), end(entries),
                     [](const auto& entry) { return entry.path().filename() == ".lock"; });
}

bool HoldsCache(const fs::path& cache_dir) {
  std::error_code ignored;
  return fs::is_directory(cache_dir / "fragments", ignored) ||
         fs::is_directory(cache_dir / "edges", ignored);
}

// As a folder of curves does when its cache is deleted.
bool HoldsResults(const fs::path& folder) {
  std::error_code ignored;
  const fs::directory_iterator entries(folder, ignored);
  return std::any_of(begin(entries), end(entries), [&](const auto& entry) {
    return entry.is_regular_file(ignored) &&
           IsMadeByLimn(BeginningOf(entry.path().string(), kFirstBytes));
  });
}

[[noreturn]] void RefuseToReplace(const std::string& path, const std::string& what) {
  throw IoError(path, what + ": --overwrite 1 replaces it");
}

}  // namespace

void CheckWritable(const fs::path& folder) {
  std::error_code error;
  fs::path existing = fs::absolute(folder);
  while (!fs::exists(fs::symlink_status(existing, error)) && existing.has_relative_path()) {
    existing = existing.parent_path();
  }
  std::string reason;
  if (!fs::is_directory(existing, error)) {
    reason = existing.string() + " is not a folder";
  } else if (access(existing.c_str(), W_OK | X_OK) != 0) {
    reason = existing.string() + ": " + std::strerror(errno);
  }
  if (reason.empty()) return;
  throw IoError(folder.string(),
                "results cannot be written here (" + reason + "): choose another --output_path");
}

void CheckLinkedCurves(const fs::path& curves_dir) {
  const fs::path cache_dir = curves_dir / "cache";
  for (const fs::path& folder : {curves_dir, cache_dir}) {
    std::error_code ignored;
    if (!fs::is_symlink(folder, ignored)) continue;
    if (IsEmptyButForLock(folder) || HoldsCache(cache_dir) || HoldsResults(folder)) continue;
    throw IoError(folder.string(), "is a link to " + fs::canonical(folder, ignored).string() +
                                       ", which holds other files than results of limn: link an "
                                       "empty folder, or choose another --output_path");
  }
}

bool IsFileOfLimn(const std::string& path) {
  return IsMadeByLimn(BeginningOf(path, kFirstBytes)) || IsMadeByLimn(BeginningOf(path));
}

void CheckResultFile(const std::string& path, bool overwrite) {
  CheckTakesFile(path);
  std::error_code ignored;
  if (overwrite || !fs::exists(path, ignored) || IsFileOfLimn(path)) return;
  RefuseToReplace(path, "exists, and was not made by limn");
}

void CheckNamedOutput(const std::string& path, const std::vector<std::string>& inputs,
                      bool overwrite) {
  CheckResultFile(path, overwrite);
  std::error_code ignored;
  if (overwrite || !fs::exists(path, ignored)) return;
  if (FileSet(inputs).Contains(path)) RefuseToReplace(path, "is an input");
  if (IsModelFile(path)) RefuseToReplace(path, "is a file of a model");
  if (BeginningOf(path).starts_with(kDrawingMark)) {
    RefuseToReplace(path, "is a drawing");
  }
}

}  // namespace limn::colmap_ext
