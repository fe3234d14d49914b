// haptics/detail/sources.h: forces of the servo's sources in one tick, which the energy account limits.
#pragma once
#include "core/maths.h"

namespace thaum::haptics {

/// Forces on the tip by kind of source (N).
struct Sources {
    vec3 passive{}, active{};
    vec3 world{};    ///< part of the passive force whose other end the world holds
    vec3 springs{};  ///< part of the passive force that can give energy back
    vec3 tether{};   ///< part of the springs by the tether
};

}  // namespace thaum::haptics
