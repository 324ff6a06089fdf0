// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/small_scene.h"

#include <gtest/gtest.h>

#include "end_to_end/run_limn.h"
#include "limn/files/atomic_file.h"

namespace limn::testing {

SmallScene::SmallScene(int num_images) {
  std::string names;
  for (int i = 0; i < num_images; ++i) names += "view_0" + std::to_string(i) + ".jpg\n";
  list_ = dir_.WriteFile("list.txt", names);
}

std::vector<std::string> SmallScene::Arguments(const std::vector<std::string>& more) const {
  std::vector<std::string> arguments = {"automatic_drawer",
                                        "--workspace_path",
                                        LIMN_SAMPLE_DIR "/day",
                                        "--output_path",
                                        output().string(),
                                        "--image_list_path",
                                        list_,
                                        "--quality",
                                        "low",
                                        "--max_image_size",
                                        "320",
                                        "--num_threads",
                                        "2"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::map<std::string, std::string> Results(const std::filesystem::path& folder) {
  auto files = ReadTree(folder);
  files.erase("drawing.html");
  return files;
}

std::map<std::string, std::string> ResultsOfRun(const std::filesystem::path& folder) {
  auto files = Results(folder);
  EXPECT_EQ(files.erase("curves/project.ini"), 1u);
  return files;
}

std::map<std::string, std::string> ResultsInOneGo() {
  const SmallScene scene;
  const LimnRun run = RunLimn(scene.Arguments());
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return ResultsOfRun(scene.output());
}

size_t NumBytes(const std::map<std::string, std::string>& files) {
  size_t count = 0;
  for (const auto& [name, bytes] : files) count += bytes.size();
  return count;
}

std::vector<std::string> WrongFiles(const std::filesystem::path& folder,
                                    const std::map<std::string, std::string>& whole_run,
                                    Leftovers allowed) {
  std::vector<std::string> wrong;
  for (const auto& [name, bytes] : ReadTree(folder)) {
    if (allowed != Leftovers::kNone && name == "curves/.lock") continue;
    // Of cameras that will be refined.
    if (allowed == Leftovers::kLockAndSketches && name.starts_with("curves/cache/sketch/"))
      continue;
    if (allowed == Leftovers::kAll && name.ends_with(kTemporarySuffix)) continue;
    if (name == "drawing.html") {
      if (!bytes.ends_with("</html>\n")) wrong.push_back(name);
      continue;
    }
    const auto expected = whole_run.find(name);
    if (expected == whole_run.end() || expected->second != bytes) wrong.push_back(name);
  }
  return wrong;
}

}  // namespace limn::testing
