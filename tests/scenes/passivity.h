// tests/scenes/passivity.h: energy that passive sources of force (springs, walls, drag) created, summed from
// a table of forces (`thaum replay --forces`). The simulation's own passivity observer is not used. For the
// benchmark and the test.
#pragma once
#include <algorithm>
#include <array>
#include <string_view>

#include "core/error.h"
#include "core/maths.h"
#include "core/table.h"
#include "core/text.h"

namespace thaum::bench {

/// Energies computed from a table of forces.
struct PassiveEnergy {
    /// Most energy that passive sources (springs, walls, drag) gave beyond what they received and still
    /// stored (J)
    double created{};
    /// Energy that passed between sources and hand in both directions (J). If it is zero, the test proves
    /// nothing.
    double moved{};
    /// Most energy that the spring to the anchor (the point to which a tether pulls) and the touched surface
    /// stored (J)
    double held{};
    double max_booked{};  ///< largest value of the simulation's own observer (J), only for comparison
    std::size_t rows{};
};

namespace detail {

/// State of one hand in one tick.
struct HandRow {
    vec3 at{};       ///< position of the haptic device's tip (m)
    vec3 passive{};  ///< force by passive sources, such as springs and walls (N)
    vec3 anchor{}, surface{};
    double stiffness{}, booked{};
    bool touches{}, real{};
    bool cut{};  ///< true: the hand got less force than the sources requested
};

/// The columns of one player's hand in a table of forces.
class HandColumns {
public:
    HandColumns(TableReader& table, int player) {
        static constexpr std::array<std::string_view, count> names{
            "x_m",  "y_m",  "z_m",     "px_n", "py_n", "pz_n", "k_n_per_m", "ax_m",
            "ay_m", "az_m", "touches", "sx_m", "sy_m", "sz_m", "arm",       "created_j"};
        std::ranges::transform(names, places_.begin(), [&](std::string_view name) {
            return table.column(text("p", player, "_", name));
        });
        cause_ = table.column(text("p", player, "_cause"));
    }

    HandRow read(TableReader& table) const {
        std::array<double, count> v{};
        std::ranges::transform(places_, v.begin(), [&](std::size_t place) { return table.number(place); });
        const auto cause = table.cell(cause_);
        return HandRow{.at = {v[0], v[1], v[2]},
                       .passive = {v[3], v[4], v[5]},
                       .anchor = {v[7], v[8], v[9]},
                       .surface = {v[11], v[12], v[13]},
                       .stiffness = v[6],
                       .booked = v[15],
                       .touches = v[10] != 0,
                       .real = v[14] != 0,
                       .cut = cause == "capped" || cause == "warm"};
    }

private:
    static constexpr std::size_t count = 16;  // number of columns with numbers for one hand
    std::array<std::size_t, count> places_{};
    std::size_t cause_{};
};

/// Energy balance of one hand. A source's force F acts while the hand moves by dx and the world's end of the
/// spring moves by da. The energy F dx flows out to the hand, and F da flows in from the world.
class HandSum {
public:
    void add(const HandRow& current, PassiveEnergy& out) {
        out.max_booked = std::max(out.max_booked, current.booked);
        if (rows_ >= 2) {
            // Uses the force of the previous tick, because the hand's position at that tick's end and the
            // surface after it are known only now.
            const HandRow &first = before_[0], &row = before_[1];
            const vec3 step = row.real ? current.at - row.at : row.at - first.at;
            const double out_at_hand = glm::dot(row.passive, step);
            work(first, row, current, out_at_hand, out);
        }
        before_[0] = before_[1];
        before_[1] = current;
        ++rows_;
    }

private:
    void work(const HandRow& first, const HandRow& row, const HandRow& current, double out_at_hand,
              PassiveEnergy& out) {
        const bool hangs = first.stiffness > 0 && row.stiffness > 0;
        const vec3 end = hangs                            ? row.anchor - first.anchor
                         : row.touches && current.touches ? current.surface - row.surface
                                                          : vec3(0);
        // A spring that appears already stretched has not created that energy itself.
        const vec3 stretch = row.at - row.anchor;
        double held = row.stiffness * glm::dot(stretch, stretch) / 2;
        if (row.touches) {
            const vec3 pressed = row.surface - (row.real ? row.at : first.at);
            // Upper bound on the energy stored in a spring whose force is constant beyond some stretch: force
            // times stretch.
            held += std::max(0.0, glm::dot(row.passive, pressed)) / (row.cut ? 1 : 2);
        }
        if (row.stiffness > 0 && first.stiffness == 0) created_ = -held;
        if (row.stiffness == 0 && first.stiffness > 0) created_ = 0;
        created_ += out_at_hand - glm::dot(row.passive, end);
        // Only stored energy may come back; damping has dissipated the rest.
        created_ = std::max(created_, -held);
        out.created = std::max(out.created, created_);
        out.moved += std::abs(out_at_hand);
        out.held = std::max(out.held, held);
    }

    std::array<HandRow, 2> before_{};
    std::size_t rows_{};
    double created_{};
};

}  // namespace detail

/// Energies of both hands from a table with its header. `created` is the worse of the two.
inline Expected<PassiveEnergy> passive_energy(std::string_view csv) {
    TableReader table(csv, "forces");
    const std::array<detail::HandColumns, 2> columns{detail::HandColumns(table, 1),
                                                     detail::HandColumns(table, 2)};
    std::array<detail::HandSum, 2> sums;
    PassiveEnergy energy;
    while (table.next()) {
        for (std::size_t hand = 0; hand < sums.size(); ++hand)
            sums.at(hand).add(columns.at(hand).read(table), energy);
        ++energy.rows;
    }
    if (!table.good()) return table.fault();
    return energy;
}

}  // namespace thaum::bench
