#include "end_to_end/run_limn.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <sys/wait.h>

#include "colmap_ext/temp_dir.h"

namespace limn::testing {
namespace {

std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

std::string ReadFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

}  // namespace

LimnRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                   double interrupt_after_seconds) {
  const TempDir dir;
  std::string command;
  if (interrupt_after_seconds > 0) {
    command =
        "timeout --preserve-status --signal=INT " + std::to_string(interrupt_after_seconds) + " ";
  }
  command += Quoted(program);
  for (const std::string& argument : arguments) command += " " + Quoted(argument);
  command += " > " + Quoted(dir / "out") + " 2> " + Quoted(dir / "err");
  const int status = std::system(command.c_str());
  if (status == -1 || !WIFEXITED(status)) throw std::runtime_error("did not exit: " + command);
  return {WEXITSTATUS(status), ReadFile(dir / "out"), ReadFile(dir / "err")};
}

LimnRun RunLimn(const std::vector<std::string>& arguments, double interrupt_after_seconds) {
  return RunProgram(LIMN_PROGRAM, arguments, interrupt_after_seconds);
}

std::map<std::string, std::string> ReadTree(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[entry.path().lexically_relative(folder).generic_string()] = ReadFile(entry.path());
  }
  return files;
}

}  // namespace limn::testing
