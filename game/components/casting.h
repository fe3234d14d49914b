// game/components/casting.h: the stroke that a wizard draws, and the focus that spells cost.
#pragma once
#include <array>

#include "core/maths.h"
#include "core/units.h"
#include "ecs/component.h"

namespace thaum::game {

using ecs::field;

/// Focus of a wizard, spent on spells.
struct Focus {
    double points{};
    static constexpr std::string_view name = "Focus";
    static constexpr auto fields() { return std::tuple(field("points", &Focus::points)); }
};

/// One point of a stroke (m): x to the right, y up on the page, z towards the wizard. A ladle draws on the brew: there y
/// is away from the wizard and z is up.
struct DrawnPoint {
    float x{}, y{}, z{};
    float force{};  ///< force of the stroke, before caps and faders (N)
    static constexpr auto fields() {
        return std::tuple(field("x", &DrawnPoint::x), field("y", &DrawnPoint::y), field("z", &DrawnPoint::z),
                          field("force", &DrawnPoint::force));
    }
};

/// Room for a stroke of 4 s. A longer one keeps every second point, and so on.
inline constexpr std::size_t most_drawn_points = 512;

/// Value of DrawnStroke::over: a key chord has taken the stroke's place.
inline constexpr std::uint32_t by_chord = 2;

/// The stroke of a wizard who holds Trace.
struct DrawnStroke {
    std::array<DrawnPoint, most_drawn_points> points{};
    std::uint32_t count{};
    std::uint32_t every{1};  ///< gameplay ticks between two points
    std::uint32_t waits{};   ///< gameplay ticks until the next point
    /// 0: it is read at its end; 1: the ladle or the probe came or went, so nothing is read of it; by_chord
    std::uint32_t over{};
    std::uint32_t on_brew{};  ///< 1: the ladle draws
    std::uint32_t on_orb{};   ///< 1: a wizard who scries draws, so it is no spell's stroke
    vec3 home{};              ///< hand position chosen by the player before the stroke (m, device frame)
    /// Way of the hand beyond its device's workspace (m). The hand of a mouse is stopped there; its stroke goes on.
    vec3 beyond{};
    double reached{};  ///< Cauldron::reached when the ladle began to draw
    static constexpr std::string_view name = "DrawnStroke";
    static constexpr auto fields() {
        return std::tuple(field("points", &DrawnStroke::points), field("count", &DrawnStroke::count),
                          field("every", &DrawnStroke::every), field("waits", &DrawnStroke::waits),
                          field("over", &DrawnStroke::over), field("on_brew", &DrawnStroke::on_brew),
                          field("on_orb", &DrawnStroke::on_orb), field("home", &DrawnStroke::home),
                          field("beyond", &DrawnStroke::beyond), field("reached", &DrawnStroke::reached));
    }
};

/// What was read last of a wizard's strokes, for the picture and for recipes.
struct LastReading {
    Tick at{};                ///< tick of the reading; 0: none yet
    double probability{};     ///< 0 to 1
    double force{};           ///< mean force (N)
    double turns{};           ///< see StrokeReading
    std::uint32_t gesture{};  ///< number of the gesture; no_gesture: nothing was meant
    std::uint32_t nearest{};  ///< number of the nearest gesture; no_gesture: there is none
    static constexpr std::string_view name = "LastReading";
    static constexpr auto fields() {
        using L = LastReading;
        return std::tuple(field("at", &L::at), field("probability", &L::probability),
                          field("force", &L::force), field("turns", &L::turns), field("gesture", &L::gesture),
                          field("nearest", &L::nearest));
    }
};

/// Loose thing that a wizard took up or threw last.
struct LastProp {
    ecs::Entity thing{};  ///< no entity: none yet
    static constexpr std::string_view name = "LastProp";
    static constexpr auto fields() { return std::tuple(field("thing", &LastProp::thing)); }
};

}  // namespace thaum::game
