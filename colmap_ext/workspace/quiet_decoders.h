#pragma once

namespace limn::colmap_ext {

// While one of these exists, nothing that is printed to standard error is seen, but for lines of
// PrintErrorLine: decoders of images print lines that name no file. For any number of threads at
// once.
class QuietDecoders {
 public:
  QuietDecoders();
  ~QuietDecoders();
  QuietDecoders(const QuietDecoders&) = delete;
  QuietDecoders& operator=(const QuietDecoders&) = delete;
};

}  // namespace limn::colmap_ext
