#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "limn/formats/dxf/dimensions.h"
#include "limn/formats/dxf/layers.h"
#include "limn/formats/dxf/writer.h"

namespace limn {

// The block records that own the entities of model and paper space.
struct DxfSpaces {
  int model = 0;
  int paper = 0;
  // Of the pictures of dimensions.
  std::vector<int> dimensions;
};

struct DxfDimensions {
  std::vector<DxfDimension> all;
  double text_height = 1;
};

// Writes the section TABLES: the entries that AutoCAD requires, the layers, and a top view of all
// of `extent` (which may be empty), and the style of dimensions, if there are any. Uses handles
// from `*next_handle` on.
DxfSpaces PutDxfTables(const std::vector<DxfLayer>& layers, const Eigen::AlignedBox3d& extent,
                       const DxfDimensions& dimensions, int* next_handle, DxfWriter* writer);

// The sections BLOCKS and OBJECTS, with the empty blocks of the two spaces, the pictures of
// dimensions, and the dictionary that every file must have.
void PutDxfBlocks(const DxfSpaces& spaces, const DxfDimensions& dimensions, int* next_handle,
                  DxfWriter* writer);
void PutDxfObjects(int* next_handle, DxfWriter* writer);

}  // namespace limn
