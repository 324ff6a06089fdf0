// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/drawing_input.h"

#include <system_error>
#include <vector>

#include "colmap_ext/verbs/limap_model.h"
#include "limn/cache/content_hash.h"
#include "limn/files/whole_file.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDrawing = "drawing.json";

std::vector<std::string> NamesOf(DrawingChoice choice) {
  if (choice == DrawingChoice::kUnfused) return {kDrawing};
  return {kFusedDrawing, kDrawing};
}

std::string FirstDrawing(const std::vector<fs::path>& folders, DrawingChoice choice,
                         const std::string& path_option) {
  std::string looked_in;
  for (const fs::path& folder : folders) {
    const fs::path found = NewestFile(folder, NamesOf(choice));
    if (!found.empty()) return found.string();
    looked_in += (looked_in.empty() ? "" : " and ") + folder.string();
  }
  const std::string fused =
      choice == DrawingChoice::kNewest ? std::string(" or ") + kFusedDrawing : "";
  throw IoError(folders.front().string(), "no " + (kDrawing + fused) + " (looked in " + looked_in +
                                              "): draw one first, or name one with --" +
                                              path_option);
}

bool IsMereFolderOfResults(const LayoutOptions& workspace) {
  return workspace.model_index < 0 && workspace.input_path.empty() &&
         workspace.image_path.empty() && !HoldsSomeModel(workspace.workspace_path);
}

}  // namespace

std::vector<std::string> DrawingsToStartFrom(DrawingChoice choice, const std::string& path) {
  if (path.empty()) return NamesOf(choice);
  return {fs::absolute(path).string()};
}

std::string FindDrawing(const fs::path& folder, DrawingChoice choice,
                        const std::string& path_option) {
  return FirstDrawing({folder}, choice, path_option);
}

std::string FindDrawing(const LayoutOptions& workspace, DrawingChoice choice,
                        const std::string& path_option) {
  const fs::path folder = workspace.workspace_path;
  if (std::error_code ignored; !fs::is_directory(folder, ignored)) {
    throw IoError(folder.string(), "no such folder (workspace_path)");
  }
  if (IsMereFolderOfResults(workspace)) return FindDrawing(folder, choice, path_option);
  std::vector<fs::path> folders = {ResolveLayout(workspace).output.drawing_dir};
  if (folders.front() != folder) folders.push_back(folder);
  return FirstDrawing(folders, choice, path_option);
}

std::string FingerprintOf(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return "";
  std::ifstream file = OpenFile(path);
  ContentHash hash;
  std::vector<char> block(1 << 20);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    hash.Add({block.data(), static_cast<size_t>(file.gcount())});
  }
  return hash.Hex();
}

DrawingFile ReadDrawing(const std::string& path, const std::vector<std::string>& view_names) {
  std::error_code ignored;
  return fs::is_directory(path, ignored) ? ReadLimapDrawing(path, view_names)
                                         : ReadDrawingJson(path);
}

const Alignment& RequireAlignment(const std::string& path, const DrawingMetadata& metadata) {
  if (metadata.alignment) return *metadata.alignment;
  throw IoError(path, "has no alignment: run drawing_aligner, or draw with --align auto");
}

}  // namespace limn::colmap_ext
