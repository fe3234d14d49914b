#include "tools/bench/areas.h"

#include <array>

namespace thaum::bench {

std::span<const Area> areas() {
    static constexpr std::array list{
        Area{"ecs", ecs},
        Area{"tick", tick, soak},
        Area{"physics", physics},
        Area{"replay", replay},
        Area{"skip", skip},
        Area{"render", render},
        Area{"coupling", coupling},
        Area{"primitives", primitives},
        Area{"haptics", haptics, haptics_stress},
        Area{"fluid", fluid, fluid_stress},
        Area{"surface", surface},
        Area{"field", field},
        Area{"tactile", tactile_mixer},
        Area{"gesture", gestures},
        Area{"audio", audio},
    };
    return list;
}

}  // namespace thaum::bench
