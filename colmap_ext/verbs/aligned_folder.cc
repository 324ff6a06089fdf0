// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/verbs/aligned_folder.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/workspace/output_check.h"
#include "limn/files/temporary_path.h"
#include "limn/files/writable_folder.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

constexpr std::string_view kOwnFiles[] = {"drawing.json", "drawing.ply", "drawing.obj",
                                          "drawing.html", "fused.ply",   "fused.ply.vis",
                                          "offset.txt"};

bool IsOwnFile(const std::string& name) {
  return std::ranges::count(kOwnFiles, name) > 0 ||
         (name.starts_with("meshed-") && name.ends_with(".ply"));
}

bool IsModelFileName(const std::string& name) {
  const auto has_name = [&](const ModelFile& file) { return name == file.name; };
  return std::ranges::any_of(kBinaryModelFiles, has_name) ||
         std::ranges::any_of(kTextModelFiles, has_name);
}

bool HoldsOnlyModelFiles(const WritableFolder& folder) {
  return std::ranges::all_of(folder.Names(), [&](const std::string& name) {
    const auto status = folder.StatusOf(name);
    return !status || (status->kind == FileKind::kFile && IsModelFileName(name));
  });
}

// Also in the folders below, however deep.
bool HoldsOnlyLinks(const WritableFolder& folder) {
  return std::ranges::all_of(folder.Names(), [&](const std::string& name) {
    const auto status = folder.StatusOf(name);
    if (!status || status->kind == FileKind::kLink) return true;
    const auto inner = folder.Enter(name);
    return inner && HoldsOnlyLinks(*inner);
  });
}

// Whether an entry of the folder may be what limn has made there.
bool IsOwn(const WritableFolder& folder, const std::string& name) {
  const auto status = folder.StatusOf(name);
  if (!status) return true;  // it is gone
  if (status->kind == FileKind::kFile) return IsOwnFile(name);
  if (status->kind == FileKind::kLink) return name == "images";
  const auto inner = folder.Enter(name);
  if (!inner) return false;
  return (name == "sparse" && HoldsOnlyModelFiles(*inner)) ||
         (name == "images" && HoldsOnlyLinks(*inner));
}

}  // namespace

void CheckAlignedFolder(const OutputPath& folder, bool overwrite) {
  const auto found = WritableFolder::Find(folder);
  if (!found) return;
  const std::vector<std::string> names = found->Names();
  if (names.empty()) return;
  for (const std::string& name : names) {
    if (IsOwn(*found, name)) continue;
    throw IoError((folder / name).string(),
                  "was not made by drawing_aligner, which replaces the whole folder: move it away, "
                  "or choose another --output_path");
  }
  if (!IsFileOfLimn((folder / "drawing.json").string())) {
    throw IoError(folder.string(),
                  "exists, and was not made by limn: move it away, or choose another "
                  "--output_path");
  }
  if (overwrite) return;
  throw IoError(folder.string(),
                "exists: --overwrite 1 replaces it, --output_path writes elsewhere");
}

void WriteAlignedFolder(const OutputPath& folder, bool overwrite,
                        const std::function<void(const OutputPath&)>& fill) {
  TemporaryPath temporary(folder + kTemporarySuffix, &MakeEmptyFolder);
  fill(temporary.path());
  CheckAlignedFolder(folder, overwrite);  // again: that took a while
  const bool is_there = WritableFolder::Find(folder).has_value();
  const std::error_code error =
      is_there ? temporary.Replace(folder.Name()) : temporary.RenameTo(folder.Name());
  if (!error) return;
  throw IoError(folder.string(),
                "cannot rename " + temporary.path().string() + " to it: " + error.message());
}

}  // namespace limn::colmap_ext
