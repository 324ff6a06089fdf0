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

// Run a program and wait for it; send it SIGINT after some time if that is not 0.
LimnRun RunProgram(const std::string& program, const std::vector<std::string>& arguments,
                   double interrupt_after_seconds = 0);

// The same with the built `limn`.
LimnRun RunLimn(const std::vector<std::string>& arguments, double interrupt_after_seconds = 0);

// The contents of all files below a folder by their relative paths; empty if there is no such
// folder.
std::map<std::string, std::string> ReadTree(const std::filesystem::path& folder);

}  // namespace limn::testing
