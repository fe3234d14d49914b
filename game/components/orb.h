// game/components/orb.h: the scrying orb and the wizards who search it (Lundin, Cooper, Persson, Evestedt,
// Ynnerman 2007, "Enabling design and interactive selection of haptic modes"). A match without an orb has
// none of these components.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"
#include "field/transfer.h"

namespace thaum::field {

THAUM_FIELDS_OF(TransferFunction, points, count)

}  // namespace thaum::field

namespace thaum::game::inline components {

/// The orb. Its flow is field::make_vortex_flow(2 radius, seed) about `middle`, with the axes of the world.
/// The hidden core is the axis of the flow's first vortex.
struct Orb {
    vec3 middle{};    ///< middle of the orb (m, world)
    double radius{};  ///< radius of the orb (m)
    std::uint64_t seed{};
    THAUM_COMPONENT(Orb, middle, radius, seed);
};

inline constexpr std::uint32_t no_mode = 0xFFFF'FFFF;
inline constexpr std::size_t max_orb_modes = 8;
inline constexpr std::size_t max_worn_modes = 2;

/// Haptic modes that a wizard has switched on at the orb, and the curves of their strength. They remain when
/// the wizard leaves the orb.
struct WornModes {
    std::array<std::uint32_t, max_worn_modes> worn{no_mode,
                                                   no_mode};  ///< numbers of the active haptic modes, the
                                                              ///< oldest first
    /// For each haptic mode, strength as a function of its property, as the rules give it or as the wizard
    /// drew it.
    std::array<field::TransferFunction, max_orb_modes> strength{};
    std::uint32_t told{};  ///< 1: the orb has already rewarded this wizard since the wizard's last death
    /// 1: the orb has already shown this player the orders of recipes in this match.
    std::uint32_t order_told{};
    /// 1: focus (what spells cost, too) ran out while searching the orb (scrying); the wizard must release
    /// the button Stir to scry again.
    std::uint32_t spent{};
    std::uint32_t version{};  ///< number of changes of the haptic modes and their curves so far
    THAUM_COMPONENT(WornModes, worn, strength, told, order_told, spent, version);
};

/// State of a wizard who scries: holds the Stir button at the orb and moves a probe in its flow.
struct Scrying {
    vec3 place{};       ///< position of the probe (m, world)
    vec3 force{};       ///< force of the haptic modes on the probe (N, device frame rotated to world axes)
    double distance{};  ///< distance of the probe from the hidden core (m, world)
    Tick near_since{};  ///< when the probe came within reach of the orb's hidden core (ticks of play); 0: not
                        ///< within reach
    vec3 pen{};         ///< position of the hand when it last drew a curve (m, device frame)
    std::uint32_t pen_down{};  ///< 1: the button Trace is held, and `pen` is valid
    /// 1: the hand draws the strength curve of the newest haptic mode, and feels no mode meanwhile
    std::uint32_t drawing{};
    THAUM_COMPONENT(Scrying, place, force, distance, near_since, pen, pen_down, drawing);
};

}  // namespace thaum::game::inline components
