// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/dense_files/moved_files.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <functional>
#include <ostream>
#include <system_error>

#include "limn/files/atomic_file.h"
#include "limn/files/whole_file.h"
#include "limn/formats/ply_mover.h"
#include "limn/formats/ply_points_reader.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCloud = "fused.ply";
constexpr const char* kVisibility = "fused.ply.vis";

std::vector<std::string> MeshesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with("meshed-") && name.ends_with(".ply")) names.push_back(name);
  }
  std::ranges::sort(names);
  return names;
}

bool IsThere(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

// Writes a file of another one, which `write` reads. Returns what is wrong with that one; empty:
// nothing, and the file is written.
std::string WriteUnlessDamaged(const OutputPath& to,
                               const std::function<void(std::ostream&)>& write) {
  std::string damage;
  const auto note_damage = [&](std::ostream& out) {
    try {
      write(out);
    } catch (const IoError& error) {
      damage = error.what();
      throw;
    }
  };
  try {
    WriteFileAtomically(to, note_damage);
  } catch (const IoError&) {
    if (damage.empty()) throw;
  }
  return damage;
}

// The lists of a cloud with so many points.
void CopyVisibility(const std::string& path, uint64_t num_points, std::ostream& out) {
  std::ifstream in = OpenFile(path);
  uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof(count));
  if (!in) throw IoError(path, "the file ends too early");
  if (count != num_points) {
    throw IoError(
        path, std::to_string(count) + " points, but the cloud has " + std::to_string(num_points));
  }
  out.write(reinterpret_cast<const char*>(&count), sizeof(count));
  if (in.peek() != std::ifstream::traits_type::eof()) out << in.rdbuf();
}

}  // namespace

bool HasDenseFiles(const fs::path& folder) {
  return IsThere(folder / kCloud) || !MeshesIn(folder).empty();
}

MovedFiles MoveDenseFiles(const fs::path& from, const Similarity3d& similarity,
                          const std::string& comment, const OutputPath& to,
                          const RunContext& context) {
  MovedFiles result;
  const auto take = [&](const std::string& name, const std::function<void(std::ostream&)>& write) {
    ThrowIfCancelled(context);
    const std::string damage = WriteUnlessDamaged(to / name, write);
    (damage.empty() ? result.names : result.left_out).push_back(damage.empty() ? name : damage);
    return damage.empty();
  };
  const auto move = [&](const std::string& name) {
    return take(name, [&](std::ostream& out) {
      MovePly((from / name).string(), similarity, comment, out);
    });
  };
  if (IsThere(from / kCloud) && move(kCloud) && IsThere(from / kVisibility)) {
    take(kVisibility, [&](std::ostream& out) {
      const uint64_t num_points = ReadPlyPointsInfo((from / kCloud).string()).count;
      CopyVisibility((from / kVisibility).string(), num_points, out);
    });
  }
  for (const std::string& mesh : MeshesIn(from)) move(mesh);
  return result;
}

}  // namespace limn::colmap_ext
