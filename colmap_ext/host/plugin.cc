#include "colmap_ext/host/plugin.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <system_error>

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>

#include "limn/util/errors.h"
#include "limn/version.h"

namespace limn::colmap_ext {
namespace {

namespace dll = boost::dll;
namespace fs = std::filesystem;

constexpr int kMaxFoldersUp = 4;
constexpr char kPluginFolder[] = "lib/limn/plugins";

// Of this code: the program, or the Python module.
fs::path OwnFolder() {
  std::error_code error;
  // A program that was found by PATH is known by its name alone.
  fs::path file = dll::this_line_location(error);
  if (error || !file.is_absolute()) file = dll::program_location();
  const fs::path real = fs::canonical(file, error);
  return (error ? file : real).parent_path();
}

fs::path FindPlugin(const std::string& name) {
  const fs::path own = OwnFolder();
  fs::path folder = own;
  std::error_code ignored;
  for (int up = 0; up <= kMaxFoldersUp; ++up, folder = folder.parent_path()) {
    const fs::path file = folder / kPluginFolder / (name + ".so");
    if (fs::exists(file, ignored)) return file;
  }
  throw IoError((own / kPluginFolder / (name + ".so")).string(),
                "this part of Limn is not installed (looked there and in the folders above)");
}

dll::shared_library Open(const fs::path& file, dll::load_mode::type mode) {
  dll::shared_library library;
  try {
    library.load(file, mode);
  } catch (const std::system_error& error) {
    throw IoError(file.string(), std::string("cannot be loaded: ") + error.what());
  }
  const char* version = library.has("limn_plugin_version")
                            ? library.get<const char*()>("limn_plugin_version")()
                            : "unknown";
  if (std::string(version) != LIMN_VERSION) {
    throw IoError(file.string(), std::string("is of version ") + version +
                                     ", but this is limn " LIMN_VERSION ": install both alike");
  }
  return library;
}

const dll::shared_library& Plugin(const std::string& name, dll::load_mode::type mode) {
  static std::mutex mutex;
  // Never unloaded: threads that MPI has started may run until the end.
  static auto* loaded = new std::map<std::string, dll::shared_library>;
  const std::lock_guard lock(mutex);
  auto found = loaded->find(name);
  if (found == loaded->end()) found = loaded->emplace(name, Open(FindPlugin(name), mode)).first;
  return found->second;
}

}  // namespace

StepWriter LoadStepWriter() {
  const auto& library = Plugin("limn_step", dll::load_mode::rtld_now | dll::load_mode::rtld_local);
  return &library.get_alias<StepNotes(const DrawingGraph&, const StepOptions&, LengthUnit,
                                      std::ostream&)>("limn_write_step");
}

std::unique_ptr<MpiBackend> LoadMpi() {
  // Open MPI loads parts of its own, which look for its symbols among the global ones.
  const auto& library = Plugin("limn_mpi", dll::load_mode::rtld_now | dll::load_mode::rtld_global);
  return library.get_alias<std::unique_ptr<MpiBackend>()>("limn_make_mpi")();
}

}  // namespace limn::colmap_ext
