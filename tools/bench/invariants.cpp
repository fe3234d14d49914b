#include "tools/bench/invariants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/text.h"

namespace thaum::bench {
namespace {

constexpr double any = std::numeric_limits<double>::infinity();

/// Bounds that one value of a report's row, a metric or the error, must keep.
struct Invariant {
    std::string_view area;
    std::string_view name;  ///< name of a case; empty: every case in the area (group of benchmarks)
    std::string_view figure;
    double least, most;
};

/// Largest energy (J) that passive sources, such as springs and walls, may create in a hand, as the haptic
/// design demands.
constexpr double max_created = 0.02;
/// Largest relative change of the amount of a fluid's substance, which transport must conserve; float
/// rounding errors stay below it.
constexpr double amount_drift = 1e-5;

constexpr std::array invariants{
    Invariant{"replay", "verify", "mismatches", 0, 0},
    Invariant{"replay", "seek", "mismatches", 0, 0},
    Invariant{"replay", "seek", "compared", 1, any},
    Invariant{"replay", "verify", "compared", 1, any},
    Invariant{"tick", "alloc", "allocations", 0, 0},
    Invariant{"tick", "alloc", "shots", 1, any},
    Invariant{"tick", "alloc", "idle_works", 0, 0},
    Invariant{"tick", "alloc", "voices", 1, any},
    Invariant{"tick", "alloc", "felt_frames", 1, any},
    Invariant{"tick", "duel", "shots", 1, any},
    Invariant{"tick", "duel_haptic", "allocations", 0, 0},
    Invariant{"tick", "duel_haptic", "things_held", 2, 2},
    Invariant{"tick", "duel_haptic", "created_j", 0, max_created},
    Invariant{"tick", "duel_cauldron", "ingredients", 3, 3},
    Invariant{"tick", "duel_cauldron", "created_j", 0, max_created},
    Invariant{"tick", "duel_felt", "allocations", 0, 0},
    Invariant{"tick", "duel_felt", "voices", 1, any},
    Invariant{"tick", "duel_felt", "felt_frames", 1, any},
    Invariant{"tick", "duel_felt", "same_state", 1, 1},
    Invariant{"primitives", "", "allocations", 0, 0},
    Invariant{"haptics", "arm_exchange", "allocations", 0, 0},
    Invariant{"haptics", "arm_exchange", "differing", 0, 0},
    Invariant{"haptics", "arm_exchange", "lost", 0, 0},
    Invariant{"haptics", "safety_hostile", "violations", 0, 0},
    Invariant{"haptics", "passivity", "energy_j", 0, max_created},
    Invariant{"haptics", "passivity", "scenarios", 1, any},
    Invariant{"haptics", "modes", "allocations", 0, 0},
    Invariant{"haptics", "modes_hostile", "not_finite", 0, 0},
    Invariant{"haptics", "modes_hostile", "left_out", 0, 0},
    Invariant{"haptics", "modes_hostile", "largest_of_cap", 0, 1 + 1e-12},
    Invariant{"haptics", "modes_hostile", "observed_j", 0, max_created},
    Invariant{"haptics", "modes_passive", "not_finite", 0, 0},
    Invariant{"haptics", "modes_passive", "largest_of_cap", 0, 1 + 1e-12},
    Invariant{"haptics", "modes_passive", "created_j", 0, max_created},
    Invariant{"haptics", "volume_hostile", "not_finite", 0, 0},
    Invariant{"haptics", "volume_hostile", "largest_of_cap", 0, 1 + 1e-12},
    Invariant{"haptics", "volume_hostile", "observed_j", 0, max_created},
    Invariant{"audio", "mix", "allocations", 0, 0},
    Invariant{"audio", "level", "worst_db", 0, 0.1},
    Invariant{"tactile", "mix", "allocations", 0, 0},
    Invariant{"tactile", "mix", "playing", 64, 64},
    Invariant{"tactile", "silent", "allocations", 0, 0},
    Invariant{"tactile", "hostile", "violations", 0, 0},
    Invariant{"tactile", "hostile", "lost", 0, 0},
    Invariant{"field", "read_volume", "held_of_file", 1, 1.1},
    Invariant{"fluid", "", "amount_change", -amount_drift, amount_drift},
};

/// True for rows of `classic`, the method of the paper on which the fluid is based, which serves as baseline.
/// It loses part of what it transports, which is a result and not a fault.
bool is_baseline(const Row& row) {
    return std::any_of(row.setting.begin(), row.setting.end(), [](const auto& setting) {
        return setting.first == "solver" && shown(setting.second) == "classic";
    });
}

bool applies(const Invariant& invariant, const Row& row) {
    return !is_baseline(row) && invariant.area == row.area &&
           (invariant.name.empty() || invariant.name == row.name);
}

std::string wrong_figure(const Row& row, std::string_view figure, double value) {
    if (!std::isfinite(value)) return text(figure, " is not finite");
    for (const auto& i : invariants) {
        if (!applies(i, row) || i.figure != figure || (value >= i.least && value <= i.most)) continue;
        const auto bound = i.least == i.most ? text(shown(i.most))
                           : i.most == any   ? text("at least ", shown(i.least))
                                             : text("from ", shown(i.least), " to ", shown(i.most));
        return text(figure, " is ", shown(value), ", must be ", bound);
    }
    return {};
}

bool has_figure(const Row& row, std::string_view figure) {
    if (row.error && row.error->name == figure) return true;
    return std::any_of(row.metrics.begin(), row.metrics.end(),
                       [&](const auto& metric) { return metric.first == figure; });
}

/// Fault of a row that lacks a value for which there is a bound, as a text; empty: none.
std::string missing_figure(const Row& row) {
    for (const auto& i : invariants) {
        if (!i.name.empty() && applies(i, row) && !has_figure(row, i.figure))
            return text(i.figure, " is missing");
    }
    return {};
}

}  // namespace

std::string broken_invariant(const Row& row) {
    if (row.error && !(row.error->may_diverge && row.error->value == any)) {
        if (auto wrong = wrong_figure(row, row.error->name, row.error->value); !wrong.empty()) return wrong;
    }
    for (const auto& [name, value] : row.metrics) {
        if (auto wrong = wrong_figure(row, name, value); !wrong.empty()) return wrong;
    }
    if (row.time_us && !std::isfinite(row.time_us->median)) return "its time is not finite";
    return missing_figure(row);
}

void check_invariants(Report& report) {
    for (auto& row : report.rows) {
        row.fault = broken_invariant(row);
        if (row.fault.empty()) continue;
        std::string setting;
        for (const auto& [name, value] : row.setting) setting += text(" ", name, "=", shown(value));
        report.faults.push_back(text(row.area, " ", row.name, setting, ": ", row.fault));
    }
}

}  // namespace thaum::bench
