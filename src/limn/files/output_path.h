// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace limn {

// A file or folder to write. The user named the folder `named`: links in its path are followed.
// What is `below` it is Limn's own: no link there is followed (see WritableFolder).
class OutputPath {
 public:
  // The user named all of it. Only its last part must not be a link.
  template <typename Path>
  requires std::convertible_to<const Path&, std::filesystem::path> OutputPath(const Path& path)
      : OutputPath(Split(path)) {}  // NOLINT: as a path is
  OutputPath(std::filesystem::path named, std::filesystem::path below);

  OutputPath operator/(const std::filesystem::path& name) const { return {named_, below_ / name}; }
  // "a" + ".ply" is "a.ply".
  OutputPath operator+(std::string_view ending) const;

  std::filesystem::path named() const { return named_.empty() ? "." : named_; }
  const std::filesystem::path& below() const { return below_; }
  const std::string& string() const { return text_; }

  // The folder that it is in, and its name there. Precondition: something is below.
  OutputPath Folder() const { return {named_, below_.parent_path()}; }
  std::string Name() const { return below_.filename().string(); }

 private:
  explicit OutputPath(std::pair<std::filesystem::path, std::filesystem::path> parts)
      : OutputPath(std::move(parts.first), std::move(parts.second)) {}
  static std::pair<std::filesystem::path, std::filesystem::path> Split(
      const std::filesystem::path& path);

  std::filesystem::path named_;
  std::filesystem::path below_;
  std::string text_;
};

// Names of what is not complete yet end with it.
constexpr std::string_view kTemporarySuffix = ".limn-tmp";

}  // namespace limn
