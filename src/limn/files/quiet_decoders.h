// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Decoders of images print lines that name no file. A program that owns standard error may hide
// them: once, before images are read.
void HideLinesOfDecoders();

// While one of these exists after that, nothing printed to standard error is seen except the lines
// of PrintErrorLine. Any number of threads may hold one.
class QuietDecoders {
 public:
  QuietDecoders();
  ~QuietDecoders();
  QuietDecoders(const QuietDecoders&) = delete;
  QuietDecoders& operator=(const QuietDecoders&) = delete;

 private:
  bool is_quiet_;
};

}  // namespace limn
