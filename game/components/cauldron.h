// game/components/cauldron.h: the cauldron, its brew and the wizards who stir it. A match without a cauldron
// has no entity with these components.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"
#include "game/components/ingredient.h"
#include "game/components/match.h"
#include "game/components/potions.h"
#include "game/components/wizard.h"

namespace thaum::game::inline components {

/// Momentum or an amount of one ingredient, queued for the next fluid step.
struct Stroke {
    vec3 place{};    ///< position at which the brew gets momentum or ingredient (m, brew frame)
    vec3 impulse{};  ///< momentum given to the brew (N s)
    double radius{};
    double amount{};                          ///< amount of the added ingredient (m^3)
    std::uint32_t ingredient{no_ingredient};  ///< number of the added ingredient; no_ingredient: momentum
                                              ///< only
    /// Source of the stroke. Strokes of one source are merged within a fluid step. It is the entity index of
    /// a thing + 1, or a number from 0xFFFF'0000 on for the pushes of a potion; 0: never merged.
    std::uint32_t by{};
    THAUM_FIELDS(Stroke, place, impulse, radius, amount, ingredient, by);
};

/// Capacity of Strokes, the list of pushes and drops. The first `players` places belong to the ladles; each
/// sums one ladle's momentum until the next fluid step.
inline constexpr std::size_t max_strokes = 12;

struct Strokes {
    std::array<Stroke, max_strokes> list{};
    std::uint32_t count{players};
    std::uint32_t spare{};
    THAUM_FIELDS(Strokes, list, count, spare);
};

/// Missile bursts at the brew that are queued for the next step of the surface.
struct BrewBursts {
    static constexpr std::size_t most = 8;

    std::array<vec3, most> place{};    ///< positions of the bursts (m, brew frame)
    std::array<double, most> times{};  ///< number of missiles that burst at each position
    std::uint32_t count{};
    std::uint32_t spare{};
    THAUM_FIELDS(BrewBursts, place, times, count, spare);
};

/// Why a step of a recipe does not fit. After `order`, `early` or `late` the
/// brew can no longer become a potion.
enum class BrewFault : std::uint32_t {
    none,
    order,       ///< no recipe has this ingredient as the next one
    early,       ///< the next ingredient was added too early
    late,        ///< the next step was done too late
    off,         ///< a stroke for a brew that can no longer become a potion
    full,        ///< an ingredient was dropped into a brew that holds three already, which is the most
    soon,        ///< the first stroke was drawn before the last ingredient had spread enough
    unfinished,  ///< a stroke for a brew that lacks an ingredient, or holds none
    foreign,     ///< a stroke for a brew owned by the other player
    gesture,     ///< the recipe asks for another gesture
    sense,       ///< a circle in the wrong direction of rotation
    gentle,      ///< a stroke that was gentler than the recipe allows
    hard         ///< a stroke that was harder than the recipe allows
};

/// State of the cauldron. The brew frame has its origin at `middle` and the axes of the world
/// (game/brew/brew.h).
struct Cauldron {
    vec3 middle{};  ///< middle of the level surface (m, world)
    /// Height of the surface under each ladle (m, above the level surface).
    std::array<double, players> height{};
    std::array<double, players> surface_speed{};  ///< vertical speed of the surface under each ladle (m/s)
    Strokes current{};                            ///< strokes of the fluid step that is being computed
    Strokes next{};  ///< strokes queued for the fluid step after the one that is being computed
    /// Number of the ingredient for which each substance of the fluid stands.
    std::array<std::uint32_t, 3> contents{no_ingredient, no_ingredient, no_ingredient};
    std::array<std::uint32_t, 4> inside{};  ///< 1 for each ladle that has broken through the surface
    std::uint32_t surface_asleep{1};
    std::uint32_t newest{};  ///< index of the newest of the two stored fluid states: 0 or 1
    /// 1 while a fluid step is being computed; 0: none, as while the fluid is at rest.
    std::uint32_t step_running{};
    std::uint32_t owner{no_player};  ///< player who owns the brew: who began it, or has since stirred harder
                                     ///< than the foe
    std::uint32_t spoilt{};          ///< 1: the next fluid step first removes all ingredients
    Tick stepped{};                  ///< when the newest fluid state was stored (ticks of play)
    BrewBursts bursts{};
    /// When the brew's first ingredient was dropped in (ticks of play); 0: the brew has no ingredient.
    Tick begun{};
    /// How evenly the newest ingredient is spread: 1 - coefficient of variation of its density, at least 0.
    double mixing{};
    /// Share of the brew that the newest ingredient has reached, 0 to 1: where it has at least a quarter of
    /// its mean density. Recipes allow a step while this share is in a given range.
    double reached{};
    double viscosity{1};  ///< mean viscosity of the brew, relative to pure brew
    double density{1};    ///< mean density of the brew, relative to pure brew
    double speed{};       ///< mean speed of the flow in the brew (m/s)
    /// When the brew became well mixed under its present owner (ticks of play); 0: it is not well mixed.
    Tick mixed_since{};
    Tick boon_until{};  ///< tick of play at which the healing by a well-mixed brew (the boon) ends
    std::uint32_t boon_for{no_player};  ///< player whom a well-mixed brew heals (the boon)
    std::uint32_t boon_given{};         ///< 1: the present brew has already given its boon, the healing
    Tick more_time{};  ///< time by which right ingredients have delayed the spoiling of the brew (ticks)
    std::uint32_t strokes_done{};     ///< number of strokes of the recipe that were right so far
    BrewFault fault{};                ///< fault that has spoilt the recipe; none: a potion is still possible
    std::uint32_t potion{no_potion};  ///< potion that has changed the brew for a time; no_potion: none
    std::uint32_t fluid_potion{no_potion};  ///< potion whose properties the brew has in the fluid step
                                            ///< that is being computed; no_potion: none
    Tick potion_until{};                    ///< tick of play at which the change by the potion wears off
    THAUM_COMPONENT(Cauldron, middle, current, next, contents, inside, height, surface_speed, surface_asleep,
                    newest, step_running, owner, spoilt, stepped, bursts, begun, mixing, reached, viscosity,
                    density, speed, mixed_since, boon_until, boon_for, boon_given, more_time, strokes_done,
                    fault, potion, fluid_potion, potion_until);
};

/// Array in the World (blob) with the samples of two fluid states, one after another. Each state has
/// velocity, substances and pressure, also in the ghost cells, which lie outside of the fluid. It is empty
/// until a player first touches the brew.
struct BrewSamples {
    using Element = float;
    static constexpr std::string_view name = "BrewSamples";
};

/// Array in the World (blob) with the samples of the surface: all heights (m), then all velocities (m/s). It
/// is empty until a player first touches the brew.
struct SurfaceSamples {
    using Element = double;
    static constexpr std::string_view name = "SurfaceSamples";
};

/// Ladle of a wizard who stirs. The wizard's hand moves its tip.
struct Ladle {
    static constexpr std::size_t spans = 12;

    vec3 place{};     ///< position of the tip (m, world)
    vec3 velocity{};  ///< velocity of the ladle's tip (m/s, world)
    vec3 force{};     ///< force of the ladle on the brew (N, world)
    /// Work done on the brew, one sum for each of the last `spans` intervals of 1/8 s (J).
    std::array<double, spans> work{};
    vec3 patch{};  ///< point around which the flow near the ladle was last sampled for the haptic model (m,
                   ///< brew frame)
    /// When the fluid state was stored from which the flow near the ladle was last sampled
    /// (Cauldron::stepped, ticks of play).
    Tick patched{};
    std::uint32_t span{};  ///< index in `work` of the interval that contains the present tick
    std::uint32_t spare{};
    THAUM_COMPONENT(Ladle, place, velocity, force, work, patch, patched, span, spare);
};

/// Place where a wizard with empty hands picks up an ingredient by walking over it. Its position is in
/// Motion.
struct Niche {
    Tick back_at{};              ///< when the ingredient is available again (ticks of play)
    std::uint32_t ingredient{};  ///< number of the ingredient that the niche has
    std::uint32_t spare{};
    THAUM_COMPONENT(Niche, back_at, ingredient, spare);
};

/// Ingredient carried by a wizard.
struct Pouch {
    std::uint32_t ingredient{};
    /// Ingredient of the niche (place of ingredients) at which the wizard stands with full hands, so that
    /// full hands are reported once; no_ingredient: none.
    std::uint32_t refused{no_ingredient};
    THAUM_COMPONENT(Pouch, ingredient, refused);
};

}  // namespace thaum::game::inline components
