// game/bots/mind.h: what a bot knows, wants and is about to do, as components of the bots' own World.
#pragma once
#include "game/bots/bot.h"

namespace thaum::game {

inline constexpr std::size_t bot_memory = 128;     ///< glimpses; at 8 ms one second
inline constexpr std::size_t most_power_ups = 16;  ///< that a bot can keep in mind
inline constexpr std::size_t most_things = 32;     ///< loose ones, likewise

/// What the eye saw at one look.
struct Glimpse {
    vec3 chest{};  ///< of the foe, m
    std::uint64_t seen{};
    static constexpr auto fields() {
        return std::tuple(ecs::field("chest", &Glimpse::chest), ecs::field("seen", &Glimpse::seen));
    }
};

/// A loose thing, where it saw it last.
struct Sighting {
    ecs::Entity thing{};
    vec3 place{};  ///< m
    static constexpr auto fields() {
        return std::tuple(ecs::field("thing", &Sighting::thing), ecs::field("place", &Sighting::place));
    }
};

/// Who it is and how good.
struct Seat {
    std::uint64_t device{};
    std::uint32_t player{};
    std::uint32_t spare{};
    BotSkill skill{};
    static constexpr std::string_view name = "Seat";
    static constexpr auto fields() {
        return std::tuple(ecs::field("device", &Seat::device), ecs::field("player", &Seat::player),
                          ecs::field("spare", &Seat::spare), ecs::field("skill", &Seat::skill));
    }
};

struct Eyes {
    std::uint64_t looks{};
    std::array<Glimpse, bot_memory> glimpses{};
    std::array<Tick, most_power_ups> back_at{};  ///< of each power-up, as it looked last
    std::array<Sighting, most_things> things{};
    static constexpr std::string_view name = "Eyes";
    static constexpr auto fields() {
        return std::tuple(ecs::field("looks", &Eyes::looks), ecs::field("glimpses", &Eyes::glimpses),
                          ecs::field("back_at", &Eyes::back_at), ecs::field("things", &Eyes::things));
    }
};

/// Where a bot goes when it does not just fight.
enum class Errand : std::uint32_t { none, fetch, hide, lift, stir };

struct Mind {
    Random random;
    vec3 foe{};                        ///< where it believes the foe's chest to be, m
    vec3 foe_velocity{};               ///< m/s, as it saw it move
    Tick foe_seen_at{};                ///< 0: never
    double error_right{}, error_up{};  ///< rad, how far its aim is off just now
    vec3 goal{};                       ///< m
    Tick goal_until{};
    Tick errand_until{};
    Tick fire_from{}, fire_until{};
    Tick strafe_until{};
    Tick slow_since{};  ///< when it began to be slower than it wished
    Tick dodge_until{};
    Tick wand_until{};   ///< when it may think of another wand
    double readiness{};  ///< to which it readies the wand it has chosen
    Errand errand{};
    std::int32_t strafe{};  ///< -1, 0, 1
    std::int32_t wishes_to_move{};
    std::int32_t right_left{}, up_left{};  ///< counts still to be given before the next look
    std::int32_t move_strafe{}, move_forward{};
    std::uint32_t buttons{};
    std::uint32_t round{};  ///< of the match, when it last thought
    std::uint32_t wand{};   ///< slot of the one it has chosen
    std::int32_t trigger{255};
    std::uint32_t spare{};
    static constexpr std::string_view name = "Mind";
    static constexpr auto fields() {
        using M = Mind;
        return std::tuple(
            ecs::field("random", &M::random), ecs::field("foe", &M::foe),
            ecs::field("foe_velocity", &M::foe_velocity), ecs::field("foe_seen_at", &M::foe_seen_at),
            ecs::field("error_right", &M::error_right), ecs::field("error_up", &M::error_up),
            ecs::field("goal", &M::goal), ecs::field("goal_until", &M::goal_until),
            ecs::field("errand_until", &M::errand_until), ecs::field("fire_from", &M::fire_from),
            ecs::field("fire_until", &M::fire_until), ecs::field("strafe_until", &M::strafe_until),
            ecs::field("slow_since", &M::slow_since), ecs::field("dodge_until", &M::dodge_until),
            ecs::field("wand_until", &M::wand_until), ecs::field("readiness", &M::readiness),
            ecs::field("errand", &M::errand), ecs::field("strafe", &M::strafe),
            ecs::field("wishes_to_move", &M::wishes_to_move), ecs::field("right_left", &M::right_left),
            ecs::field("up_left", &M::up_left), ecs::field("move_strafe", &M::move_strafe),
            ecs::field("move_forward", &M::move_forward), ecs::field("buttons", &M::buttons),
            ecs::field("round", &M::round), ecs::field("wand", &M::wand), ecs::field("trigger", &M::trigger),
            ecs::field("spare", &M::spare));
    }
};

/// What it does with a loose thing: walks to it, takes it up, has it.
enum class Porting : std::uint32_t { none, approach, take, hold };

struct Porter {
    ecs::Entity thing{};
    vec3 place{};                  ///< m, of the thing, as it saw it last
    Tick until{};                  ///< when it gives up what it is at
    Tick not_before{};             ///< when it may think of another thing
    Tick shots_from{}, shot_at{};  ///< since when it has seen shots come, and the last
    double off_left{}, off_up{};   ///< rad, of the thing from the crosshair when it was taken up
    Porting what{};
    std::uint32_t spare{};
    static constexpr std::string_view name = "Porter";
    static constexpr auto fields() {
        using P = Porter;
        return std::tuple(ecs::field("thing", &P::thing), ecs::field("place", &P::place),
                          ecs::field("until", &P::until), ecs::field("not_before", &P::not_before),
                          ecs::field("shots_from", &P::shots_from), ecs::field("shot_at", &P::shot_at),
                          ecs::field("off_left", &P::off_left), ecs::field("off_up", &P::off_up),
                          ecs::field("what", &P::what), ecs::field("spare", &P::spare));
    }
};

/// What it does with a rope: walks to the edge, aims at the anchor, hangs, flies on.
enum class Roping : std::uint32_t { none, approach, aim, hang, fly };

struct Climber {
    vec3 from{}, anchor{}, to{};  ///< m: feet, anchor, feet
    Tick until{};                 ///< when it gives up
    Tick not_before{};
    Roping what{};
    std::uint32_t spare{};
    static constexpr std::string_view name = "Climber";
    static constexpr auto fields() {
        using C = Climber;
        return std::tuple(ecs::field("from", &C::from), ecs::field("anchor", &C::anchor),
                          ecs::field("to", &C::to), ecs::field("until", &C::until),
                          ecs::field("not_before", &C::not_before), ecs::field("what", &C::what),
                          ecs::field("spare", &C::spare));
    }
};

/// What it does at the cauldron: walks to the rim, stirs.
enum class AtCauldron : std::uint32_t { none, approach, stir };

struct Stirrer {
    Tick until{};       ///< when it gives up, or has had enough
    Tick not_before{};  ///< when it may think of it again
    double health{};    ///< HP, when it began
    AtCauldron what{};
    std::uint32_t spare{};
    static constexpr std::string_view name = "Stirrer";
    static constexpr auto fields() {
        using S = Stirrer;
        return std::tuple(ecs::field("until", &S::until), ecs::field("not_before", &S::not_before),
                          ecs::field("health", &S::health), ecs::field("what", &S::what),
                          ecs::field("spare", &S::spare));
    }
};

/// The bot's own wizard, as it knows itself.
struct Self {
    vec3 centre{}, eye{}, velocity{};
    double yaw{}, pitch{};
    double health{};             ///< HP
    vec3 tip{};                  ///< m, of the wand in hand
    double energy_share{};       ///< of the wand in hand
    double readiness{};          ///< of the wand in hand
    ShotKind shot{};             ///< the next one from it
    std::uint32_t wand{};        ///< its slot
    bool can_shoot = false;      ///< there is energy for that shot
    std::optional<vec3> held{};  ///< m, what the wand in hand holds or hangs on
    std::uint32_t key{};
    bool alive = false;
};

}  // namespace thaum::game
