// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "colmap_ext/host/console.h"
#include "colmap_ext/host/interrupt.h"

namespace limn::colmap_ext {

// Prints a run on standard output: progress with the remaining time (one line that is rewritten on
// a terminal; otherwise a plain line every 10 %, at most one in 2 seconds), and a summary after
// every stage. Signals, and the end of who reads the output, end the run (see InterruptWatch) with
// a line that says what is kept.
class TerminalConsole : public Console {
 public:
  // At most one terminal console may exist at a time.
  explicit TerminalConsole(int num_threads, Printing printing = Printing::kStages);
  ~TerminalConsole() override;

  void ShowTable(const std::string& lines) override;

 private:
  void ShowLine(const std::string& line) override;
  void ShowStage(const RunLog::Stage& stage) override;
  // The line printed on interruption: what the run leaves behind.
  std::string WhatIsKept() const;
  void ShowProgress(const char* stage, size_t done, size_t total);
  void ClearProgressLine();
  // Also flushes. Returns whether it could be printed.
  bool Print(const std::string& text);
  void PrintLine(const std::string& line);

  Printing printing_;
  bool is_terminal_ = false;
  bool has_progress_line_ = false;
  std::string progress_stage_;
  size_t progress_done_ = 0;
  int progress_tenth_ = 0;
  Clock::time_point progress_start_;
  Clock::time_point last_shown_;
  // Declared last: its thread calls WhatIsKept().
  InterruptWatch interrupts_;
};

// The consoles of the command line.
std::unique_ptr<Console> MakeTerminalConsole(int num_threads, Printing printing);

}  // namespace limn::colmap_ext
