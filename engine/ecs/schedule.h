// ecs/schedule.h: systems run one after another, in the order in which they were added, each at its own period.
//
// A system declares what it reads and writes (checked on every access while it runs) and which components it needs: while
// any of those has no entity, it is not called at all. After each system the World's commands are applied.
#pragma once
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "core/units.h"
#include "ecs/world.h"

namespace thaum::ecs {

struct System {
    std::string_view name;
    Tick period = 1;  ///< ticks, > 0
    Tick phase = 0;   ///< it runs at ticks t with t % period == phase
    Mask reads{};
    Mask writes{};
    Mask needs{};  ///< skipped while one of these is empty
    std::function<void(World&, Tick)> run{};
};

struct SystemCount {
    std::uint64_t calls = 0;
    std::uint64_t skipped = 0;  ///< due, but something it needs was empty
    std::int64_t time_ns = 0;   ///< only while timing
};

class Schedule {
public:
    void add(System system);
    /// Runs what is due at this tick. `skip_idle` false calls every due system: results must not change.
    void run(World& world, Tick tick);

    std::size_t size() const { return systems_.size(); }
    const System& system(std::size_t i) const { return systems_[i]; }
    const SystemCount& counted(std::size_t i) const { return counts_[i]; }
    void reset_counts();

    bool skip_idle = true;
    bool timing = false;

private:
    bool idle(const World& world, const System& system) const;

    std::vector<System> systems_;
    std::vector<SystemCount> counts_;
};

}  // namespace thaum::ecs
