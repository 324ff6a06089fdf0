// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace limn::testing {

struct LimnRun {
  int exit_code = -1;
  std::string out;  // standard output
  std::string err;  // standard error
};

// How a program is run. 0 = no limit.
struct RunConditions {
  double interrupt_after_seconds = 0;  // send SIGINT then
  double max_seconds = 0;              // kill it then: exit code 137
  // Of address space; not under the address sanitizer, which reserves terabytes.
  int max_memory_mb = 0;
  // When the tests run as root, whom no file mode stops, as the user `nobody` instead.
  bool as_nobody = false;
};

// Run a program and wait for it. Its standard input is empty.
LimnRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                   const RunConditions& conditions = {});

// The same with the built `limn`.
LimnRun RunLimn(const std::vector<std::string>& arguments, const RunConditions& conditions = {});

// The contents of all files below a folder by their relative paths; empty if there is no such
// folder.
std::map<std::string, std::string> ReadTree(const std::filesystem::path& folder);

}  // namespace limn::testing
