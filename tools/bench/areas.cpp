#include "tools/bench/areas.h"

#include <array>

namespace thaum::bench {

std::span<const Area> areas() {
    static constexpr std::array list{
        Area{"ecs", ecs},       Area{"tick", tick}, Area{"physics", physics},
        Area{"replay", replay}, Area{"skip", skip},
    };
    return list;
}

}  // namespace thaum::bench
