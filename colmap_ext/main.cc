// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "colmap_ext/commands/commands.h"
#include "colmap_ext/host/interrupt.h"
#include "colmap_ext/host/prepare_process.h"
#include "colmap_ext/host/ranks.h"
#include "colmap_ext/host/terminal_console.h"
#include "colmap_ext/host/version_text.h"
#include "colmap_ext/options/command_help.h"
#include "limn/files/error_line.h"
#include "limn/files/quiet_decoders.h"
#include "limn/util/errors.h"
#include "limn/util/latest_stage.h"
#include "limn/util/nearest_word.h"
#include "limn/util/return_memory.h"

namespace {

using namespace limn::colmap_ext;

void PrintUsage() {
  std::printf(
      "limn: 3D drawings from COLMAP projects\n\n"
      "  limn automatic_drawer --workspace_path my_project\n"
      "  limn <command> -h          the basic options of a command, as limn help <command>\n"
      "  limn <command> --help_all  all of its options\n\nCommands:\n");
  for (const Command& command : Commands()) {
    std::printf("  %-20s %s\n", command.name, command.summary);
  }
}

// "help --help_format man" and the like: as OptionParser's, of the program.
void PrintUsageFor(std::string_view format) {
  std::vector<limn::CommandDescription> commands;
  for (const Command& command : Commands()) {
    commands.push_back({command.name, command.summary, {}});
  }
  if (format == "man") {
    WriteManPage(commands, std::cout);
  } else if (format == "words") {
    for (const auto& command : commands) std::cout << command.name << "\n";
  } else {
    throw limn::OptionError("help_format = " + std::string(format) + ": must be man or words");
  }
}

[[noreturn]] void FailUnknownCommand(std::string_view name) {
  std::vector<std::string> names;
  for (const Command& command : Commands()) names.push_back(command.name);
  throw limn::OptionError("unknown command '" + std::string(name) + "'" +
                          limn::DidYouMean(name, names) + "; 'limn help' lists the commands");
}

void PrintHelpOf(const char* name) {
  const Command* command = FindCommand(name);
  if (!command) FailUnknownCommand(name);
  const char* const arguments[] = {name, "-h"};
  command->Run(2, arguments, MakeTerminalConsole);
}

// Whether this was all that was asked for.
bool PrintHelp(int argc, const char* const* argv) {
  const std::string_view name = argc > 1 ? argv[1] : "help";
  if (name == "--version") {
    std::printf("%s\n", VersionText().c_str());
    return true;
  }
  if (name != "help" && name != "-h" && name != "--help") return false;
  if (argc == 4 && std::string_view(argv[2]) == "--help_format") {
    PrintUsageFor(argv[3]);
  } else if (argc == 3 && name == "help") {
    PrintHelpOf(argv[2]);
  } else {
    PrintUsage();
  }
  return true;
}

void PrintError(const std::exception& error) {
  limn::PrintErrorLine(std::string("ERROR: ") + error.what());
}

// Throws what the command throws.
int Run(int argc, const char* const* argv) {
  const std::string_view name = argv[1];
  const Command* command = FindCommand(name);
  if (NumRanks() > 1 && !(command && command->has_ranks)) {
    if (Rank() != 0) return 0;  // rank 0 says it
    throw limn::OptionError(std::string(name) +
                            ": only automatic_drawer runs in several MPI processes");
  }
  if (command) return command->Run(argc - 1, argv + 1, MakeTerminalConsole);
  FailUnknownCommand(name);
}

// The exit code.
int RunAndReport(int argc, const char* const* argv) {
  try {
    return Run(argc, argv);
  } catch (const limn::Cancelled&) {
    return kInterruptedExitCode;  // what is kept has been said
  } catch (const std::bad_alloc&) {
    limn::PrintErrorLine("ERROR: " + limn::OutOfMemoryText("--"));
    return 1;
  } catch (const std::system_error& error) {
    // No memory for another thread.
    const bool is_short = error.code() == std::errc::resource_unavailable_try_again;
    limn::PrintErrorLine("ERROR: " + (is_short ? limn::OutOfMemoryText("--") : error.what()));
    return 1;
  } catch (const std::exception& error) {
    PrintError(error);
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  PrepareProcess();
  limn::HideLinesOfDecoders();
  limn::KeepFreedMemory();
  try {
    if (PrintHelp(argc, argv)) return 0;
    const MpiSession mpi;
    const int exit_code = RunAndReport(argc, argv);
    if (exit_code != 0) AbortRanks(exit_code);
    return exit_code;
  } catch (const std::exception& error) {
    PrintError(error);
    return 1;
  }
}
