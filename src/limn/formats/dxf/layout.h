// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "limn/formats/dxf/writer.h"

namespace limn {

// Of all that is in the paper space.
constexpr const char* kDxfSheetLayer = "sheet";

// A sheet of paper with a plan on it: the paper space of a DXF file, in millimeters.
struct DxfLayout {
  // Drawing units per millimeter of paper.
  double mm = 1;
  std::string title;
  // "1:50"; empty without a unit.
  std::string scale;
  // What the arrow upwards, along y of the plan, is called: "N" or an axis; empty: no arrow.
  std::string up_name;
};

// Handles of the block records of both spaces, and of their layouts.
struct DxfLayoutRecords {
  int model = 0;
  int paper = 0;
  int model_layout = 0;
  int paper_layout = 0;
};

// The entities of the paper space: border, a window with the plan at its scale, and below it title,
// scale and arrow. The paper is A3 across, or larger if the plan does not fit.
void PutPaperSpace(const DxfLayout& layout, const Eigen::AlignedBox3d& extent, int paper_space,
                   int* next_handle, DxfWriter* writer);

// The dictionary of layouts, with its two, for the section OBJECTS; `owner` is the root dictionary
// and `handle` the dictionary's own. `layout` is that of the paper space; without it, that is
// empty.
void PutDxfLayouts(const std::optional<DxfLayout>& layout, const Eigen::AlignedBox3d& extent,
                   const DxfLayoutRecords& records, int owner, int handle, DxfWriter* writer);

}  // namespace limn
