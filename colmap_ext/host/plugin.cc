// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/plugin.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>

#include "colmap_ext/host/version_text.h"
#include "limn/util/errors.h"

namespace limn::colmap_ext {
namespace {

namespace dll = boost::dll;
namespace fs = std::filesystem;

struct PluginKind {
  const char* name;  // of its file, without .so
  const char* to_get_it;
};
constexpr PluginKind kStep = {
    "limn_step", "install the package limn-step, or build with OpenCASCADE (-DLIMN_WITH_STEP=ON)"};
constexpr PluginKind kMpi = {
    "limn_mpi", "install the package limn-mpi, or build with Boost.MPI (-DLIMN_WITH_MPI=ON)"};

// As seen from the program or the Python module.
constexpr const char* kPluginFolders[] = {
    "lib/limn/plugins",        // the program in a build folder; the module of a wheel
    "../lib/limn/plugins",     // an installed program
    "../../lib/limn/plugins",  // the module in a build folder, or in an archive
    "../../../limn/plugins",   // the module of a Debian package
};

// Of this code: the program, or the Python module. A program may know itself by the name alone that
// was found by PATH.
fs::path OwnFile() {
  std::error_code error;
  fs::path file = dll::this_line_location(error);
  if (error || file.extension() != ".so") file = dll::program_location();
  const fs::path real = fs::canonical(file, error);
  return error ? file : real;
}

// Whether nobody can have put it there but the owner of the program, the user, or root.
bool IsTrusted(const fs::path& path, const fs::path& own_file) {
  struct stat own = {}, status = {};
  if (stat(own_file.c_str(), &own) != 0 || stat(path.c_str(), &status) != 0) return false;
  const bool has_owner =
      status.st_uid == 0 || status.st_uid == own.st_uid || status.st_uid == geteuid();
  return has_owner && (status.st_mode & S_IWOTH) == 0;
}

fs::path FindPlugin(const PluginKind& kind) {
  const fs::path own = OwnFile();
  std::error_code ignored;
  for (const char* folder : kPluginFolders) {
    const fs::path file =
        (own.parent_path() / folder / (std::string(kind.name) + ".so")).lexically_normal();
    if (!fs::exists(file, ignored)) continue;
    if (IsTrusted(file, own) && IsTrusted(file.parent_path(), own)) return file;
    throw IoError(file.string(),
                  "is not loaded: others than its owner, you and root may have written it");
  }
  throw IoError(own.string(),
                std::string("has no part ") + kind.name + ".so beside it: " + kind.to_get_it);
}

dll::shared_library Open(const PluginKind& kind, dll::load_mode::type mode) {
  const fs::path file = FindPlugin(kind);
  dll::shared_library library;
  try {
    library.load(file, mode);
  } catch (const std::system_error& error) {
    throw IoError(file.string(),
                  std::string("cannot be loaded: ") + error.what() + "; " + kind.to_get_it);
  }
  const std::string build = library.has("limn_plugin_build")
                                ? library.get<const char*()>("limn_plugin_build")()
                                : "unknown";
  if (build == BuildId()) return library;
  throw IoError(file.string(),
                "is of build " + build + ", but this is " + BuildId() + ": " + kind.to_get_it);
}

const dll::shared_library& Plugin(const PluginKind& kind, dll::load_mode::type mode) {
  static std::mutex mutex;
  // Never unloaded: threads that MPI has started may run until the end.
  static auto* loaded = new std::map<std::string, dll::shared_library>;
  const std::lock_guard lock(mutex);
  auto found = loaded->find(kind.name);
  if (found == loaded->end()) found = loaded->emplace(kind.name, Open(kind, mode)).first;
  return found->second;
}

}  // namespace

StepFileWriter LoadStepWriter() {
  const auto& library = Plugin(kStep, dll::load_mode::rtld_now | dll::load_mode::rtld_local);
  return &library.get_alias<StepNotes(const DrawingGraph&, const StepOptions&, LengthUnit,
                                      std::ostream&)>("limn_write_step");
}

std::unique_ptr<MpiBackend> LoadMpi() {
  // Open MPI loads parts of its own, which look for its symbols among the global ones.
  const auto& library = Plugin(kMpi, dll::load_mode::rtld_now | dll::load_mode::rtld_global);
  return library.get_alias<std::unique_ptr<MpiBackend>()>("limn_make_mpi")();
}

}  // namespace limn::colmap_ext
