// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "colmap_ext/host/console.h"
#include "colmap_ext/verbs/drawing_verb.h"

namespace limn::colmap_ext {

// A row of the table of commands.
struct Command {
  const char* name;
  const char* summary;  // in the list of commands
  const char* heading;  // of its help
  // Parses the options, calls the verb and writes. `argv` begins with the name of the command;
  // output goes to the console that it makes. Returns the exit code. Exceptions are turned into one
  // line and exit code 1 by main.cc.
  int (*run)(const Command& command, int argc, const char* const* argv,
             const ConsoleMaker& make_console);
  // Of verbs that make a drawing of a drawing: the function of Python, which has no command line.
  const char* function = nullptr;
  std::unique_ptr<DrawingVerb> (*make_verb)() = nullptr;
  // Whether several MPI processes may share the work.
  bool has_ranks = false;

  int Run(int argc, const char* const* argv, const ConsoleMaker& make_console) const {
    return run(*this, argc, argv, make_console);
  }
};

}  // namespace limn::colmap_ext
