#pragma once

namespace limn {

// Gives memory that was freed back to the system, where it keeps it otherwise (glibc): call it
// where much has been freed, such as at the end of a stage.
void ReturnFreedMemory();

// Lets the process keep memory that was freed until ReturnFreedMemory() is called. glibc returns
// large blocks at once, and the system clears them anew for the next, page by page: a tenth of the
// time of a run. For main() only: it changes the allocator of the whole process.
void KeepFreedMemory();

}  // namespace limn
