// ecs/schedule.h: runs systems one after another, in the order in which they were added, each at its own
// period.
//
// A system declares which components and resources (ecs/resource.h) it reads and writes. Every access is
// checked against this while the system runs. It also declares which components it needs, and is skipped
// while one of them belongs to no entity. After each system the World's commands are applied.
#pragma once
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "core/units.h"
#include "ecs/world.h"

namespace thaum::ecs {

/// A function that runs at its own period, and what it needs of the World.
struct System {
    std::string_view name;
    Tick period = 1;  ///< interval between runs, > 0 (ticks)
    Tick phase = 0;   ///< the system runs at every tick t with t % period == phase (ticks)
    Mask reads{};
    Mask writes{};
    Mask needs{};  ///< components; the system is skipped while one of them belongs to no entity
    std::function<void(World&, Tick)> run{};
};

/// Statistics of a system: how often it ran, and for how long.
struct SystemCount {
    std::uint64_t calls = 0;
    /// Number of times that the system was due but did not run, because a component that it needs belonged to
    /// no entity.
    std::uint64_t skipped = 0;
    std::int64_t time_ns = 0;  ///< time spent in `run`, counted only while `timing` is set (ns)
};

/// Systems in the order in which they run.
class Schedule {
public:
    /// Adds a system, which runs after all those that were added before.
    void add(System system);
    /// Runs the systems that are due at this tick. A system is skipped while a component that it needs
    /// belongs to no entity. With `skip_idle` false it runs all the same, so that tests can show that
    /// skipping changes no result.
    void run(World& world, Tick tick);

    std::size_t size() const { return systems_.size(); }
    /// System number `i`, in the order of their addition.
    const System& system(std::size_t i) const { return systems_[i]; }
    /// How often system number `i` ran and was skipped, and the time that it took.
    const SystemCount& counted(std::size_t i) const { return counts_[i]; }
    /// Sets the counts of runs and the times of all systems to 0.
    void reset_counts();

    bool skip_idle = true;
    bool timing = false;

private:
    bool idle(const World& world, const System& system) const;

    std::vector<System> systems_;
    std::vector<SystemCount> counts_;
};

}  // namespace thaum::ecs
