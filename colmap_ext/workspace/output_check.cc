#include "colmap_ext/workspace/output_check.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "limn/formats/atomic_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {

namespace fs = std::filesystem;

namespace {

// The generator of a .glb comes after the list of all its links.
constexpr size_t kSearchedBytes = 1 << 24;
constexpr std::string_view kDrawingMark = "\"format\": \"limn-drawing\"";

// One of them is near the beginning of every file that limn writes for users.
constexpr std::string_view kMarks[] = {
    "limn",                  // drawings, curves, sketches: .json, .ply, .obj, .step, .glb
    "Limn",                  // drawing.html
    "LIMN",                  // .dxf
    "path id=\"link_",       // .svg
    "attr.name=\"link\"",    // .graphml
    "tau,precision,recall",  // tables of drawing_evaluator
    "\"reconstructed_length\"",
    "# Curve tracks: links",  // tracks.txt
    "view,not linked,",       // account.csv
    "workspace_path=",        // project.ini
    "# CAMERA_ID, MODEL,",    // refined/, where COLMAP writes other comments
    "# IMAGE_ID, QW,",
    "# POINT3D_ID, X, Y,",
};

// Empty if the file cannot be read.
std::string BeginningOf(const std::string& path) {
  std::string bytes(kSearchedBytes, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(in.gcount()));
  return bytes;
}

bool IsMadeByLimn(std::string_view beginning) {
  return std::any_of(std::begin(kMarks), std::end(kMarks), [&](std::string_view mark) {
    return beginning.find(mark) != std::string_view::npos;
  });
}

bool IsModelFile(const fs::path& path) {
  const std::string stem = path.stem().string();
  const std::string extension = path.extension().string();
  constexpr std::string_view kStems[] = {"cameras", "images", "points3D", "rigs", "frames"};
  return (extension == ".bin" || extension == ".txt") &&
         std::find(std::begin(kStems), std::end(kStems), stem) != std::end(kStems);
}

bool IsOneOf(const std::string& path, const std::vector<std::string>& inputs) {
  return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
    std::error_code ignored;
    return fs::equivalent(path, input, ignored);
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
    reason = existing.string() + " is no folder";
  } else if (access(existing.c_str(), W_OK | X_OK) != 0) {
    reason = existing.string() + ": " + std::strerror(errno);
  }
  if (reason.empty()) return;
  throw IoError(folder.string(),
                "results cannot be written here (" + reason + "): choose another --output_path");
}

void CheckResultFile(const std::string& path, bool overwrite) {
  CheckTakesFile(path);
  std::error_code ignored;
  if (overwrite || !fs::exists(path, ignored) || IsMadeByLimn(BeginningOf(path))) return;
  RefuseToReplace(path, "exists, and was not made by limn");
}

void CheckNamedOutput(const std::string& path, const std::vector<std::string>& inputs,
                      bool overwrite) {
  CheckResultFile(path, overwrite);
  std::error_code ignored;
  if (overwrite || !fs::exists(path, ignored)) return;
  if (IsOneOf(path, inputs)) RefuseToReplace(path, "is an input");
  if (IsModelFile(path)) RefuseToReplace(path, "is a file of a model");
  if (BeginningOf(path).find(kDrawingMark) != std::string::npos) {
    RefuseToReplace(path, "is a drawing");
  }
}

}  // namespace limn::colmap_ext
