// Tests, by counting page faults, what the allocator does with freed memory.
#include "core/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <cstring>
#include <memory>

namespace thaum {
namespace {

/// Grows a vector by doubling up to 8 MiB, and frees it.
void grow_and_go() {
    std::unique_ptr<std::byte[]> store;
    for (std::size_t size = 4096; size <= std::size_t{8} << 20U; size *= 2) {
        store = std::make_unique_for_overwrite<std::byte[]>(size);
        std::memset(store.get(), 1, size);
    }
}

long page_faults_of(void (*work)()) {
    rusage before{}, after{};
    ::getrusage(RUSAGE_SELF, &before);
    work();
    ::getrusage(RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt;
}

// Runs in a process of its own, because freed memory stays with the process that asked for it.
TEST(CoreMemoryDeathTest, FreedMemoryIsUsedAgain) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    // The script `thaum` asks for large pages, with which there would be fewer page faults to count.
    ASSERT_EQ(::setenv("GLIBC_TUNABLES", "", 1), 0);
    EXPECT_EXIT(
        {
            const long as_it_comes = (grow_and_go(), page_faults_of(grow_and_go));
            keep_freed_memory();
            grow_and_go();
            const long kept = page_faults_of(grow_and_go);
            std::exit(as_it_comes > 1000 && kept < 100 ? 0 : 1);
        },
        testing::ExitedWithCode(0), "");
}

TEST(CoreMemory, ALargeArrayStartsAtALargePage) {
    for (const std::size_t bytes :
         {std::size_t{1}, large_page_bytes - 1, large_page_bytes, 3 * large_page_bytes + 5}) {
        auto* const array = static_cast<std::byte*>(allocate_array(bytes));
        const std::size_t alignment = bytes < large_page_bytes ? 64 : large_page_bytes;
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array) % alignment, 0U) << bytes << " bytes";
        std::memset(array, 7, bytes);
        EXPECT_EQ(array[bytes - 1], std::byte{7});
        free_array(array, bytes);
    }
}

}  // namespace
}  // namespace thaum
