// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn::colmap_ext {

// For the start of main(): opens standard streams that are closed, and makes a write beyond the
// limit on the size of files fail instead of ending the process.
void PrepareProcess();

}  // namespace limn::colmap_ext
