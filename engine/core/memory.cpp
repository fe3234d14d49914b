#include "core/memory.h"

#include <malloc.h>

namespace thaum {

void keep_freed_memory() {
#ifdef __GLIBC__
    constexpr int own_mapping_from = 32 << 20,
                  given_back_from = 256 << 20;  // bytes; glibc accepts at most 32 MiB for the first
    mallopt(M_MMAP_THRESHOLD, own_mapping_from);
    mallopt(M_TRIM_THRESHOLD, given_back_from);
#endif
}

}  // namespace thaum
