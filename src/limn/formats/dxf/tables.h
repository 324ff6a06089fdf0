// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "limn/formats/dxf/dimensions.h"
#include "limn/formats/dxf/layers.h"
#include "limn/formats/dxf/layout.h"
#include "limn/formats/dxf/writer.h"

namespace limn {

struct DxfSpaces {
  DxfLayoutRecords records;
  // Handle of the one of all layers.
  int plot_style = 0;
  // Block records of the pictures of dimensions.
  std::vector<int> dimensions;
};

struct DxfDimensions {
  std::vector<DxfDimension> all;
  double text_height = 1;
};

// The section CLASSES: of the objects that are not in DXF itself.
void PutDxfClasses(DxfWriter* writer);

// Writes the section TABLES: the entries that AutoCAD requires, the layers, and a top view of all
// of `extent` (which may be empty), and the style of dimensions, if there are any. Uses handles
// from `*next_handle` on.
DxfSpaces PutDxfTables(const std::vector<DxfLayer>& layers, const Eigen::AlignedBox3d& extent,
                       const DxfDimensions& dimensions, int* next_handle, DxfWriter* writer);

// The sections BLOCKS and OBJECTS, with the empty blocks of the two spaces, the pictures of
// dimensions, the dictionaries that every file must have, and the layouts of the spaces.
void PutDxfBlocks(const DxfSpaces& spaces, const DxfDimensions& dimensions, int* next_handle,
                  DxfWriter* writer);
void PutDxfObjects(const DxfSpaces& spaces, const std::optional<DxfLayout>& layout,
                   const Eigen::AlignedBox3d& extent, int* next_handle, DxfWriter* writer);

}  // namespace limn
