// SPDX-License-Identifier: BSD-3-Clause
// Runs that are stopped at many moments, and what the next run makes of it. LIMN_STOPS=100 for more
// moments than the few of the test.
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "end_to_end/limn_process.h"
#include "end_to_end/small_scene.h"

namespace limn::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::StartsWith;

int NumStops(int otherwise) {
  const char* text = std::getenv("LIMN_STOPS");
  return text ? std::atoi(text) : otherwise;
}

// What a run that nobody disturbs writes, and how long it takes.
struct WholeRun {
  std::map<std::string, std::string> files;
  double seconds = 0;
};

WholeRun RunUndisturbed(const std::vector<std::string>& arguments, const fs::path& output) {
  const LimnProcess::End end = LimnProcess(arguments).Wait();
  EXPECT_EQ(end.exit_code, 0) << end.err;
  WholeRun whole{Results(output), end.seconds};
  EXPECT_GT(whole.files.size(), 10u);
  fs::remove_all(output);
  return whole;
}

void Sleep(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

// Signals a run this many seconds after it has taken the lock, when it handles signals.
LimnProcess::End StopAfter(double seconds, int signal, const std::vector<std::string>& arguments,
                           const fs::path& output) {
  const fs::path lock = output / "curves/.lock";
  fs::remove(lock);
  LimnProcess run(arguments);
  run.WaitUntil([&] { return fs::exists(lock); });
  Sleep(seconds);
  run.Signal(signal);
  const LimnProcess::End end = run.Wait();
  EXPECT_LT(end.seconds, 2) << "after " << seconds << " s";
  return end;
}

void ExpectInterrupted(const LimnProcess::End& end) {
  EXPECT_EQ(end.exit_code, 130) << end.err;
  EXPECT_THAT(end.err, StartsWith("Interrupted: "));
  EXPECT_EQ(std::count(end.err.begin(), end.err.end(), '\n'), 1) << end.err;
}

// SIGINT and SIGTERM in turn, at moments that are spread over the duration of the run.
void ExpectInterruptsToStop(const std::vector<std::string>& arguments, const fs::path& output,
                            int num_stops, Leftovers allowed = Leftovers::kLock) {
  const WholeRun whole = RunUndisturbed(arguments, output);
  int num_interrupted = 0, num_told = 0;
  double longest = 0;
  for (int i = 0; i < num_stops; ++i) {
    const LimnProcess::End end =
        StopAfter(whole.seconds * i / num_stops, i % 2 == 0 ? SIGINT : SIGTERM, arguments, output);
    longest = std::max(longest, end.seconds);
    EXPECT_THAT(WrongFiles(output, whole.files, allowed), IsEmpty())
        << "stop " << i << " " << end.err;
    if (end.exit_code == 0) {  // it had ended
      fs::remove_all(output);
      continue;
    }
    ExpectInterrupted(end);
    if (end.err.find("are kept in " + (output / "curves/cache").string()) != std::string::npos) {
      ++num_told;
    }
    ++num_interrupted;
    // Every third one continues where the last one was stopped, which makes it shorter.
    if (i % 3 != 0) fs::remove_all(output);
  }
  std::printf("%d of %d runs of %.1f s were interrupted, the longest stop took %.2f s\n",
              num_interrupted, num_stops, whole.seconds, longest);
  // A busy machine is not even: some have ended before.
  EXPECT_GE(4 * num_interrupted, num_stops);
  EXPECT_GE(2 * num_told, num_interrupted);
  const LimnProcess::End last = LimnProcess(arguments).Wait();
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(Results(output).size(), whole.files.size());
  EXPECT_THAT(WrongFiles(output, whole.files, Leftovers::kNone), IsEmpty());
}

TEST(StoppedRun, InterruptsStopItSoonAndItGoesOn) {
  const SmallScene scene;
  ExpectInterruptsToStop(scene.Arguments(), scene.output(), NumStops(5));
}

// Default options: single views and single steps that take seconds.
TEST(StoppedRun, InterruptsStopTheWholeSampleSceneSoon) {
  const TempDir dir;
  ExpectInterruptsToStop({"automatic_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day",
                          "--output_path", (dir / "out").string()},
                         dir / "out", NumStops(3));
}

TEST(StoppedRun, InterruptsStopTheRefinementOfCamerasSoon) {
  const TempDir dir;
  ExpectInterruptsToStop(
      {"automatic_drawer", "--workspace_path", LIMN_SAMPLE_DIR "/day", "--quality", "low",
       "--refine_cameras", "1", "--output_path", (dir / "out").string()},
      dir / "out", NumStops(3), Leftovers::kLockAndSketches);
}

// As many rounds as there may be: nobody waits for their end.
TEST(StoppedRun, InterruptsStopManyRoundsOfRefinementSoon) {
  const TempDir dir;
  const fs::path output = dir / "out";
  const std::vector<std::string> project = {"--workspace_path", LIMN_SAMPLE_DIR "/day",
                                            "--output_path", output.string()};
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), project.begin(), project.end());
    return arguments;
  };
  const LimnProcess::End drawn =
      LimnProcess(run({"automatic_drawer", "--quality", "low", "--DrawingRefinement.num_rounds",
                       "0", "--page", "0"}))
          .Wait();
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  const auto before = Results(output);
  const std::vector<std::string> refiner =
      run({"drawing_refiner", "--quality", "low", "--DrawingRefinement.num_rounds", "100"});
  for (int i = 0; i < NumStops(5); ++i) {
    const LimnProcess::End end = StopAfter(0.2 + 2 * i, SIGINT, refiner, output);
    ExpectInterrupted(end);
    EXPECT_THAT(WrongFiles(output, before, Leftovers::kLock), IsEmpty()) << end.err;
    EXPECT_GE(Results(output).size(), before.size());
  }
}

// Whether a process blocks SIGINT, to take it by a thread of its own.
bool Listens(pid_t pid) {
  std::ifstream status("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (!line.starts_with("SigBlk:")) continue;
    return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  }
  return false;
}

// Interrupts a run twice, which leaves it no time, as soon as it listens.
LimnProcess::End StopAtOnce(const std::vector<std::string>& arguments) {
  LimnProcess run(arguments);
  for (int i = 0; i < 10000 && !Listens(run.pid()); ++i) Sleep(0.001);
  run.Signal(SIGINT);
  run.Signal(SIGTERM);
  return run.Wait();
}

// No project, so no lock and no cache.
TEST(StoppedRun, InterruptsStopAnEvaluationSoon) {
  const TempDir dir;
  const std::string curve = dir.WriteFile("curve.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n");
  const fs::path table = dir / "table.csv";
  const LimnProcess::End end =
      StopAtOnce({"drawing_evaluator", "--input_path", curve, "--truth_path", curve, "--taus",
                  "2e-6", "--output_csv", table.string()});
  EXPECT_LT(end.seconds, 2);
  ExpectInterrupted(end);
  EXPECT_FALSE(fs::exists(table));
}

// While it reads.
TEST(StoppedRun, InterruptsStopAnExportSoon) {
  const TempDir dir;
  const std::string drawing = dir.WriteFile("drawing.json", std::string(size_t{1} << 27, ' '));
  const fs::path picture = dir / "drawing.obj";
  const LimnProcess::End end =
      StopAtOnce({"drawing_exporter", "--input_path", drawing, "--output_path", picture.string()});
  EXPECT_LT(end.seconds, 2);
  ExpectInterrupted(end);
  EXPECT_FALSE(fs::exists(picture));
}

TEST(StoppedRun, KillsLeaveNothingHalfWrittenAndItGoesOn) {
  const SmallScene scene;
  const WholeRun whole = RunUndisturbed(scene.Arguments(), scene.output());
  std::mt19937 random(1);
  const int num_stops = NumStops(8);
  int num_killed = 0;
  for (int i = 0; i < num_stops; ++i) {
    LimnProcess run(scene.Arguments());
    Sleep(std::uniform_real_distribution<>(0, whole.seconds)(random));
    run.Signal(SIGKILL);
    const LimnProcess::End end = run.Wait();
    EXPECT_THAT(WrongFiles(scene.output(), whole.files, Leftovers::kAll), IsEmpty())
        << "kill " << i;
    if (end.exit_code == 0) {
      EXPECT_THAT(WrongFiles(scene.output(), whole.files, Leftovers::kNone), IsEmpty())
          << "kill " << i;
      EXPECT_EQ(Results(scene.output()).size(), whole.files.size());
      fs::remove_all(scene.output());
      continue;
    }
    EXPECT_EQ(end.exit_code, 128 + SIGKILL) << end.err;
    ++num_killed;
    if (random() % 3 != 0) fs::remove_all(scene.output());
  }
  std::printf("%d of %d runs of %.1f s were killed\n", num_killed, num_stops, whole.seconds);
  EXPECT_GE(4 * num_killed, num_stops);
  const LimnProcess::End last = LimnProcess(scene.Arguments()).Wait();
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(Results(scene.output()).size(), whole.files.size());
  EXPECT_THAT(WrongFiles(scene.output(), whole.files, Leftovers::kNone), IsEmpty());
}

}  // namespace
}  // namespace limn::testing
