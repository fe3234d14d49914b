// game/scenario/force_trace.h: the forces on both hands in a scenario, stored in a small file and compared
// exactly.
//
//     # thaum forces, rules 7, maths 0123456789abcdef, 5230 ticks, hash 0123456789abcdef
//     from_tick,p1_peak_n,p1_x_n,p1_y_n,p1_z_n,p2_peak_n,p2_x_n,p2_y_n,p2_z_n,hash
//     256,1.1993,0,0,0.0716,0,0,0,0,01234567
//
// Each row covers 128 ticks in which at least one hand felt a force. It holds the largest force and the mean
// force, rounded for reading and plotting, and a hash of all their bits. The `hash` in the first line covers
// all ticks.
#pragma once
#include <array>
#include <span>
#include <string>

#include "core/maths.h"
#include "core/units.h"
#include "game/components/wizard.h"

namespace thaum::game::inline scenario {

class ForceRecord {
public:
    /// Adds the forces on both hands (N) in the tick that the match has just played. `now`: number of ticks
    /// played.
    void add(Tick now, std::span<const vec3, players> forces);
    /// Text of the whole trace file. `rules`: version of the game's rules.
    std::string file(std::uint32_t rules);

private:
    void end_block();

    struct Sums {
        double peak{};
        vec3 sum{};
    };
    std::string rows_;
    std::array<Sums, players> sums_{};
    std::uint64_t ticks_{}, hash_{}, block_hash_{};
    Tick now_{};
};

/// Compares two trace files. Returns an empty string if they agree. Otherwise one line names the first
/// difference, or says that the files were made with other rules or other mathematical functions (sin, exp).
std::string difference_of_forces(const std::string& kept, const std::string& now);

}  // namespace thaum::game::inline scenario
