// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "limn/formats/dimension_lines.h"
#include "limn/formats/dxf/writer.h"

namespace limn {

// A dimension in a DXF file.
struct DxfDimension {
  DimensionLines lines;
  double length = 0;
  std::string text;
  int id = 0;
};

// "*D0", "*D1", ...: the name of the block with the picture of the dimension of this index.
std::string DimensionBlockName(size_t index);

// The content of such a block, which programs show: lines, oblique ticks and the text of this
// height. `owner` is the block's record. Uses handles from `*next_handle` on.
void PutDimensionPicture(const DxfDimension& dimension, double text_height, int owner,
                         int* next_handle, DxfWriter* writer);

// The entity: an aligned dimension, with its text, whose block is that of `index`.
void PutDimension(const DxfDimension& dimension, size_t index, double text_height, int owner,
                  int* next_handle, DxfWriter* writer);

}  // namespace limn
