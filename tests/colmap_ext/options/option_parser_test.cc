// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/options/option_parser.h"

#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "colmap_ext/temp_dir.h"
#include "limn/util/errors.h"

namespace limn {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

enum class Mode { kOriginal, kEnhanced };

struct Values {
  std::string path;
  std::string quality = "medium";
  Mode mode = Mode::kEnhanced;
  double length_px = 5.5;
  int count = -1;
  bool refine = true;
  std::vector<double> taus = {0.01, 2};
  std::vector<std::string> notes;
};

class OptionParserTest : public ::testing::Test {
 protected:
  OptionParserTest() : parser_("curve_drawer", "Draws curves.") {
    parser_.AddOption("path", &values_.path, BasicOption("A path."));
    parser_.AddOption("quality", &values_.quality, {"low", "medium", "high"}, "How well.");
    parser_.AddOption<Mode>("Sketch.mode", &values_.mode,
                            {{"original", Mode::kOriginal}, {"enhanced", Mode::kEnhanced}},
                            BasicOption("Which."));
    parser_.AddOption("Linking.length_px", &values_.length_px, "A length.");
    parser_.AddOption("Linking.count", &values_.count, "A count.");
    parser_.AddOption("Sketch.refine", &values_.refine, "Whether.");
    parser_.AddOption("taus", &values_.taus, "Several.");
    parser_.AddOption("notes", &values_.notes, "Texts.");
  }

  OptionParser::Outcome Parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "limn");
    const auto outcome = parser_.Parse(static_cast<int>(arguments.size()), arguments.data());
    if (outcome == OptionParser::Outcome::kHelp) parser_.WriteHelp(help_);
    return outcome;
  }
  std::string ErrorOf(const std::vector<const char*>& arguments) {
    const std::string error = ErrorText<OptionError>([&] { Parse(arguments); });
    EXPECT_EQ(error.find('\n'), std::string::npos);
    return error;
  }

  Values values_;
  OptionParser parser_;
  std::ostringstream help_;
  TempDir dir_;
};

TEST_F(OptionParserTest, NothingGivenKeepsTheDefaults) {
  EXPECT_EQ(Parse({}), OptionParser::Outcome::kRun);
  EXPECT_EQ(values_.length_px, 5.5);
  EXPECT_EQ(values_.mode, Mode::kEnhanced);
  EXPECT_FALSE(parser_.WasGiven("taus"));
}

TEST_F(OptionParserTest, EveryTypeIsSet) {
  Parse({"--path", "a b", "--quality", "high", "--Sketch.mode=original", "--Linking.length_px=1e-3",
         "--Linking.count", "-7", "--Sketch.refine", "0", "--taus", "1,2.5"});
  EXPECT_EQ(values_.path, "a b");
  EXPECT_EQ(values_.quality, "high");
  EXPECT_EQ(values_.mode, Mode::kOriginal);
  EXPECT_EQ(values_.length_px, 1e-3);
  EXPECT_EQ(values_.count, -7);
  EXPECT_FALSE(values_.refine);
  EXPECT_THAT(values_.taus, ElementsAre(1, 2.5));
  EXPECT_TRUE(parser_.WasGiven("taus"));
}

TEST_F(OptionParserTest, BoolsAreFourWords) {
  for (const char* text : {"1", "true"}) {
    values_.refine = false;
    Parse({"--Sketch.refine", text});
    EXPECT_TRUE(values_.refine) << text;
  }
  for (const char* text : {"0", "false"}) {
    Parse({"--Sketch.refine", text});
    EXPECT_FALSE(values_.refine) << text;
    values_.refine = true;
  }
}

TEST_F(OptionParserTest, NegativeNumbersAreValues) {
  Parse({"--Linking.length_px", "-2.5"});
  EXPECT_EQ(values_.length_px, -2.5);
}

TEST_F(OptionParserTest, BadValuesNameOptionAndValue) {
  EXPECT_EQ(ErrorOf({"--Linking.length_px", "long"}), "Linking.length_px = long: must be a number");
  EXPECT_EQ(ErrorOf({"--Linking.length_px", "nan"}), "Linking.length_px = nan: must be a number");
  EXPECT_EQ(ErrorOf({"--Linking.count", "1.5"}), "Linking.count = 1.5: must be a whole number");
  EXPECT_EQ(ErrorOf({"--Linking.count", "99999999999"}),
            "Linking.count = 99999999999: must be a whole number");
  EXPECT_EQ(ErrorOf({"--Sketch.refine", "yes"}),
            "Sketch.refine = yes: must be 0, 1, true or false");
  EXPECT_EQ(ErrorOf({"--Sketch.mode", "best"}),
            "Sketch.mode = best: must be one of {original, enhanced}");
  EXPECT_EQ(ErrorOf({"--quality", "ultra"}), "quality = ultra: must be one of {low, medium, high}");
  for (const char* text : {"1,", ",1", "1;2", "1,,2", "a"}) {
    EXPECT_THAT(ErrorOf({"--taus", text}), HasSubstr("must be numbers separated by commas"))
        << text;
  }
}

TEST_F(OptionParserTest, WrongUseIsOneLine) {
  EXPECT_THAT(ErrorOf({"--nonsense", "1"}), HasSubstr("--nonsense"));
  EXPECT_THAT(ErrorOf({"--qual", "high"}), HasSubstr("--qual"));  // no abbreviations
  EXPECT_THAT(ErrorOf({"--quality"}), HasSubstr("--quality"));
  EXPECT_THAT(ErrorOf({"stray"}), HasSubstr("stray"));
  EXPECT_THAT(ErrorOf({"--path", "a", "b"}), HasSubstr("'b'"));
  EXPECT_THAT(ErrorOf({"--path", "a", "--path", "b"}), HasSubstr("'--path' is given twice"));
}

TEST_F(OptionParserTest, HelpShowsTheBasicOptionsWithTheirDefaults) {
  for (const char* flag : {"-h", "--help"}) {
    help_.str("");
    EXPECT_EQ(Parse({flag}), OptionParser::Outcome::kHelp);
    EXPECT_THAT(help_.str(), AllOf(HasSubstr("curve_drawer"), HasSubstr("Draws curves.")));
    EXPECT_THAT(help_.str(), AllOf(HasSubstr("--path"), HasSubstr("--project_path")));
    EXPECT_THAT(help_.str(), AllOf(HasSubstr("--Sketch.mode arg (=enhanced)"),
                                   HasSubstr("{original, enhanced}")));
    for (const char* other : {"--Linking", "--Sketch.refine", "--taus", "--quality"}) {
      EXPECT_THAT(help_.str(), Not(HasSubstr(other)));
    }
    EXPECT_THAT(help_.str(), HasSubstr("6 more options: limn curve_drawer --help_all"));
  }
}

TEST_F(OptionParserTest, HelpShowsTheValuesOfItsCommandLine) {
  const std::string ini = dir_.WriteFile("project.ini", "path=from ini\n");
  const std::vector<const char*> arguments = {"-h", "--project_path", ini.c_str(), "--Sketch.mode",
                                              "original"};
  EXPECT_EQ(Parse(arguments), OptionParser::Outcome::kHelp);
  EXPECT_THAT(help_.str(), AllOf(HasSubstr("--path arg (=from ini)"),
                                 HasSubstr("--Sketch.mode arg (=original)")));
  EXPECT_THAT(ErrorOf({"-h", "--quality", "best"}), HasSubstr("must be one of {low,"));
}

TEST_F(OptionParserTest, HelpAllShowsEveryOptionWithItsDefault) {
  EXPECT_EQ(Parse({"--help_all"}), OptionParser::Outcome::kHelp);
  EXPECT_THAT(help_.str(), AllOf(HasSubstr("--path"), HasSubstr("--project_path"),
                                 HasSubstr("--Sketch.mode arg (=enhanced)")));
  EXPECT_THAT(help_.str(), AllOf(HasSubstr("--Linking.length_px arg (=5.5)"),
                                 HasSubstr("--Linking.count arg (=-1)")));
  EXPECT_THAT(help_.str(), AllOf(HasSubstr("--taus arg (=0.01,2)"), HasSubstr("--Sketch.refine"),
                                 HasSubstr("--quality arg (=medium)")));
  EXPECT_THAT(help_.str(), Not(HasSubstr("more options")));
}

TEST_F(OptionParserTest, HelpFormatTellsProgramsEveryOption) {
  EXPECT_EQ(Parse({"--help_format", "words"}), OptionParser::Outcome::kHelp);
  EXPECT_EQ(help_.str(),
            "-h\n--help_all\n--project_path <path>\n--path <text>\n--quality low medium high\n"
            "--Sketch.mode original enhanced\n--Linking.length_px <number>\n"
            "--Linking.count <integer>\n--Sketch.refine 0 1\n--taus <numbers>\n--notes <texts>\n");
  EXPECT_EQ(Parse({"--help_format", "man"}), OptionParser::Outcome::kHelp);
  EXPECT_THAT(help_.str(), HasSubstr("limn\\-curve_drawer \\- Draws curves."));
  EXPECT_EQ(ErrorOf({"--help_format", "html"}), "help_format = html: must be man or words");
}

TEST_F(OptionParserTest, IniFileSetsAndCommandLineOverrides) {
  const std::string ini = dir_.WriteFile(
      "project.ini", "path=from ini\n[Linking]\nlength_px=7\ncount=2\n[Sketch]\nmode=original\n");
  Parse({"--Linking.count", "3", "--project_path", ini.c_str()});
  EXPECT_EQ(values_.path, "from ini");
  EXPECT_EQ(values_.length_px, 7);
  EXPECT_EQ(values_.count, 3);
  EXPECT_EQ(values_.mode, Mode::kOriginal);
}

TEST_F(OptionParserTest, ErrorsInTheIniFileNameItsLine) {
  const auto error = [&](const std::string& text) {
    const std::string ini = dir_.WriteFile("project.ini", text);
    return ErrorOf({"--project_path", ini.c_str()});
  };
  EXPECT_THAT(error("\nnonsense=1\n"), HasSubstr("project.ini: line 2: unknown option 'nonsense'"));
  EXPECT_THAT(error("[Linking]\ncount=many\n"), HasSubstr("line 2: Linking.count = many"));
  EXPECT_THAT(error("path=a\npath=b\n"), HasSubstr("line 2: option 'path' is given twice"));
  EXPECT_THAT(ErrorText<IoError>([&] {
                Parse({"--project_path", "/nonexistent.ini"});
              }),
              HasSubstr("/nonexistent.ini"));
}

TEST_F(OptionParserTest, UnknownOptionsTellWhatIsMeant) {
  EXPECT_EQ(ErrorOf({"--qualty", "low"}), "unknown option '--qualty': did you mean quality?");
  EXPECT_EQ(ErrorOf({"--length_px=3"}),
            "unknown option '--length_px': did you mean Linking.length_px?");
  EXPECT_EQ(ErrorOf({"--nonsense=1"}), "unknown option '--nonsense'");
  EXPECT_EQ(ErrorOf({"--random_seed", "7"}),
            "unknown option '--random_seed': leave it out: nothing depends on chance");
}

TEST_F(OptionParserTest, WrittenIniFileRunsAgain) {
  Parse({"--path", "x=# y", "--Linking.length_px", "0.1", "--Linking.count", "12", "--Sketch.mode",
         "original", "--Sketch.refine", "false", "--taus", "0.3,1e-300", "--quality", "low"});
  const Values first = values_;
  const std::string ini = (dir_ / "project.ini").string();
  parser_.WriteIni(ini);
  values_ = Values();
  Parse({"--project_path", ini.c_str()});
  EXPECT_EQ(values_.path, first.path);
  EXPECT_EQ(values_.length_px, 0.1);
  EXPECT_EQ(values_.count, 12);
  EXPECT_EQ(values_.mode, Mode::kOriginal);
  EXPECT_FALSE(values_.refine);
  EXPECT_EQ(values_.taus, first.taus);
  EXPECT_EQ(values_.quality, "low");
}

TEST_F(OptionParserTest, IniFileHasUngroupedKeysFirstThenSections) {
  std::ostringstream out;
  parser_.WriteIni(out);
  EXPECT_EQ(out.str(),
            "path=\nquality=medium\ntaus=0.01,2\nnotes=\n"
            "[Sketch]\nmode=enhanced\nrefine=1\n"
            "[Linking]\nlength_px=5.5\ncount=-1\n");
}

TEST_F(OptionParserTest, UnwritableIniIsAnError) {
  std::ofstream(dir_ / "file") << "no folder";
  EXPECT_THROW(parser_.WriteIni((dir_ / "file" / "project.ini").string()), IoError);
}

TEST_F(OptionParserTest, DeclaringAnOptionTwiceIsAProgrammingError) {
  EXPECT_THROW(parser_.AddOption("taus", &values_.count, ""), std::logic_error);
  EXPECT_THROW(parser_.AddOption("project_path", &values_.path, ""), std::logic_error);
  EXPECT_THROW(parser_.AddOption("help_all", &values_.refine, ""), std::logic_error);
  EXPECT_THROW(parser_.AddOption("help_format", &values_.refine, ""), std::logic_error);
  EXPECT_THROW(parser_.AddOption("other", &values_.path, {"a", "b"}, ""), std::logic_error);
}

// Ini files lose it.
TEST_F(OptionParserTest, TextHasNoWhiteSpaceAtItsEnds) {
  for (const char* text : {" a", "a ", "\ta", " "}) {
    EXPECT_THAT(ErrorOf({"--path", text}), HasSubstr("without white space at its ends")) << text;
  }
  Parse({"--path", "a b/"});
  EXPECT_EQ(values_.path, "a b/");
}

TEST_F(OptionParserTest, ListsOfTextsMayBeGivenSeveralTimes) {
  Parse({"--notes", "a = 1; b", "--notes= c d ;; "});
  EXPECT_THAT(values_.notes, ElementsAre("a = 1", "b", "c d"));
  std::ostringstream ini;
  parser_.WriteIni(ini);
  EXPECT_THAT(ini.str(), HasSubstr("notes=a = 1; b; c d\n"));
  values_.notes.clear();
  Parse({"--project_path", dir_.WriteFile("notes.ini", ini.str()).c_str()});
  EXPECT_THAT(values_.notes, ElementsAre("a = 1", "b", "c d"));
}

}  // namespace
}  // namespace limn
