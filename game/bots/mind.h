// game/bots/mind.h: memory, goals and plans of a bot, as components of the bots' own World.
#pragma once
#include "game/bots/bot.h"
#include "game/components/potions.h"

namespace thaum::game::inline bots {

inline constexpr std::size_t bot_memory = 128;  ///< number of remembered observations of the foe; one every 8
                                                ///< ms, so one second
inline constexpr std::size_t max_power_ups = 16;  ///< number of power-ups that a bot remembers
inline constexpr std::size_t max_things = 32;     ///< number of loose things that a bot remembers

/// Observation of the foe in one gameplay tick.
struct Glimpse {
    vec3 chest{};  ///< position of the foe's chest (m, world)
    std::uint64_t seen{};
    THAUM_FIELDS(Glimpse, chest, seen);
};

/// A loose thing and the position at which the bot saw it last.
struct Sighting {
    ecs::Entity thing{};
    vec3 place{};  ///< position at which the bot saw the thing last (m, world)
    THAUM_FIELDS(Sighting, thing, place);
};

/// Player, device and skill of a bot.
struct Seat {
    std::uint64_t device{};
    std::uint32_t player{};
    std::uint32_t spare{};
    BotSkill skill{};
    THAUM_COMPONENT(Seat, device, player, spare, skill);
};

/// Visual memory of a bot.
struct Eyes {
    std::uint64_t looks{};
    std::array<Glimpse, bot_memory> glimpses{};
    std::array<Tick, max_power_ups> back_at{};  ///< tick at which each power-up will be back, as last seen
    std::array<Sighting, max_things> things{};
    THAUM_COMPONENT(Eyes, looks, glimpses, back_at, things);
};

/// Purpose for which a bot walks to mind.goal instead of fighting.
enum class Errand : std::uint32_t { none, fetch, hide, lift, stir };

/// Present beliefs, goals and controls of a bot.
struct Mind {
    Random random;
    vec3 foe{};                        ///< presumed position of the foe's chest (m, world)
    vec3 foe_velocity{};               ///< velocity of the foe as the bot saw it (m/s)
    Tick foe_seen_at{};                ///< tick at which the foe was last seen; 0: never
    double error_right{}, error_up{};  ///< present error of the aim, to the right and upwards (rad)
    vec3 goal{};                       ///< place to which the bot walks (m, world)
    Tick goal_until{};                 ///< tick at which the bot chooses another goal
    Tick errand_until{};               ///< tick until which the bot hides (Errand::hide)
    Tick fire_from{}, fire_until{};    ///< beginning and end of the latest burst of fire (ticks)
    Tick strafe_until{};               ///< tick until which the bot keeps its sideways step
    Tick slow_since{};                 ///< tick since which the bot has been slower than intended
    Tick stranded_since{};  ///< tick since which the bot has stood outside of the large connected regions of
                            ///< the ground
    Tick dodge_until{};     ///< tick until which a stuck bot walks sideways to get free
    Tick wand_until{};      ///< tick until which the bot keeps its choice of wand
    double readiness{};     ///< how far the bot charges the chosen wand, or draws it like a bow, 0 to 1
    Errand errand{};
    std::int32_t strafe{};          ///< direction of the sideways step: -1 left, 0 none, 1 right
    std::int32_t wishes_to_move{};  ///< 1: the bot means to walk
    /// Mouse counts by which the bot has still to turn its view before its next gameplay tick
    std::int32_t right_left{}, up_left{};
    std::int32_t move_strafe{}, move_forward{};  ///< input for walking sideways and forward, -127 to 127
    std::uint32_t buttons{};                     ///< buttons that are down (bits of input::Button)
    std::uint32_t round{};                       ///< round of the bot's latest gameplay tick
    std::uint32_t wand{};                        ///< slot of the chosen wand
    std::int32_t trigger{255};                   ///< value of the trigger while fire is down, 0 to 255
    std::uint32_t wand_key{};                    ///< wand whose key is down, 1 to wand_slots; 0: none
    std::uint32_t heedless{};                    ///< 1: in its present side step the bot ignores edges
    std::uint32_t spare{};
    THAUM_COMPONENT(Mind, random, foe, foe_velocity, foe_seen_at, error_right, error_up, goal, goal_until,
                    errand_until, fire_from, fire_until, strafe_until, slow_since, stranded_since,
                    dodge_until, wand_until, readiness, errand, strafe, wishes_to_move, right_left, up_left,
                    move_strafe, move_forward, buttons, round, wand, trigger, wand_key, heedless, spare);
};

/// Stages of lifting a loose thing: walk to it, take it up, hold it.
enum class LiftStage : std::uint32_t { none, approach, take, hold };

/// Plan of a bot for one loose thing.
struct LiftPlan {
    ecs::Entity thing{};
    vec3 place{};                  ///< position at which the bot last saw the thing to lift (m, world)
    Tick until{};                  ///< tick at which the bot gives up the present stage of lifting
    Tick not_before{};             ///< tick before which the bot chooses no other thing to lift
    Tick shots_from{}, shot_at{};  ///< ticks of the first and the last shot that the bot saw coming
    double off_left{}, off_up{};   ///< angles from the crosshair to the thing as it was taken up (rad)
    LiftStage stage{};
    std::uint32_t spare{};
    THAUM_COMPONENT(LiftPlan, thing, place, until, not_before, shots_from, shot_at, off_left, off_up, stage,
                    spare);
};

/// Stages of a swing: walk to the edge, aim at the anchor (the point to which the rope attaches), hang on the
/// rope, fly on.
enum class SwingStage : std::uint32_t { none, approach, aim, hang, fly };

/// Plan of a bot to swing over a gap.
struct SwingPlan {
    /// Take-off (feet), point to which the rope attaches, landing (feet) (m, world)
    vec3 from{}, anchor{}, to{};
    Tick until{};  ///< tick at which the bot gives up the present stage of the swing
    Tick not_before{};
    SwingStage stage{};
    std::uint32_t spare{};
    THAUM_COMPONENT(SwingPlan, from, anchor, to, until, not_before, stage, spare);
};

/// Stages at the cauldron: walk to a niche (a place of ingredients), walk to the cauldron's rim, stir.
enum class StirStage : std::uint32_t { none, approach, stir, fetch };

/// Plan of a bot at the cauldron.
struct StirPlan {
    Tick until{};       ///< tick at which the bot gives up or stops stirring
    Tick not_before{};  ///< tick before which the bot does not go to the cauldron again
    double health{};    ///< health of the bot when it began to stir (HP)
    StirStage stage{};
    std::uint32_t recipe{no_potion};  ///< recipe that the bot brews; no_potion: it only stirs
    std::uint32_t dropped{};          ///< number of ingredients that the bot has seen in its brew
    std::uint32_t stroke{};           ///< number of strokes done when the present one began
    Tick drawing_from{};              ///< tick at which the present stroke began; 0: the bot draws none
    Tick drawing_until{};    ///< tick at which the bot releases the button Trace, which ends the stroke
    Tick hands_off_until{};  ///< tick before which the bot begins no stroke and drops nothing
    std::uint32_t drops{};   ///< 1: the bot presses fire over the brew, to drop its ingredient
    std::uint32_t spare{};
    THAUM_COMPONENT(StirPlan, until, not_before, health, stage, recipe, dropped, stroke, drawing_from,
                    drawing_until, hands_off_until, drops, spare);
};

/// How a bot distorts the strokes that it draws, like a person's handwriting; fixed for each bot.
struct DrawingStyle {
    double size{1};                  ///< size of strokes, as a multiple of the recorded strokes
    double aspect{1};                ///< factor on the width of strokes relative to their height
    double slant{};                  ///< shear of strokes: displacement in x per y
    double cos_tilt{1}, sin_tilt{};  ///< cosine and sine of the angle by which strokes are turned in their
                                     ///< plane
    THAUM_FIELDS(DrawingStyle, size, aspect, slant, cos_tilt, sin_tilt);
};

/// A slow sine wave that is added to a stroke, so that no two strokes are alike.
struct Wobble {
    double size{};    ///< amplitude of the sine wave (m)
    double waves{};   ///< number of periods of the sine wave within the stroke
    double begins{};  ///< phase of the sine wave, the wobble, at the start of the stroke (rad)
    THAUM_FIELDS(Wobble, size, waves, begins);
};

/// Plan of a bot to cast a spell by a stroke.
struct CastPlan {
    DrawingStyle style{};
    Tick began{};            ///< tick at which the bot presses the button Trace, which begins the stroke
    Tick lasts{};            ///< ticks of the stroke itself; 0: the bot does not draw
    Tick not_before{};       ///< tick before which the bot considers no other spell
    Tick no_thing_before{};  ///< tick before which the bot does not call a thing back by a spell
    Wobble right{}, up{};
    double scale{};                          ///< size of the stroke, as a multiple of the recorded stroke
    std::int32_t given_right{}, given_up{};  ///< mouse counts that the hand has made so far
    std::uint32_t spell{};                   ///< index in MatchData::spells
    std::uint32_t stroke{};                  ///< number of the recorded stroke that the bot copies
    THAUM_COMPONENT(CastPlan, style, began, lasts, not_before, no_thing_before, right, up, scale, given_right,
                    given_up, spell, stroke);
};

/// The bot's own wizard, as the bot knows it.
struct Self {
    vec3 centre{}, eye{}, velocity{};
    double yaw{}, pitch{};
    vec3 ahead{};                ///< direction of view (unit, world)
    double health{};             ///< health of the bot (HP)
    Tick hit_at{};               ///< tick at which the foe last hurt the bot; 0: never
    vec3 tip{};                  ///< position of the wand's tip (m, world)
    double energy_share{};       ///< energy of the wand in hand as a share of its cap
    double readiness{};          ///< how far the wand in hand is charged, or drawn like a bow, 0 to 1
    ShotKind shot{};             ///< how the next shot of the wand in hand would fly
    std::uint32_t wand{};        ///< slot of the wand in hand
    bool can_shoot = false;      ///< true: there is energy for the next shot
    std::optional<vec3> held{};  ///< point that the wand in hand holds or hangs on (m, world)
    std::uint32_t key{};
    bool alive = false;
};

}  // namespace thaum::game::inline bots
