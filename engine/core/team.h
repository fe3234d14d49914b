// core/team.h: threads that share the loops of one computation.
//
// One thread, the leader, does the computation. Where it comes to a long loop, it divides the loop into
// slices and calls `each`. Other threads may help: between `open` and `close` they take slices of every such
// loop. The leader does not wait for helpers to come: a slice goes to the first thread that asks for it, and
// the leader does the slices that no helper takes. It waits only for slices that helpers have begun.
//
//     leader    open ── each(8) ─────────── each(8) ──────── close
//                        0 1 2 3             0 1 2 3 4
//     helper      help ─ 7 6 5 4 ─(spins)──  7 6 5 ────────── returns
//
// The leader takes slices from the front, helpers from the back. So if slices of different loops use the same
// memory, it mostly stays in the cache of one processor.
//
// Which thread does a slice is not defined. So that results do not depend on it, a slice must not read what
// another slice of the same loop writes, and sums over slices must be taken by the leader in a fixed order.
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "core/assert.h"

namespace thaum {

/// Threads that share the loops of one computation. The leader calls `each`, other threads call `help`.
class Team {
public:
    static constexpr unsigned max_threads = 4;  ///< largest number of threads that work at once
    static constexpr int max_slices = 1023;     ///< largest number of slices of a loop

    Team() = default;
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    /// Allows helpers to join. May be called by another thread than the leader, before the leader begins.
    void open();
    /// Makes the helpers leave. The leader calls it after its last loop. Helpers may still be in `help` when
    /// it returns, so the team must outlive their calls.
    void close();

    /// Takes slices of the leader's loops until `close`. Returns at once if the team is not open or has
    /// enough threads. Between two loops it spins for up to 0.1 ms, then sleeps.
    void help();

    /// Whether at least one helper has joined. If none has, the leader need not divide a loop.
    bool has_helpers() const { return seats_.load(std::memory_order_relaxed) != 0; }

    /// Calls body(slice, seat) once for each slice from 0 to slices - 1, and returns when all have ended.
    /// Only the leader calls it. The body must not throw, nor call `each` of the same team. `seat` is below
    /// max_threads and differs between threads that work at the same time, so that each can have scratch
    /// memory of its own. Without helpers, the slices are done in order.
    template <class Body>
    void each(int slices, Body&& body) {
        THAUM_ASSERT(slices <= max_slices, "a loop is divided into too many slices");
        if (!has_helpers() || slices < 2) {
            for (int slice = 0; slice < slices; ++slice) body(slice, 0U);
            return;
        }
        using Type = std::remove_reference_t<Body>;
        run(slices, {const_cast<void*>(static_cast<const void*>(std::addressof(body))),
                     [](void* of, int slice, unsigned seat) { (*static_cast<Type*>(of))(slice, seat); }});
    }

private:
    /// A loop's body, whatever its type is.
    struct Loop {
        void* body;
        void (*call)(void* body, int slice, unsigned seat);
    };

    void run(int slices, const Loop& loop);
    bool take(std::uint64_t& seen, unsigned seat);
    std::uint64_t wait_for_change(std::uint64_t seen) const;
    unsigned sit_down();

    /// Number of the loop, how many of its slices are taken, and whether the team is open (team.cpp). All are
    /// in one word, so that a helper that is late cannot take a slice of a newer loop by mistake.
    alignas(64) std::atomic<std::uint64_t> work_{0};
    Loop loop_{};                                 ///< written by the leader while no slice can be taken
    alignas(64) std::atomic<int> done_{0};        ///< number of slices that have ended
    alignas(64) std::atomic<unsigned> seats_{0};  ///< one bit for each helper that has joined
};

}  // namespace thaum
