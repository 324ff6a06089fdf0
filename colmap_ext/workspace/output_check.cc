// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/workspace/output_check.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>

#include "colmap_ext/workspace/file_set.h"
#include "limn/files/atomic_file.h"
#include "limn/files/writable_folder.h"
#include "limn/pictures/picture.h"
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
    {"corner_f1,edge_iou,hss,"},
    {"{\n  \"unit\": ", "\"reconstructed_length\": "},
    {"{\n  \"unit\": ", "\"corner_f1\": "},
    {"# wireframe by limn\n"},  // .obj
    {"{\"format\": \"limn-wireframe\""},
    {"# Curve tracks: links of drawing.json "},
    {"# EDGE_MAP v3.0\n\n# Format :  ", " by limn\n"},
    {".CEM v2.0\n# Curve fragments by limn\n"},
    {"\x89PNG\r\n\x1a\n", kPngOfLimn},  // overlays
    {"view,not linked,"},               // account.csv
    {"image,moved px,"},                // cameras.csv
    {"workspace_path="},                // project.ini
    {"# Files of this model as limn wrote them"},
    {"# CAMERA_ID, MODEL,"},  // refined/, where COLMAP begins with other comments
    {"# IMAGE_ID, QW,"},
    {"# POINT3D_ID, X, Y, Z,"},
    {"# RIG_ID, NUM_SENSORS,"},
    {"# FRAME_ID, RIG_ID,"},
};

// Empty if the file cannot be read, or is a pipe, from which nothing may ever come.
std::string BeginningOf(const std::string& path, size_t max_bytes = kSearchedBytes) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return "";
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

[[noreturn]] void RefuseToReplace(const std::string& path, const std::string& what) {
  throw IoError(path, what + ": --overwrite 1 replaces it");
}

}  // namespace

void CheckWritable(const OutputPath& folder) {
  const WritableFolder nearest = WritableFolder::Nearest(folder);
  const std::error_code error = nearest.WhyNoFile();
  if (!error) return;
  throw IoError(folder.string(), "results cannot be written here (" + nearest.path() + ": " +
                                     error.message() + "): choose another --output_path");
}

bool IsFileOfLimn(const std::string& path) {
  return IsMadeByLimn(BeginningOf(path, kFirstBytes)) || IsMadeByLimn(BeginningOf(path));
}

void CheckResultFile(const OutputPath& path, bool overwrite) {
  CheckTakesFile(path);
  std::error_code ignored;
  if (overwrite || !fs::exists(path.string(), ignored) || IsFileOfLimn(path.string())) return;
  RefuseToReplace(path.string(), "exists, and was not made by limn");
}

void CheckNamedOutput(const OutputPath& output, const std::vector<std::string>& inputs,
                      bool overwrite) {
  CheckResultFile(output, overwrite);
  const std::string& path = output.string();
  std::error_code ignored;
  if (overwrite || !fs::exists(path, ignored)) return;
  if (FileSet(inputs).Contains(path)) RefuseToReplace(path, "is an input");
  if (IsModelFile(path)) RefuseToReplace(path, "is a file of a model");
  if (BeginningOf(path).starts_with(kDrawingMark)) {
    RefuseToReplace(path, "is a drawing");
  }
}

}  // namespace limn::colmap_ext
