#include "ecs/schedule.h"

#include <bit>

#include "core/clock.h"

namespace thaum::ecs {

void Schedule::add(System system) {
    THAUM_ASSERT(system.period > 0 && system.phase < system.period,
                 text("system ", system.name, " has an impossible period or phase"));
    systems_.push_back(std::move(system));
    counts_.emplace_back();
}

bool Schedule::idle(const World& world, const System& system) const {
    for (std::size_t w = 0; w < system.needs.words.size(); ++w) {
        for (auto word = system.needs.words[w]; word != 0; word &= word - 1) {
            const auto component =
                static_cast<std::uint32_t>(w * 64) + static_cast<std::uint32_t>(std::countr_zero(word));
            if (world.count(component) == 0) return true;
        }
    }
    return false;
}

void Schedule::run(World& world, Tick tick) {
    for (std::size_t i = 0; i < systems_.size(); ++i) {
        const auto& system = systems_[i];
        if (tick % system.period != system.phase) continue;
        if (skip_idle && idle(world, system)) {
            ++counts_[i].skipped;
            continue;
        }
        const Access access{system.reads, system.writes, system.name};
        const auto start = timing ? monotonic_ns() : 0;
        world.set_access(&access);
        system.run(world, tick);
        world.set_access(nullptr);
        world.apply_commands();
        ++counts_[i].calls;
        if (timing) counts_[i].time_ns += monotonic_ns() - start;
    }
}

void Schedule::reset_counts() { counts_.assign(systems_.size(), {}); }

}  // namespace thaum::ecs
