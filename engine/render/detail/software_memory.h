// A software rasteriser takes some MB for each picture and frees them again.
#pragma once

namespace thaum::render::detail {

/// Makes the allocator keep what is freed. By default glibc gives blocks of that size back to the kernel, which has to
/// clear each page when it is asked for the next picture's: 900 page faults a picture, and a tenth of its time.
void keep_freed_memory();

}  // namespace thaum::render::detail
