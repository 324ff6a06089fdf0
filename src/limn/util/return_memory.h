#pragma once

namespace limn {

// Gives memory that was freed back to the system, where it keeps it otherwise (glibc): call it
// where much has been freed, such as at the end of a stage.
void ReturnFreedMemory();

}  // namespace limn
