// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/corpus_case.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "colmap_ext/model/model_writer.h"
#include "colmap_ext/workspace/model_folder.h"
#include "limn/files/atomic_file.h"

namespace limn::testing {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace {

constexpr int kMaxMemoryMb = 2048;
constexpr double kMaxSeconds = 60;

fs::path CorpusFolder(const std::string& name) { return fs::path(LIMN_CORPUS_DIR) / name; }

}  // namespace

CorpusWorkspace::CorpusWorkspace() : path_(dir_ / "project") {
  fs::create_directories(path_ / "images");
  Overlay("base");
  for (const colmap_ext::ModelImage& image : Model().images) {
    const fs::path photo = fs::path(LIMN_SAMPLE_DIR) / "day" / "images" / image.name;
    fs::create_symlink(fs::canonical(photo), path_ / "images" / image.name);
  }
}

void CorpusWorkspace::Overlay(const std::string& name) const {
  if (!fs::is_directory(CorpusFolder(name))) return;
  fs::copy(CorpusFolder(name), path_,
           fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

void CorpusWorkspace::Write(const std::string& file, const std::string& content) const {
  fs::create_directories((path_ / file).parent_path());
  std::ofstream(path_ / file, std::ios::binary) << content;
}

std::string CorpusWorkspace::Read(const std::string& file) const {
  std::ifstream in(path_ / file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

void CorpusWorkspace::Append(const std::string& file, const std::string& bytes) const {
  Write(file, Read(file) + bytes);
}

void CorpusWorkspace::Cut(const std::string& file, size_t bytes) const {
  fs::resize_file(path_ / file, fs::file_size(path_ / file) - bytes);
}

void CorpusWorkspace::Poke(const std::string& file, size_t offset, const std::string& bytes) const {
  Write(file, Read(file).replace(offset, bytes.size(), bytes));
}

void CorpusWorkspace::Replace(const std::string& file, const std::string& from,
                              const std::string& to) const {
  std::string content = Read(file);
  const size_t at = content.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  Write(file, content.replace(at, from.size(), to));
}

void CorpusWorkspace::Remove(const std::string& file) const {
  EXPECT_TRUE(fs::remove(path_ / file)) << file;
}

void CorpusWorkspace::ReplaceImage(const std::string& name, const std::string& content) const {
  fs::remove(path_ / "images" / name);
  Write("images/" + name, content);
}

colmap_ext::SparseModel CorpusWorkspace::Model() const {
  return colmap_ext::ReadModel(path_ / "sparse");
}

void CorpusWorkspace::WriteBinary(const colmap_ext::SparseModel& model) const {
  fs::remove_all(path_ / "sparse");
  fs::create_directories(path_ / "sparse");
  colmap_ext::WriteModelBinary(model, path_ / "sparse");
}

void CorpusWorkspace::WriteText(const colmap_ext::SparseModel& model,
                                const std::string& folder) const {
  fs::remove_all(path_ / folder);
  fs::create_directories(path_ / folder);
  colmap_ext::WriteModelText(model, path_ / folder);
}

std::vector<CorpusCase> OfCommand(const std::string& command, std::vector<CorpusCase> cases) {
  for (CorpusCase& one : cases) one.command = command;
  return cases;
}

void Corpus::RunCase() {
  const CorpusCase& bad = GetParam();
  RunConditions conditions;
  conditions.max_memory_mb = kMaxMemoryMb;
  conditions.max_seconds = kMaxSeconds;
  conditions.as_nobody = bad.as_nobody;
  if (RunProgram("test", {"-x", LIMN_PROGRAM}, conditions).exit_code != 0) {
    GTEST_SKIP() << "the user nobody may not run " << LIMN_PROGRAM;
  }
  workspace_.Overlay(bad.name);
  if (bad.spoil) bad.spoil(workspace_);
  if (HasFatalFailure()) return;
  const auto before = ReadTree(workspace_.path());
  std::vector<std::string> arguments = {bad.command, "--workspace_path",
                                        (workspace_ / bad.folder).lexically_normal().string(),
                                        "--num_threads", "2"};
  if (bad.command != "drawing_evaluator") {
    arguments.insert(arguments.end(), {"--max_image_size", "160"});
  }
  for (std::string argument : bad.arguments) {
    if (argument.starts_with("{W}")) argument.replace(0, 3, workspace_.path().string());
    arguments.push_back(argument);
  }
  const LimnRun run = RunLimn(arguments, conditions);
  const std::string& text = bad.outcome == Outcome::kRefused ? run.err : run.out;
  for (const std::string& part : bad.said) EXPECT_THAT(text, HasSubstr(part));
  if (bad.outcome == Outcome::kAccepted) {
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
    for (const auto& [name, bytes] : ReadTree(workspace_.path())) {
      EXPECT_FALSE(name.ends_with(kTemporarySuffix)) << name;
    }
    if (bad.check) bad.check(workspace_);
    return;
  }
  EXPECT_EQ(run.exit_code, 1) << run.out;
  EXPECT_THAT(run.err, StartsWith("ERROR: "));
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  // Not EXPECT_EQ, which looks for differences of files line by line.
  EXPECT_TRUE(ReadTree(workspace_.path()) == before) << "files were written or changed";
}

}  // namespace limn::testing
