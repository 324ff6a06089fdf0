#pragma once

#include <vector>

namespace limn {

// A decoded photograph: interleaved rows of RGB or one gray channel, values in gray levels 0..255
// for any bit depth of the file. `mask` is empty or has one byte per pixel, 0 = do not use.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;  // 1 or 3
  std::vector<float> data;
  std::vector<unsigned char> mask;
};

}  // namespace limn
