#include "core/team.h"

#include <thread>

#include "core/assert.h"

namespace thaum {
namespace {

// Parts of Team::work_, from the lowest bit on: whether the team is open, number of slices, next slice,
// number of the loop.
constexpr std::uint64_t open_bit = 1;
constexpr int slices_at = 1, next_at = 16, loop_at = 32;
constexpr std::uint64_t next_slice = std::uint64_t{1} << next_at;
constexpr std::uint64_t next_loop = std::uint64_t{1} << loop_at;

int slices_of(std::uint64_t work) { return static_cast<int>(work >> slices_at & (Team::max_slices - 1)); }
int next_of(std::uint64_t work) { return static_cast<int>(work >> next_at & 0xffff); }
bool is_open(std::uint64_t work) { return (work & open_bit) != 0; }

/// Number of looks for new slices after which a helper sleeps, about 100 us; and after which a leader that
/// waits for the helpers' last slices gives up its processor, which a helper may need.
constexpr int looks = 1500;

inline void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

void Team::open() {
    // The number of the loop changes, too: a helper must not take what it saw before for the present state.
    const std::uint64_t before = work_.load(std::memory_order_relaxed);
    work_.store((before / next_loop + 1) * next_loop | open_bit, std::memory_order_release);
}

void Team::close() {
    const std::uint64_t before = work_.load(std::memory_order_relaxed);
    work_.store((before / next_loop + 1) * next_loop, std::memory_order_release);
    work_.notify_all();
}

/// Gives the calling helper a seat; 0, which is the leader's, if none is free.
unsigned Team::sit_down() {
    for (unsigned seat = 1; seat < max_threads; ++seat) {
        const unsigned bit = 1U << seat;
        if ((seats_.fetch_or(bit, std::memory_order_acquire) & bit) == 0) return seat;
    }
    return 0;
}

/// Does one slice of the loop that the helper has seen. False if all are taken, or if another loop has begun;
/// then `seen` is the present state.
bool Team::take(std::uint64_t& seen, unsigned seat) {
    if (next_of(seen) >= slices_of(seen)) return false;
    if (!work_.compare_exchange_weak(seen, seen + next_slice, std::memory_order_acquire)) return false;
    loop_.call(loop_.body, next_of(seen), seat);
    done_.fetch_add(1, std::memory_order_release);
    return true;
}

std::uint64_t Team::wait_for_change(std::uint64_t seen) const {
    for (int i = 0; i < looks; ++i) {
        const std::uint64_t now = work_.load(std::memory_order_acquire);
        if (now != seen) return now;
        pause();
    }
    work_.wait(seen, std::memory_order_acquire);
    return work_.load(std::memory_order_acquire);
}

void Team::help() {
    std::uint64_t seen = work_.load(std::memory_order_acquire);
    if (!is_open(seen)) return;
    const unsigned seat = sit_down();
    if (seat == 0) return;
    while (is_open(seen)) {
        if (take(seen, seat))
            seen = work_.load(std::memory_order_acquire);
        else if (next_of(seen) >= slices_of(seen))
            seen = wait_for_change(seen);
    }
    seats_.fetch_and(~(1U << seat), std::memory_order_release);
}

void Team::run(int slices, const Loop& loop) {
    THAUM_ASSERT(slices < max_slices, "a loop is divided into too many slices");
    loop_ = loop;
    done_.store(0, std::memory_order_relaxed);
    const std::uint64_t before = work_.load(std::memory_order_relaxed);
    const std::uint64_t begun = (before / next_loop + 1) * next_loop |
                                static_cast<std::uint64_t>(slices) << slices_at | (before & open_bit);
    work_.store(begun, std::memory_order_release);
    work_.notify_all();
    for (;;) {
        const int slice = next_of(work_.fetch_add(next_slice, std::memory_order_relaxed));
        if (slice >= slices) break;
        loop.call(loop.body, slice, 0);
        done_.fetch_add(1, std::memory_order_relaxed);
    }
    for (int i = 0; done_.load(std::memory_order_acquire) < slices; ++i)
        i < looks ? pause() : std::this_thread::yield();
}

}  // namespace thaum
