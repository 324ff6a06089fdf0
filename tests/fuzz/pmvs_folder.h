// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace limn::fuzz {

// A PMVS folder of three images of 40 x 30 pixels in the scratch folder, without the list of their
// names and without bundle.rd.out.
const std::filesystem::path& PmvsFolder();

}  // namespace limn::fuzz
