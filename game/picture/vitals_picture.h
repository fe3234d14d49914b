// game/picture/vitals_picture.h: one moment of a wizard's body and life, as plain data.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "core/units.h"

namespace thaum::game::inline picture {

/// Most names of givers of effects that are shown of a wizard.
inline constexpr std::size_t max_shown_givers = 8;

struct VitalsPicture {
    vec3 centre{};          ///< middle of the wizard's body (m, world)
    vec3 eye{};             ///< position of the wizard's eye (m, world)
    double yaw{}, pitch{};  ///< direction in which the wizard looks (rad)
    bool dead{}, shielded{};
    std::uint32_t lives{};                         ///< number of deaths; when it changes, the wizard appears
                                                   ///< elsewhere
    double health{}, health_full{}, health_cap{};  ///< health now, of a new wizard, and at most (HP)
    std::int32_t kills{}, deaths{};
    double returns_in_s{};  ///< time until the wizard returns, if dead (s)
    /// Names of what gave the wizard effects that act now, such as potions, and the remaining time (s); only
    /// the first `givers` are used.
    std::array<std::string_view, max_shown_givers> giver_names{};
    std::array<double, max_shown_givers> giver_left_s{};
    std::uint32_t givers{};
    double poisoned_s{};  ///< time for which poison will still hurt the wizard (s); 0: there is none
};

}  // namespace thaum::game::inline picture
