// core/memory.h: keeps freed memory in the process, so that the simulation and the renderer avoid page
// faults.
#pragma once

namespace thaum {

/// Makes the allocator keep freed memory for the whole process. `main` calls this before anything else.
///
/// By default glibc returns large blocks to the kernel. The kernel must clear each page again when the memory
/// is next requested, at an unpredictable tick. Without this call a picture of a software rasteriser caused
/// 900 page faults, a tenth of its time. A World that grows by doubling took either 13 or 36 ns an entity,
/// depending on the position of the heap's last block. Allocators other than glibc's are not affected.
void keep_freed_memory();

}  // namespace thaum
