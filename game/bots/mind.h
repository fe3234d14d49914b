// game/bots/mind.h: memory, goals and plans of a bot, as components of the bots' own World.
#pragma once
#include "game/bots/bot.h"
#include "game/components/potions.h"

namespace thaum::game {

inline constexpr std::size_t bot_memory = 128;     ///< number of glimpses; one second at 8 ms each
inline constexpr std::size_t most_power_ups = 16;  ///< number of power-ups that a bot remembers
inline constexpr std::size_t most_things = 32;     ///< number of loose things that a bot remembers

/// Observation of the foe in one gameplay tick.
struct Glimpse {
    vec3 chest{};  ///< position of the foe's chest (m, world)
    std::uint64_t seen{};
    static constexpr auto fields() {
        return std::tuple(ecs::field("chest", &Glimpse::chest), ecs::field("seen", &Glimpse::seen));
    }
};

/// A loose thing and the position at which the bot saw it last.
struct Sighting {
    ecs::Entity thing{};
    vec3 place{};  ///< position (m, world)
    static constexpr auto fields() {
        return std::tuple(ecs::field("thing", &Sighting::thing), ecs::field("place", &Sighting::place));
    }
};

/// Player, device and skill of a bot.
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

/// Visual memory of a bot.
struct Eyes {
    std::uint64_t looks{};
    std::array<Glimpse, bot_memory> glimpses{};
    std::array<Tick, most_power_ups> back_at{};  ///< when each power-up is available again, as last seen
    std::array<Sighting, most_things> things{};
    static constexpr std::string_view name = "Eyes";
    static constexpr auto fields() {
        return std::tuple(ecs::field("looks", &Eyes::looks), ecs::field("glimpses", &Eyes::glimpses),
                          ecs::field("back_at", &Eyes::back_at), ecs::field("things", &Eyes::things));
    }
};

/// Reason for which a bot walks to mind.goal instead of fighting.
enum class Errand : std::uint32_t { none, fetch, hide, lift, stir };

/// Present beliefs, goals and controls of a bot.
struct Mind {
    Random random;
    vec3 foe{};                        ///< presumed position of the foe's chest (m, world)
    vec3 foe_velocity{};               ///< velocity of the foe as the bot saw it (m/s)
    Tick foe_seen_at{};                ///< tick at which the foe was last seen; 0: never
    double error_right{}, error_up{};  ///< present error of the aim (rad)
    vec3 goal{};                       ///< place to which the bot walks (m, world)
    Tick goal_until{};                 ///< tick at which the bot chooses another goal
    Tick errand_until{};               ///< tick until which the bot hides
    Tick fire_from{}, fire_until{};    ///< beginning and end of the latest burst of fire (ticks)
    Tick strafe_until{};               ///< tick until which the bot keeps its sideways step
    Tick slow_since{};                 ///< tick since which the bot has been slower than intended
    Tick stranded_since{};             ///< tick since which the bot has stood in a cell that leads nowhere
    Tick dodge_until{};                ///< tick until which the bot walks sideways to get free
    Tick wand_until{};                 ///< tick until which the bot keeps its choice of wand
    double readiness{};                ///< readiness to which the bot readies the chosen wand
    Errand errand{};
    std::int32_t strafe{};                 ///< -1 left, 0 none, 1 right
    std::int32_t wishes_to_move{};         ///< 1: the bot walks
    std::int32_t right_left{}, up_left{};  ///< mouse counts still to be given before the next gameplay tick
    std::int32_t move_strafe{}, move_forward{};  ///< controls of walking, -127 to 127
    std::uint32_t buttons{};                     ///< buttons that are down (bits of input::Button)
    std::uint32_t round{};                       ///< round of the bot's latest gameplay tick
    std::uint32_t wand{};                        ///< slot of the chosen wand
    std::int32_t trigger{255};                   ///< control of the trigger while fire is down, 0 to 255
    std::uint32_t wand_key{};                    ///< wand whose key is down, 1 to wand_slots; 0: none
    std::uint32_t heedless{};                    ///< 1: the present side step heeds no edge
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
            ecs::field("slow_since", &M::slow_since), ecs::field("stranded_since", &M::stranded_since),
            ecs::field("dodge_until", &M::dodge_until), ecs::field("wand_until", &M::wand_until),
            ecs::field("readiness", &M::readiness), ecs::field("errand", &M::errand),
            ecs::field("strafe", &M::strafe), ecs::field("wishes_to_move", &M::wishes_to_move),
            ecs::field("right_left", &M::right_left), ecs::field("up_left", &M::up_left),
            ecs::field("move_strafe", &M::move_strafe), ecs::field("move_forward", &M::move_forward),
            ecs::field("buttons", &M::buttons), ecs::field("round", &M::round), ecs::field("wand", &M::wand),
            ecs::field("trigger", &M::trigger), ecs::field("wand_key", &M::wand_key),
            ecs::field("heedless", &M::heedless), ecs::field("spare", &M::spare));
    }
};

/// Stages of lifting: walk to the thing, take it up, hold it.
enum class LiftStage : std::uint32_t { none, approach, take, hold };

/// Plan of a bot for one loose thing.
struct LiftPlan {
    ecs::Entity thing{};
    vec3 place{};                  ///< position at which the bot saw the thing last (m, world)
    Tick until{};                  ///< tick at which the bot gives up the present stage
    Tick not_before{};             ///< tick before which the bot chooses no other thing
    Tick shots_from{}, shot_at{};  ///< ticks of the first and the last shot seen coming
    double off_left{}, off_up{};   ///< angles from the crosshair to the thing when it was taken up (rad)
    LiftStage stage{};
    std::uint32_t spare{};
    static constexpr std::string_view name = "Porter";
    static constexpr auto fields() {
        using P = LiftPlan;
        return std::tuple(ecs::field("thing", &P::thing), ecs::field("place", &P::place),
                          ecs::field("until", &P::until), ecs::field("not_before", &P::not_before),
                          ecs::field("shots_from", &P::shots_from), ecs::field("shot_at", &P::shot_at),
                          ecs::field("off_left", &P::off_left), ecs::field("off_up", &P::off_up),
                          ecs::field("what", &P::stage), ecs::field("spare", &P::spare));
    }
};

/// Stages of a swing: walk to the edge, aim at the anchor, hang on the rope, fly on.
enum class SwingStage : std::uint32_t { none, approach, aim, hang, fly };

/// Plan of a bot to swing over a gap.
struct SwingPlan {
    vec3 from{}, anchor{}, to{};  ///< take-off (feet), anchor, landing (feet) (m, world)
    Tick until{};                 ///< tick at which the bot gives up the present stage
    Tick not_before{};
    SwingStage stage{};
    std::uint32_t spare{};
    static constexpr std::string_view name = "Climber";
    static constexpr auto fields() {
        using C = SwingPlan;
        return std::tuple(ecs::field("from", &C::from), ecs::field("anchor", &C::anchor),
                          ecs::field("to", &C::to), ecs::field("until", &C::until),
                          ecs::field("not_before", &C::not_before), ecs::field("what", &C::stage),
                          ecs::field("spare", &C::spare));
    }
};

/// Stages at the cauldron: walk to a niche for an ingredient, walk to the rim, stir.
enum class StirStage : std::uint32_t { none, approach, stir, fetch };

/// Plan of a bot at the cauldron.
struct StirPlan {
    Tick until{};       ///< tick at which the bot gives up or stops stirring
    Tick not_before{};  ///< tick before which the bot does not go to the cauldron again
    double health{};    ///< health at the beginning of stirring (HP)
    StirStage stage{};
    std::uint32_t recipe{no_potion};  ///< recipe that the bot brews; no_potion: it only stirs
    std::uint32_t dropped{};          ///< number of ingredients that the bot has seen in its brew
    std::uint32_t stroke{};           ///< number of strokes done when the present one began
    Tick drawing_from{};              ///< tick at which the present stroke began; 0: the bot draws none
    Tick drawing_until{};             ///< tick at which Trace is released
    Tick hands_off_until{};           ///< tick before which the bot begins no stroke and drops nothing
    std::uint32_t drops{};            ///< 1: the bot presses fire over the brew
    std::uint32_t spare{};
    static constexpr std::string_view name = "Stirrer";
    static constexpr auto fields() {
        using S = StirPlan;
        return std::tuple(ecs::field("until", &S::until), ecs::field("not_before", &S::not_before),
                          ecs::field("health", &S::health), ecs::field("what", &S::stage),
                          ecs::field("recipe", &S::recipe), ecs::field("dropped", &S::dropped),
                          ecs::field("stroke", &S::stroke), ecs::field("drawing_from", &S::drawing_from),
                          ecs::field("drawing_until", &S::drawing_until),
                          ecs::field("hands_off_until", &S::hands_off_until), ecs::field("drops", &S::drops),
                          ecs::field("spare", &S::spare));
    }
};

/// How a bot draws, as long as it lives: its user style.
struct DrawingStyle {
    double size{1};                  ///< size of strokes, relative to the templates
    double aspect{1};                ///< width relative to the height
    double slant{};                  ///< shear of x by y
    double cos_tilt{1}, sin_tilt{};  ///< turn on the page
    static constexpr auto fields() {
        using S = DrawingStyle;
        return std::tuple(ecs::field("size", &S::size), ecs::field("aspect", &S::aspect),
                          ecs::field("slant", &S::slant), ecs::field("cos_tilt", &S::cos_tilt),
                          ecs::field("sin_tilt", &S::sin_tilt));
    }
};

/// A slow wave across a stroke, so that no two strokes are alike.
struct Wobble {
    double size{};    ///< amplitude (m)
    double waves{};   ///< waves within the stroke
    double begins{};  ///< phase at its start (rad)
    static constexpr auto fields() {
        return std::tuple(ecs::field("size", &Wobble::size), ecs::field("waves", &Wobble::waves),
                          ecs::field("begins", &Wobble::begins));
    }
};

/// Plan of a bot to cast a spell by a stroke.
struct CastPlan {
    DrawingStyle style{};
    Tick began{};            ///< tick at which the bot presses Trace
    Tick lasts{};            ///< ticks of the stroke itself; 0: the bot does not draw
    Tick not_before{};       ///< tick before which the bot considers no other spell
    Tick no_thing_before{};  ///< tick before which the bot calls no thing back
    Wobble right{}, up{};
    double scale{};                          ///< size of the stroke relative to the template
    std::int32_t given_right{}, given_up{};  ///< mouse counts so far
    std::uint32_t spell{};                   ///< index in MatchData::spells
    std::uint32_t stroke{};                  ///< number of the gesture's template
    static constexpr std::string_view name = "Caster";
    static constexpr auto fields() {
        using C = CastPlan;
        return std::tuple(ecs::field("style", &C::style), ecs::field("began", &C::began),
                          ecs::field("lasts", &C::lasts), ecs::field("not_before", &C::not_before),
                          ecs::field("no_thing_before", &C::no_thing_before), ecs::field("right", &C::right),
                          ecs::field("up", &C::up), ecs::field("scale", &C::scale),
                          ecs::field("given_right", &C::given_right), ecs::field("given_up", &C::given_up),
                          ecs::field("spell", &C::spell), ecs::field("stroke", &C::stroke));
    }
};

/// The bot's own wizard, as the bot knows it.
struct Self {
    vec3 centre{}, eye{}, velocity{};
    double yaw{}, pitch{};
    double health{};             ///< health left (HP)
    Tick hit_at{};               ///< tick at which the foe last hurt the bot; 0: never
    vec3 tip{};                  ///< position of the wand's tip (m, world)
    double energy_share{};       ///< energy of the wand in hand as a share of its cap
    double readiness{};          ///< readiness of the wand in hand, 0 to 1
    ShotKind shot{};             ///< next shot of the wand in hand
    std::uint32_t wand{};        ///< slot of the wand in hand
    bool can_shoot = false;      ///< whether there is energy for that shot
    std::optional<vec3> held{};  ///< point that the wand in hand holds or hangs on (m, world)
    std::uint32_t key{};
    bool alive = false;
};

}  // namespace thaum::game
