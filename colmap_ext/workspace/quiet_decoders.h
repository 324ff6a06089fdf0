#pragma once

namespace limn::colmap_ext {

// Decoders of images print lines that name no file. A program that owns standard error may hide
// them: once, before images are read.
void HideLinesOfDecoders();

// While one of these exists after that, nothing that is printed to standard error is seen, but for
// lines of PrintErrorLine. For any number of threads at once.
class QuietDecoders {
 public:
  QuietDecoders();
  ~QuietDecoders();
  QuietDecoders(const QuietDecoders&) = delete;
  QuietDecoders& operator=(const QuietDecoders&) = delete;

 private:
  bool is_quiet_;
};

}  // namespace limn::colmap_ext
