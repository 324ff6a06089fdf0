// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/run_limn.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <sys/wait.h>
#include <unistd.h>

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

// What goes before the program on the shell's command line.
std::string Prefix(const RunConditions& conditions) {
  std::string prefix;
#ifndef __SANITIZE_ADDRESS__
  if (conditions.max_memory_mb > 0) {
    // One arena per core would use up the address space without using memory.
    prefix += "export MALLOC_ARENA_MAX=2; ulimit -v " +
              std::to_string(1024L * conditions.max_memory_mb) + "; ";
  }
#endif
  if (conditions.as_nobody && geteuid() == 0) {
    prefix += "setpriv --reuid=65534 --regid=65534 --clear-groups ";
  }
  if (conditions.max_seconds > 0) {
    prefix += "timeout --signal=KILL " + std::to_string(conditions.max_seconds) + " ";
  }
  if (conditions.interrupt_after_seconds > 0) {
    prefix += "timeout --preserve-status --signal=INT " +
              std::to_string(conditions.interrupt_after_seconds) + " ";
  }
  return prefix;
}

}  // namespace

LimnRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                   const RunConditions& conditions) {
  const TempDir dir;
  std::string command = Prefix(conditions) + Quoted(program);
  for (const std::string& argument : arguments) command += " " + Quoted(argument);
  command += " < /dev/null > " + Quoted(dir / "out") + " 2> " + Quoted(dir / "err");
  const int status = std::system(command.c_str());
  if (status == -1 || !WIFEXITED(status)) throw std::runtime_error("did not exit: " + command);
  return {WEXITSTATUS(status), ReadFile(dir / "out"), ReadFile(dir / "err")};
}

LimnRun RunLimn(const std::vector<std::string>& arguments, const RunConditions& conditions) {
  return RunProgram(LIMN_PROGRAM, arguments, conditions);
}

std::map<std::string, std::string> ReadTree(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::error_code is_link_loop;
    if (!entry.is_regular_file(is_link_loop)) continue;
    files[entry.path().lexically_relative(folder).generic_string()] = ReadFile(entry.path());
  }
  return files;
}

}  // namespace limn::testing
