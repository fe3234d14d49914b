#include "game/data/wand.h"

#include <algorithm>
#include <utility>

namespace thaum::game::inline data {

LoadedWand read_wand(std::string name, const Config& file) {
    const auto root = file.root();
    LoadedWand wand{.name = std::move(name)};
    wand.kind = kind_of_file(wand_kinds(), root, wand.name, "wand");
    if (wand.kind == nullptr) return wand;
    const auto energy = root.table("energy");
    wand.stats.slot = static_cast<std::uint32_t>(root.integer("slot", {1, wand_slots}) - 1);
    wand.stats.energy_slot =
        static_cast<std::uint32_t>(energy.integer("of_slot", {1, wand_slots}, wand.stats.slot + 1) - 1);
    wand.stats.energy_cap = energy.number("cap", {0, 1e6});
    wand.stats.energy_cost = energy.number("cost", {0, 1e6});
    wand.stats.energy_regain = energy.number("regain_per_s", {0, 1e6});
    wand.rules = wand.kind->read(root, wand.stats.slot);
    wand.look = read_wand_look(root.table("look"));
    return wand;
}

double throw_speed(const GraspKind& grasp, double mass, double energy) {
    const double per_speed = grasp.energy_per_impulse * mass;
    return per_speed > 0 ? std::min(grasp.speed, std::max(0.0, energy) / per_speed) : grasp.speed;
}

bool spend(WandBelt& belt, const WandStats& stats, double amount) {
    auto& energy = belt.energy[stats.energy_slot];
    if (energy < amount) return false;
    energy -= amount;
    return true;
}

bool spend(WandBelt& belt, const WandStats& stats) { return spend(belt, stats, stats.energy_cost); }

}  // namespace thaum::game::inline data
