// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "colmap_ext/model/model.h"
#include "colmap_ext/temp_dir.h"
#include "end_to_end/run_limn.h"

namespace limn::testing {

// A small valid project of its own: sparse/ with the model of tests/corpus/base in text, images/
// with links to six photographs of the sample scene.
class CorpusWorkspace {
 public:
  CorpusWorkspace();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  // The files of tests/corpus/<name>/, if there is such a folder, over those of the workspace.
  void Overlay(const std::string& name) const;

  // Work on a file of the workspace.
  void Write(const std::string& file, const std::string& content) const;
  std::string Read(const std::string& file) const;
  void Append(const std::string& file, const std::string& bytes) const;
  // Cut `bytes` off its end.
  void Cut(const std::string& file, size_t bytes) const;
  // Put `bytes` over what is at `offset`.
  void Poke(const std::string& file, size_t offset, const std::string& bytes) const;
  // The first occurrence; fails the test if there is none.
  void Replace(const std::string& file, const std::string& from, const std::string& to) const;
  void Remove(const std::string& file) const;
  // An image that is not a link any more.
  void ReplaceImage(const std::string& name, const std::string& content) const;

  colmap_ext::SparseModel Model() const;
  // Instead of the model in sparse/, in binary.
  void WriteBinary(const colmap_ext::SparseModel& model) const;
  void MakeBinary() const { WriteBinary(Model()); }
  // The same in text, also elsewhere.
  void WriteText(const colmap_ext::SparseModel& model, const std::string& folder = "sparse") const;

 private:
  TempDir dir_;
  std::filesystem::path path_;
};

// The bytes of a number.
template <typename T>
std::string Bytes(T value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof(T));
}

enum class Outcome {
  kRefused,  // exit code 1, one line on standard error, nothing written
  kAccepted  // exit code 0, nothing on standard error
};

// One bad input. Its name begins with "Case" and its number in tests/README.md (Bad files).
struct CorpusCase {
  std::string name;
  // Makes the good workspace bad, after the files of tests/corpus/<name>/ have been put into it.
  std::function<void(const CorpusWorkspace&)> spoil = nullptr;
  Outcome outcome = Outcome::kRefused;
  // All of these are in the error or on standard output.
  std::vector<std::string> said = {};
  std::string command = "edge_extractor";
  // "{W}" stands for the workspace.
  std::vector<std::string> arguments = {};
  bool as_nobody = false;  // see RunConditions
  // In the workspace; what --workspace_path names.
  std::string folder = ".";
  // Looks at what an accepted run has written.
  std::function<void(const CorpusWorkspace&)> check = nullptr;
};

// The cases with another command.
std::vector<CorpusCase> OfCommand(const std::string& command, std::vector<CorpusCase> cases);

// For messages of GoogleTest.
inline void PrintTo(const CorpusCase& bad, std::ostream* out) { *out << bad.name; }

inline std::string NameOf(const ::testing::TestParamInfo<CorpusCase>& info) {
  return info.param.name;
}

// Runs a case under a memory limit (2 GB) and a time-out (60 s).
class Corpus : public ::testing::TestWithParam<CorpusCase> {
 protected:
  void RunCase();

  CorpusWorkspace workspace_;
};

}  // namespace limn::testing
