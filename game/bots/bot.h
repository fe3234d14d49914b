// game/bots/bot.h: an opponent that plays through a device, as a person does.
//
// A bot sees what a player could see: things in its field of view that nothing hides, with a delay. It
// decides and gives one device sample a tick. Bots belong to the devices, not to the match: the log holds
// their samples, and a replay runs without them. Their state is kept in a World of its own, so that a match
// with bots can be saved and continued.
#pragma once
#include <memory>
#include <string_view>

#include "core/bytes.h"
#include "game/match/simulation.h"

namespace thaum::game::inline bots {

/// Skill in the use of a wand that takes up and throws loose things.
struct LiftSkill {
    double share{};          ///< share of opportunities at which the bot takes something up; 0: never
    double seek{};           ///< longest way that the bot walks to a thing to take it up (m)
    double largest{};        ///< largest size of a thing, from its middle to its corners (m)
    double lead{};           ///< share of the foe's motion that a throw takes into account
    double within{};         ///< angle between present and wanted throw below which the bot throws (rad)
    Tick hold{};             ///< ticks for which the bot waits for a good throw
    Tick rest{};             ///< mean time between taking up two things (ticks)
    std::uint32_t guards{};  ///< 1: while shots come, the bot holds a thing as a shield
    std::uint32_t spare{};
    THAUM_FIELDS(LiftSkill, share, seek, largest, lead, within, hold, rest, guards, spare);
};

/// Skill in stirring the cauldron.
struct StirSkill {
    double share{};  ///< share of opportunities at which the bot goes to the cauldron; 0: never
    double seek{};   ///< longest way that the bot walks to the cauldron (m)
    Tick hold{};     ///< largest time of stirring (ticks)
    Tick rest{};     ///< time between two visits to the cauldron (ticks)
    /// Share of the opportunities without a foe in sight at which the bot brews a potion; 0: never.
    double brew{};
    THAUM_FIELDS(StirSkill, share, seek, hold, rest, brew);
};

/// Skill in casting spells by strokes.
struct CastSkill {
    double share{};   ///< share of occasions at which the bot casts; 0: never
    double force{};   ///< mean force of a stroke (N); more is faster
    double jitter{};  ///< size of random deviations of a stroke, as a share of the stroke's size
    double harsh{};   ///< share of strokes that are drawn with much force, for a stronger (harsh) spell
    THAUM_FIELDS(CastSkill, share, force, jitter, harsh);
};

/// Skill at an edge from which a fall hurts.
struct EdgeSkill {
    double panic{};     ///< health below which the bot panics under fire (HP); 0: never
    double heedless{};  ///< share of side steps in a panic for which the bot ignores edges
    THAUM_FIELDS(EdgeSkill, panic, heedless);
};

/// Skill of a bot, from assets/bots/NAME.toml; level_1.toml describes each number.
struct BotSkill {
    std::uint32_t level{};
    std::uint32_t dodges{};  ///< 1: the bot steps out of the way of bolts that it sees coming
    std::uint32_t arcs{};    ///< 1: the bot throws missiles that fly on a parabola
    std::uint32_t spare{};
    Tick reaction{};         ///< ticks from seeing to acting
    double aim_error{};      ///< standard deviation of the aiming error (rad)
    double turn_speed{};     ///< largest turning speed (rad/s)
    double view_cos{};       ///< cosine of half the bot's field of view
    Tick burst{}, rest{};    ///< ticks of fire in a burst, and ticks between bursts
    double keep{}, range{};  ///< preferred distance to the foe, and largest distance of shots (m)
    double lead{};           ///< share of the foe's motion that the aim takes into account
    double strafe{};         ///< share of a fight in which the bot steps sideways
    Tick strafe_step{};      ///< ticks after which the bot may change its sideways step
    double vial_below{};     ///< health below which the bot walks to power-ups that give health (HP)
    double spark_below{};    ///< share of the wand's energy below which the bot fetches energy (a spark)
    double reserve{};        ///< share of the energy that the bot keeps for a near foe
    double cover_below{};    ///< health below which the bot hides if there is nothing to fetch (HP)
    /// Share of the choices of a wand in which the bot takes a slow one, which must be charged or drawn
    /// before it shoots.
    double variety{};
    double charge{};      ///< largest charge of a slow wand, or draw of one drawn like a bow, 0 to 1
    double throws{};      ///< share of the choices of a slow wand that take one whose shots fly on a parabola
    double over_cover{};  ///< probability, in each gameplay tick, to throw over what hides the foe
    LiftSkill lift{};
    StirSkill stir{};
    EdgeSkill edge{};
    CastSkill cast{};
    /// Length of the walk that swinging over a gap must save (m); 0: the bot never swings.
    double swing_gain{};
    THAUM_FIELDS(BotSkill, level, dodges, arcs, spare, reaction, aim_error, turn_speed, view_cos, burst, rest,
                 keep, range, lead, strafe, strafe_step, vial_below, spark_below, reserve, cover_below,
                 variety, charge, throws, over_cover, lift, stir, edge, cast, swing_gain);
};

/// Device by which the bot of a name plays. Its motion is given in counts, like that of a mouse.
input::DeviceSpec bot_device(std::uint32_t player, std::string_view name);

/// All bots of a match.
class Bots {
public:
    Bots();
    ~Bots();
    Bots(Bots&&) noexcept;
    Bots& operator=(Bots&&) noexcept;

    /// Adds a bot that plays `player`. The bot fills the samples of device number `device` in the match's
    /// input frames.
    void add(const Simulation& match, std::size_t device, std::uint32_t player, const BotSkill& skill,
             std::uint64_t seed);
    bool empty() const;
    /// Fills the samples of all bots for the next tick of the match.
    void sample(const Simulation& match, input::InputFrame& frame);

    void save(Bytes& out) const;
    Expected<void> restore(std::span<const std::byte> snapshot);

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace thaum::game::inline bots
