// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <ostream>
#include <string>
#include <vector>

#include "colmap_ext/model/model.h"

namespace limn::colmap_ext {

// Layouts: COLMAP's documentation, "Output format". Readers throw IoError with byte or line.
std::vector<Rig> ReadRigsBinary(std::istream& in, const std::string& path);
std::vector<Rig> ReadRigsText(std::istream& in, const std::string& path);
std::vector<Frame> ReadFramesBinary(std::istream& in, const std::string& path);
std::vector<Frame> ReadFramesText(std::istream& in, const std::string& path);
void WriteRigsBinary(const SparseModel& model, std::ostream& out);
void WriteRigsText(const SparseModel& model, std::ostream& out);
void WriteFramesBinary(const SparseModel& model, std::ostream& out);
void WriteFramesText(const SparseModel& model, std::ostream& out);

}  // namespace limn::colmap_ext
