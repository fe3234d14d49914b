// game/scenario/force_trace.h: what both hands felt in a scenario, kept in a small file and compared to the bit.
//
//     # thaum forces, rules 7, maths 0123456789abcdef, 5230 ticks, hash 0123456789abcdef
//     from_tick,p1_peak_n,p1_x_n,p1_y_n,p1_z_n,p2_peak_n,p2_x_n,p2_y_n,p2_z_n,hash
//     256,1.1993,0,0,0.0716,0,0,0,0,01234567
//
// A row for every 128 ticks in which anything was felt: the greatest force and the mean one, rounded, to be read and plotted; and a
// hash of every bit of them. `hash` at the top is of all ticks.
#pragma once
#include <string>

#include "game/match/simulation.h"

namespace thaum::game {

class ForceRecord {
public:
    /// Of the tick that was just played.
    void add(const Simulation& match);
    /// The file.
    std::string file();

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

/// Nothing where both files say the same; else one line: where they part, or that they were made under other rules or with other
/// elementary functions.
std::string difference_of_forces(const std::string& kept, const std::string& now);

}  // namespace thaum::game
