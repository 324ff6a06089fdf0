// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/limn_process.h"

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace limn::testing {
namespace {

std::string ReadFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

LimnProcess::LimnProcess(const std::vector<std::string>& arguments) {
  std::vector<char*> argv = {const_cast<char*>(LIMN_PROGRAM)};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, 1, (dir_ / "out").c_str(), flags, 0666);
  posix_spawn_file_actions_addopen(&files, 2, (dir_ / "err").c_str(), flags, 0666);
  const int error = posix_spawn(&pid_, LIMN_PROGRAM, &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("cannot run " LIMN_PROGRAM);
}

LimnProcess::~LimnProcess() {
  if (pid_ < 0) return;
  Signal(SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void LimnProcess::Signal(int signal) const { kill(pid_, signal); }

void LimnProcess::WaitUntil(const std::function<bool()>& condition) const {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    siginfo_t ended = {};
    waitid(P_PID, pid_, &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid != 0) {
      ADD_FAILURE() << "the process has ended: " << ReadFile(dir_ / "err");
      return;
    }
    if (std::chrono::steady_clock::now() > deadline) {
      ADD_FAILURE() << "still waiting after a minute";
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

LimnProcess::End LimnProcess::Wait() {
  const auto start = std::chrono::steady_clock::now();
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  End end;
  end.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  end.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  end.out = ReadFile(dir_ / "out");
  end.err = ReadFile(dir_ / "err");
  return end;
}

}  // namespace limn::testing
