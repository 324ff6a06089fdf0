// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace limn {

// Gives memory that was freed back to the system, where it keeps it otherwise (glibc): call it
// where much has been freed, such as at the end of a stage.
void ReturnFreedMemory();

// Makes the process keep memory that was freed until ReturnFreedMemory() is called. By default
// glibc returns large blocks at once, and the system has to clear new pages for the next ones. For
// main() only: it changes the allocator of the whole process.
void KeepFreedMemory();

}  // namespace limn
