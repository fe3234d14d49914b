#include "core/team.h"

#include <thread>

namespace thaum {
namespace {

// Parts of Team::work_, from the lowest bit on: whether the team is open, number of slices, numbers of slices
// taken from the front and from the back, number of the loop.
constexpr std::uint64_t open_bit = 1;
constexpr int slices_at = 1, front_at = 11, back_at = 21, loop_at = 31;
constexpr std::uint64_t one_in_front = std::uint64_t{1} << front_at;
constexpr std::uint64_t one_behind = std::uint64_t{1} << back_at;
constexpr std::uint64_t next_loop = std::uint64_t{1} << loop_at;

int part_of(std::uint64_t work, int at) { return static_cast<int>(work >> at & Team::max_slices); }
int slices_of(std::uint64_t work) { return part_of(work, slices_at); }
int front_of(std::uint64_t work) { return part_of(work, front_at); }
int back_of(std::uint64_t work) { return part_of(work, back_at); }
bool all_taken(std::uint64_t work) { return front_of(work) + back_of(work) >= slices_of(work); }
bool is_open(std::uint64_t work) { return (work & open_bit) != 0; }

/// Number of checks for new slices, about 100 us, after which a helper sleeps. After as many checks for the
/// end of the helpers' last slices, the leader gives up its processor, which a helper may need.
constexpr int looks = 1500;

inline void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

}  // namespace

void Team::open() {
    // The number of the loop changes, too, so that no helper takes an earlier state for the present one.
    const std::uint64_t before = work_.load(std::memory_order_relaxed);
    work_.store((before / next_loop + 1) * next_loop | open_bit, std::memory_order_release);
}

void Team::close() {
    const std::uint64_t before = work_.load(std::memory_order_relaxed);
    work_.store((before / next_loop + 1) * next_loop, std::memory_order_release);
    work_.notify_all();
}

/// Gives the calling helper a seat, which is the number of a thread in the team; 0, which is the leader's, if
/// none is free.
unsigned Team::sit_down() {
    for (unsigned seat = 1; seat < max_threads; ++seat) {
        const unsigned bit = 1U << seat;
        if ((seats_.fetch_or(bit, std::memory_order_acquire) & bit) == 0) return seat;
    }
    return 0;
}

/// Does the last slice that is left of the loop that the helper has seen. Returns false if the state has
/// changed meanwhile; then `seen` is the present state.
bool Team::take(std::uint64_t& seen, unsigned seat) {
    if (!work_.compare_exchange_weak(seen, seen + one_behind, std::memory_order_acquire)) return false;
    loop_.call(loop_.body, slices_of(seen) - 1 - back_of(seen), seat);
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
    // A failed attempt to take a slice also changes `seen`, so the loop tests `seen` after each change: a
    // helper that waited in a closed team would not be woken.
    while (is_open(seen)) {
        if (all_taken(seen))
            seen = wait_for_change(seen);
        else if (take(seen, seat))
            seen = work_.load(std::memory_order_acquire);
    }
    seats_.fetch_and(~(1U << seat), std::memory_order_release);
}

void Team::run(int slices, const Loop& loop) {
    loop_ = loop;
    done_.store(0, std::memory_order_relaxed);
    const std::uint64_t before = work_.load(std::memory_order_relaxed);
    const std::uint64_t begun = (before / next_loop + 1) * next_loop |
                                static_cast<std::uint64_t>(slices) << slices_at | (before & open_bit);
    work_.store(begun, std::memory_order_release);
    work_.notify_all();
    for (std::uint64_t seen = begun; !all_taken(seen);) {
        if (!work_.compare_exchange_weak(seen, seen + one_in_front, std::memory_order_relaxed)) continue;
        loop.call(loop.body, front_of(seen), 0);
        done_.fetch_add(1, std::memory_order_relaxed);
        seen = work_.load(std::memory_order_relaxed);
    }
    for (int i = 0; done_.load(std::memory_order_acquire) < slices; ++i)
        i < looks ? pause() : std::this_thread::yield();
}

}  // namespace thaum
