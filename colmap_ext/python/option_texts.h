// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "colmap_ext/host/run_options.h"

namespace limn::colmap_ext {

// Options by name ("max_image_size", "Drawing.method"), with their values as on the command line.
using OptionTexts = std::map<std::string, std::string>;

// Throws OptionError if one of these options is given: the commands have it, but it does not apply
// to `function`.
void RefuseOptions(const std::string& function, const OptionTexts& options,
                   std::initializer_list<const char*> unused);

// The options of both; those of `more` win.
OptionTexts Merged(OptionTexts texts, const OptionTexts& more);

// A command line. The texts of argv live as long as this.
class CommandLine {
 public:
  // Throws OptionError for names that cannot be options, for requests for help, and for texts with
  // NUL bytes.
  CommandLine(const std::string& command, const OptionTexts& options);
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  int argc() const { return static_cast<int>(argv_.size()); }
  const char* const* argv() const { return argv_.data(); }

 private:
  std::vector<std::string> arguments_;
  std::vector<const char*> argv_;
};

// The run options with the values in `texts`, as the command line would set them: ParseRunOptions.
// Throws OptionError.
RunOptions ParseTexts(const std::string& function, const OptionGroups& groups,
                      const OptionTexts& texts,
                      const std::function<void(OptionParser*)>& add_more = {});

}  // namespace limn::colmap_ext
