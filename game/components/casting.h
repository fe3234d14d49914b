// game/components/casting.h: the stroke that a wizard draws to cast a spell, and the focus that spells cost.
#pragma once
#include <array>

#include "core/maths.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game::inline components {

/// Focus of a wizard, the supply that spells cost.
struct Focus {
    double points{};
    THAUM_COMPONENT(Focus, points);
};

/// One point of a stroke: x to the right, y up, z towards the wizard (m). If a ladle draws on the brew, y
/// points away from the wizard and z up.
struct DrawnPoint {
    float x{}, y{}, z{};
    /// Force of the stroke at this point, before limits and the player's faders reduce it (N)
    float force{};
    THAUM_FIELDS(DrawnPoint, x, y, z, force);
};

/// Capacity of a stroke in points, at first enough for 4 s. When it is full, every second point is dropped
/// and later points are taken half as often; this may happen repeatedly.
inline constexpr std::size_t max_drawn_points = 512;

/// Value of DrawnStroke::over: the wizard pressed a key chord (a wand's key while the button Trace is held),
/// which casts a spell instead of the stroke.
inline constexpr std::uint32_t by_chord = 2;

/// The stroke of a wizard who holds the Trace button.
struct DrawnStroke {
    std::array<DrawnPoint, max_drawn_points> points{};
    std::uint32_t count{};
    std::uint32_t every{1};  ///< gameplay ticks (of 8 ms) between two points
    std::uint32_t waits{};   ///< gameplay ticks (of 8 ms) until the next point
    /// 0: the stroke is read when it ends. 1: it is not read, because the ladle or the orb's probe came or
    /// went while it was drawn. by_chord: a key chord replaces it.
    std::uint32_t over{};
    std::uint32_t on_brew{};  ///< 1: the stroke is drawn on the brew, with the ladle that stirs it
    /// 1: drawn by a wizard who searches (scries) the orb, so the stroke casts no spell
    std::uint32_t on_orb{};
    vec3 home{};  ///< hand position that the player's input had asked for when the stroke began (m, device
                  ///< frame)
    /// Displacement of the stroke beyond the device's workspace (m, device frame). The simulated hand of a
    /// mouse player stops at the workspace's edge, but the stroke goes on.
    vec3 beyond{};
    double reached{};  ///< share of the brew that the newest ingredient had reached when the ladle began to
                       ///< draw, 0 to 1
    THAUM_COMPONENT(DrawnStroke, points, count, every, waits, over, on_brew, on_orb, home, beyond, reached);
};

/// Result of the last reading of a wizard's strokes, for the screen and for the recipes of potions.
struct LastReading {
    Tick at{};             ///< tick of play at which the stroke was read; 0: none yet
    double probability{};  ///< probability that the gesture was meant, 0 to 1
    double force{};        ///< mean force of the stroke (N)
    /// Number of clockwise turns of a closed stroke; negative: counter-clockwise; 0: not closed.
    double turns{};
    std::uint32_t gesture{};  ///< number of the gesture; no_gesture: no gesture was recognised
    /// Number of the gesture that the stroke resembles most; no_gesture: there is none.
    std::uint32_t nearest{};
    THAUM_COMPONENT(LastReading, at, probability, force, turns, gesture, nearest);
};

/// Loose thing that a wizard took up or threw last.
struct LastProp {
    /// Thing that the wizard took up or threw last; not a valid entity if there is none.
    ecs::Entity thing{};
    THAUM_COMPONENT(LastProp, thing);
};

}  // namespace thaum::game::inline components
