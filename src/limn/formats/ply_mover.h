// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include "limn/geometry/similarity3.h"

namespace limn {

// Copies a PLY file of any size, ascii or binary of either byte order, with its vertices moved: x,
// y, z of element vertex by the similarity, nx, ny, nz by its rotation, each in double precision
// and then rounded to the type of the file. All else stays to the byte, except for the header,
// which gets `comment` as a line unless that is empty. Reads and writes as it goes.
//
// Throws IoError with line or byte: no element vertex, one with a list, coordinates that are
// missing, integers, not finite, or too large once moved, and a file that is shorter than its
// header says. What has been written until then is of no use.
void MovePly(const std::string& path, const Similarity3d& similarity, const std::string& comment,
             std::ostream& out);

}  // namespace limn
