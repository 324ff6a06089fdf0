// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

#include "colmap_ext/options/command_help.h"
#include "limn/files/output_path.h"
#include "limn/util/option_help.h"

namespace limn {

// The options of a command in COLMAP's dialect:
//
//   --workspace_path my_project --Linking.min_length_px 8 --Belief.judge=0
//   --project_path file.ini     options from a file; the command line overrides it (unlike COLMAP)
//   -h, --help                  the basic options, with the values of this command line: defaults
//                               where it gives none, those of a --quality that it names
//   --help_all                  every option
//   --help_format man|words     the same for programs: a man page, or the words of completion
//
// Each option is bound to a variable, whose value at the time of AddOption is the default. Names
// cannot be abbreviated; an option may be given once, except lists of texts. Bools are 0, 1, true
// or false. Options of earlier versions may still be given by their former names, and those that
// are fixed now at their value (retired_options.h), if the command has options of their group.
class OptionParser {
 public:
  enum class Outcome { kRun, kHelp };

  // `command` and `summary` (one line) head the help text.
  OptionParser(std::string command, std::string summary);

  // The variable must outlive the parser. A name is `snake_case`, or `Group.snake_case` for an
  // option of an algorithm. An option is basic if its help says so (BasicOption).
  void AddOption(const std::string& name, double* value, const OptionHelp& help);
  void AddOption(const std::string& name, int* value, const OptionHelp& help);
  void AddOption(const std::string& name, bool* value, const OptionHelp& help);
  void AddOption(const std::string& name, std::string* value, const OptionHelp& help);
  // Numbers separated by commas.
  void AddOption(const std::string& name, std::vector<double>* value, const OptionHelp& help);
  // Texts separated by semicolons; the option may also be given several times.
  void AddOption(const std::string& name, std::vector<std::string>* value, const OptionHelp& help);
  // One of a list of words, which the help text shows.
  void AddOption(const std::string& name, std::string* value, std::vector<std::string> allowed,
                 const OptionHelp& help);
  // An enum, by the names of its values.
  template <typename Enum>
  void AddOption(const std::string& name, Enum* value,
                 const std::vector<std::pair<std::string, Enum>>& words, const OptionHelp& help);

  // Sets the variables. Throws OptionError (one line, naming option and value) for unknown,
  // repeated or incomplete options and bad values, IoError for an ini file that cannot be read. The
  // variables are unspecified after an exception. kHelp: a help text was asked for, for WriteHelp.
  Outcome Parse(int argc, const char* const* argv);

  // The text that was asked for (after Parse), with the current values of the variables.
  void WriteHelp(std::ostream& out) const;

  // Writes every option with its current value, readable with --project_path: first those without a
  // group, then a section per group. Writes to a temporary file and renames it. Throws IoError.
  void WriteIni(const OutputPath& path) const;
  void WriteIni(std::ostream& out) const;

  // All options with their current values, --project_path first.
  CommandDescription Describe() const;

  // A line about options that are fixed now and were given all the same (after Parse); empty if
  // none was.
  std::string NoteOnRetired() const;

  // Whether there is an option of this name.
  bool Knows(const std::string& name) const;
  // Whether an option was given on the command line or in the ini file (after Parse).
  bool WasGiven(const std::string& name) const;

 private:
  enum class HelpKind { kNone, kBasic, kAll, kManPage, kWords };

  struct Option {
    std::string name;
    OptionHelp help;
    std::string value;  // see OptionDescription
    std::vector<std::string> words;
    // Returns what the value must be, or an empty string on success.
    std::function<std::string(const std::string& text)> set;
    std::function<std::string()> get;
    bool repeats = false;
    bool given = false;
  };

  static HelpKind HelpKindOf(const std::string& name, const std::string& value);
  void Add(Option option);
  void AddWords(const std::string& name, const OptionHelp& help, std::vector<std::string> words,
                std::function<void(size_t)> set, std::function<size_t()> get);
  void PrintHelp(bool all, std::ostream& out) const;
  Option* Find(const std::string& name);
  bool HasGroupOf(const std::string& name) const;
  // Of an option that is not known: whether it is one that is fixed now. Throws OptionError if it
  // is given another value.
  bool TakesRetired(const std::string& name, const std::string& text, const std::string& origin);
  // `written`: with its dashes, if it had some.
  [[noreturn]] void FailUnknown(const std::string& written, const std::string& name,
                                const std::string& origin = "") const;
  void Set(const std::string& name, const std::string& text, const std::string& origin);
  void ReadIni(const std::string& path);

  std::string command_;
  std::string summary_;
  std::vector<Option> options_;       // in the order of the calls
  std::vector<std::string> retired_;  // given
  HelpKind help_ = HelpKind::kNone;
};

template <typename Enum>
void OptionParser::AddOption(const std::string& name, Enum* value,
                             const std::vector<std::pair<std::string, Enum>>& words,
                             const OptionHelp& help) {
  std::vector<std::string> texts;
  std::vector<Enum> values;
  for (const auto& [text, word_value] : words) {
    texts.push_back(text);
    values.push_back(word_value);
  }
  AddWords(
      name, help, std::move(texts), [value, values](size_t word) { *value = values[word]; },
      [value, values] {
        size_t word = 0;
        while (word < values.size() && values[word] != *value) ++word;
        return word;
      });
}

}  // namespace limn
