#pragma once

#include <string>

namespace limn::colmap_ext {

// While one of these exists, nothing that is printed to standard error is seen: decoders of images
// print lines that name no file. For any number of threads at once.
class QuietDecoders {
 public:
  QuietDecoders();
  ~QuietDecoders();
  QuietDecoders(const QuietDecoders&) = delete;
  QuietDecoders& operator=(const QuietDecoders&) = delete;
};

// Prints a line to standard error that is seen all the same.
void PrintErrorLine(const std::string& line);

}  // namespace limn::colmap_ext
