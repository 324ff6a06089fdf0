// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/project.h"
#include "colmap_ext/host/run_options.h"
#include "colmap_ext/options/option_parser.h"

namespace limn::colmap_ext {

// What a command does with a project. An object is one call, with the values of its own options.
class Verb {
 public:
  Verb() = default;
  Verb(const Verb&) = delete;
  Verb& operator=(const Verb&) = delete;
  virtual ~Verb() = default;

  // The groups of options that it takes.
  virtual OptionGroups Groups() const = 0;
  // Declares its own options. May be called again.
  virtual void AddOptions(OptionParser*) {}
  // Declares those that name files, or say how they are written: of no use in memory.
  virtual void AddFileOptions(OptionParser*) {}
  // Before the scene is read: checks the options, and reads small files that they name. Throws
  // OptionError, InputError and IoError.
  virtual void Prepare(RunOptions*, Console*) {}
  // After that, which results it continues from (see LayoutOptions::starts_from).
  virtual std::vector<std::string> StartsFrom(const RunOptions&) const { return {}; }
  // Whether it writes a drawing into the output folder, whose page is then made anew (RenewPage).
  virtual bool WritesDrawing() const { return false; }
  // Checks the files to be written, works, and writes them. Throws what the work throws.
  virtual void Run(const Project& project, const RunOptions& options, Console* console) = 0;
};

}  // namespace limn::colmap_ext
