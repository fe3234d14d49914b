// core/memory.h: what the allocator does with memory that is freed.
#pragma once

namespace thaum {

/// Makes the allocator keep what is freed, for the whole process; for `main`, before anything else. By default glibc gives large
/// blocks back to the kernel, which must clear each page anew when they are asked for again, at whatever tick that is. A
/// software rasteriser's pictures came to 900 page faults each, a tenth of their time; a World that grows by doubling took 13 or 36 ns an
/// entity, as the heap's last block happened to lie. Without effect where the allocator is not glibc's.
void keep_freed_memory();

}  // namespace thaum
