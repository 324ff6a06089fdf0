#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include "colmap_ext/host/run_options.h"

namespace limn::colmap_ext {

// Options by name ("max_image_size", "Drawing.method"), with their values as on the command line.
using OptionTexts = std::map<std::string, std::string>;

// Throws OptionError if one of these options is given: the commands have it, `function` has no use
// for it.
void RefuseOptions(const std::string& function, const OptionTexts& options,
                   std::initializer_list<const char*> unused);

// Those of `more` and the others of `texts`.
OptionTexts Merged(OptionTexts texts, const OptionTexts& more);

// A command line. The texts of argv live as long as this.
class CommandLine {
 public:
  // Throws OptionError if a name could be no option, or asks for help; or if a text has zero bytes.
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
