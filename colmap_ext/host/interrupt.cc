// SPDX-License-Identifier: BSD-3-Clause
#include "colmap_ext/host/interrupt.h"

#include <csignal>
#include <ctime>
#include <exception>
#include <utility>

#include <pthread.h>
#include <unistd.h>

#include "limn/files/error_line.h"
#include "limn/files/temporary_path.h"

namespace limn::colmap_ext {
namespace {

constexpr timespec kGrace = {.tv_sec = 1, .tv_nsec = 0};

bool IsIgnored(int signal) {
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t Signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&set, signal);
  if (!IsIgnored(SIGHUP)) sigaddset(&set, SIGHUP);
  return set;
}

// That of a write of this thread to a closed pipe: the write has failed, and that is enough.
void ForgetPipeSignal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGPIPE);
  const timespec now = {};
  sigtimedwait(&set, nullptr, &now);
}

}  // namespace

struct InterruptsBlocked::Before {
  sigset_t signals;
};

InterruptsBlocked::InterruptsBlocked() : before_(std::make_unique<Before>()) {
  const sigset_t signals = Signals();
  pthread_sigmask(SIG_BLOCK, &signals, &before_->signals);
}

InterruptsBlocked::~InterruptsBlocked() {
  pthread_sigmask(SIG_SETMASK, &before_->signals, nullptr);
}

std::string WhatIsWritten() {
  return NumRenamed() == 0 ? "Interrupted: nothing is written"
                           : "Interrupted: only some of the outputs are written";
}

InterruptWatch::InterruptWatch(std::function<std::string()> last_words)
    : last_words_(std::move(last_words)), exceptions_before_(std::uncaught_exceptions()) {
  // Blocked here and in all threads to come; the watching thread takes them one by one.
  const sigset_t signals = Signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  thread_ = std::thread([this] { Watch(); });
}

void InterruptWatch::Watch() {
  const sigset_t signals = Signals();
  int signal = 0;
  sigwait(&signals, &signal);
  if (over_) return;
  interrupted_ = true;
  sigtimedwait(&signals, nullptr, &kGrace);
  if (over_) return;
  AbandonWrites();  // before the words, so that they stay true
  SayLastWords();
  _exit(kInterruptedExitCode);
}

void InterruptWatch::Interrupt() {
  if (!interrupted_ && !is_sent_.exchange(true)) pthread_kill(thread_.native_handle(), SIGTERM);
}

void InterruptWatch::SayLastWords() {
  if (said_.exchange(true)) return;
  const std::string words = last_words_();
  if (!words.empty()) PrintErrorLine(words);
}

InterruptWatch::~InterruptWatch() {
  if (interrupted_ && std::uncaught_exceptions() > exceptions_before_) SayLastWords();
  over_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
  ForgetPipeSignal();
  const sigset_t signals = Signals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace limn::colmap_ext
