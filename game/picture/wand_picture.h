// game/picture/wand_picture.h: one moment of a wizard's wands, as plain data.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/units.h"
#include "game/data/wand.h"
#include "input/frame.h"

namespace thaum::game::inline picture {

struct WandPicture {
    std::string_view name;   ///< name of the wand in hand; empty: none
    std::uint32_t number{};  ///< index of the wand in hand in Presentation::wands
    double energy{}, energy_cap{};
    std::array<double, input::max_wands> charges{};  ///< energy of each wand of Presentation::wands
    std::uint32_t fired{};                           ///< number of shots and throws by the wizard so far
    Target target{};     ///< the thing under the crosshair, and what the wand in hand can do with it
    double readiness{};  ///< charge or draw of the wand, 0 to 1
    vec3 turn{};   ///< rotation of the wand about its tip by the stylus: axis times angle (rad, eye frame)
    vec3 reach{};  ///< displacement of the wand's tip by the hand (m, eye frame)
    bool holds_thing{};  ///< true: the wand holds a thing that can be thrown
    /// Points of the path that the shot which the player is drawing would fly; only the first `arc_points`
    /// are used (m, world).
    std::array<vec3, 24> arc{};
    std::uint32_t arc_points{};
    /// Displacement of the resting end of a drawn wand's spring from wand_tip (m, eye
    /// frame); std::nullopt: no spring.
    std::optional<vec3> spring{};
    std::optional<vec3> held{};  ///< place that the wand holds or hangs on (m, world)
};

}  // namespace thaum::game::inline picture
