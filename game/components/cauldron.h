// game/components/cauldron.h: the cauldron and who stirs it. A scene without one has none of these.
#pragma once
#include <array>

#include "core/units.h"
#include "ecs/component.h"
#include "game/components/ingredient.h"
#include "game/components/match.h"
#include "game/components/wizard.h"

namespace thaum::game {

using ecs::field;

/// What waits for the next step of the fluid: momentum, or some of an ingredient.
struct Stroke {
    vec3 place{};    ///< m, brew's frame
    vec3 impulse{};  ///< N s; of momentum
    double radius{};
    double amount{};                          ///< m^3, of an ingredient
    std::uint32_t ingredient{no_ingredient};  ///< its number; no_ingredient: momentum
    std::uint32_t by{};                       ///< whose strokes of one step become one; 0: nobody's
    static constexpr auto fields() {
        return std::tuple(field("place", &Stroke::place), field("impulse", &Stroke::impulse),
                          field("radius", &Stroke::radius), field("amount", &Stroke::amount),
                          field("ingredient", &Stroke::ingredient), field("by", &Stroke::by));
    }
};

/// The first places are the players' ladles', which gather what they do from step to step.
inline constexpr std::size_t most_strokes = 12;

struct Strokes {
    std::array<Stroke, most_strokes> list{};
    std::uint32_t count{players};
    std::uint32_t spare{};
    static constexpr auto fields() {
        return std::tuple(field("list", &Strokes::list), field("count", &Strokes::count),
                          field("spare", &Strokes::spare));
    }
};

/// The brew's frame stands at `middle`, its axes those of the world (game/cauldron/brew.h).
struct Cauldron {
    vec3 middle{};                         ///< m, world: of the level surface
    std::array<double, players> height{};  ///< m, above the level: of the surface under each ladle
    std::array<double, players> rise{};    ///< m/s, of that
    Strokes given{};                       ///< to the step of the fluid that is on its way
    Strokes next{};                        ///< to the one after it
    std::array<std::uint32_t, 3> what{no_ingredient, no_ingredient,
                                      no_ingredient};  ///< which ingredient stands in each substance
    std::array<std::uint32_t, 4> inside{};             ///< of the surface: which ladle has broken through
    std::uint32_t surface_asleep{1};
    std::uint32_t newest{};          ///< 0 or 1: which of the BrewPages' two states is the newest
    std::uint32_t under_way{};       ///< 1: a step of the fluid is; else it is at rest
    std::uint32_t owner{no_player};  ///< whose brew it is
    std::uint32_t spoilt{};          ///< 1: the next step begins with pure brew
    Tick stepped{};                  ///< when the newest state was taken
    std::uint64_t events_seen{};     ///< of Chronicle::count
    Tick begun{};                    ///< when the first ingredient fell in; 0: it is pure
    double mixing{};      ///< of what was dropped in last: 1 - its coefficient of variation, at least 0
    double viscosity{1};  ///< mean over the brew, of the pure one's
    double density{1};    ///< likewise
    double speed{};       ///< m/s, mean over the brew
    static constexpr std::string_view name = "Cauldron";
    static constexpr auto fields() {
        using C = Cauldron;
        return std::tuple(
            field("middle", &C::middle), field("given", &C::given), field("next", &C::next),
            field("what", &C::what), field("inside", &C::inside), field("height", &C::height),
            field("rise", &C::rise), field("surface_asleep", &C::surface_asleep), field("newest", &C::newest),
            field("under_way", &C::under_way), field("owner", &C::owner), field("spoilt", &C::spoilt),
            field("stepped", &C::stepped), field("events_seen", &C::events_seen), field("begun", &C::begun),
            field("mixing", &C::mixing), field("viscosity", &C::viscosity), field("density", &C::density),
            field("speed", &C::speed));
    }
};

/// The brew's samples, one page after another: two states of the fluid, each its velocity, substances and pressure, ghosts
/// included. There are none before the brew was first touched.
struct BrewPage {
    std::array<float, 1024> samples{};
    static constexpr std::string_view name = "BrewPage";
    static constexpr auto fields() { return std::tuple(field("samples", &BrewPage::samples)); }
};

/// The surface's heights and then its velocities, likewise.
struct SurfacePage {
    std::array<double, 512> samples{};
    static constexpr std::string_view name = "SurfacePage";
    static constexpr auto fields() { return std::tuple(field("samples", &SurfacePage::samples)); }
};

/// A wizard who stirs: his hand's probe is the ladle.
struct Ladle {
    static constexpr std::size_t spans = 12;

    double yaw{};                      ///< rad: where its frame's -z points, from its holder to the middle
    vec3 place{};                      ///< m, world: its tip
    vec3 velocity{};                   ///< m/s
    vec3 force{};                      ///< N, on the brew
    std::array<double, spans> work{};  ///< J, done on the brew in each of the last spans of 1/8 s
    vec3 patch{};                      ///< m, brew's frame: about which the flow was read that the hand feels
    Tick patched{};                    ///< Cauldron::stepped of that
    std::uint32_t span{};              ///< which of them is the present one
    std::uint32_t spare{};
    static constexpr std::string_view name = "Ladle";
    static constexpr auto fields() {
        return std::tuple(
            field("yaw", &Ladle::yaw), field("place", &Ladle::place), field("velocity", &Ladle::velocity),
            field("force", &Ladle::force), field("work", &Ladle::work), field("patch", &Ladle::patch),
            field("patched", &Ladle::patched), field("span", &Ladle::span), field("spare", &Ladle::spare));
    }
};

/// A place where an ingredient is found, by who walks there with empty hands. Its place is in Motion.
struct Niche {
    Tick back_at{};              ///< there from that tick of play on
    std::uint32_t ingredient{};  ///< its number
    std::uint32_t spare{};
    static constexpr std::string_view name = "Niche";
    static constexpr auto fields() {
        return std::tuple(field("back_at", &Niche::back_at), field("ingredient", &Niche::ingredient),
                          field("spare", &Niche::spare));
    }
};

/// A wizard who carries an ingredient.
struct Pouch {
    std::uint32_t ingredient{};
    static constexpr std::string_view name = "Pouch";
    static constexpr auto fields() { return std::tuple(field("ingredient", &Pouch::ingredient)); }
};

}  // namespace thaum::game
