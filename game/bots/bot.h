// game/bots/bot.h: an opponent that plays through a device, as a person does.
//
// A bot sees what a player could see: things in its field of view that nothing hides, with a delay. It
// decides and gives one device sample a tick. Bots belong to the devices, not to the match: the log holds
// their samples, and a replay runs without them. Their state is kept in a World of its own, so that a match
// with bots can be saved and continued.
#pragma once
#include <filesystem>
#include <memory>

#include "core/bytes.h"
#include "core/config.h"
#include "game/match/simulation.h"

namespace thaum::game {

/// Lowest and highest level.
inline constexpr int easiest_bot = 0, hardest_bot = 3;

/// Skill in the use of a wand that takes up loose things.
struct LiftSkill {
    double share{};          ///< share of opportunities at which the bot takes something up; 0: never
    double seek{};           ///< largest walk to a thing (m)
    double largest{};        ///< largest distance from a thing's middle to its corners (m)
    double lead{};           ///< share of the foe's motion that a throw takes into account
    double within{};         ///< angle between present and wanted throw below which the bot throws (rad)
    Tick hold{};             ///< ticks for which the bot waits for a good throw
    Tick rest{};             ///< mean ticks between two things
    std::uint32_t guards{};  ///< 1: holds a thing as a shield while shots come
    std::uint32_t spare{};
    static constexpr auto fields() {
        using S = LiftSkill;
        return std::tuple(
            ecs::field("share", &S::share), ecs::field("seek", &S::seek), ecs::field("largest", &S::largest),
            ecs::field("lead", &S::lead), ecs::field("within", &S::within), ecs::field("hold", &S::hold),
            ecs::field("rest", &S::rest), ecs::field("guards", &S::guards), ecs::field("spare", &S::spare));
    }
};

/// Skill in stirring the cauldron.
struct StirSkill {
    double share{};  ///< share of opportunities at which the bot goes to the cauldron; 0: never
    double seek{};   ///< largest walk to the cauldron (m)
    Tick hold{};     ///< largest time of stirring (ticks)
    Tick rest{};     ///< time between two visits (ticks)
    double
        brew{};  ///< share of the opportunities without a foe in sight at which it brews a potion; 0: never
    static constexpr auto fields() {
        using S = StirSkill;
        return std::tuple(ecs::field("share", &S::share), ecs::field("seek", &S::seek),
                          ecs::field("hold", &S::hold), ecs::field("rest", &S::rest),
                          ecs::field("brew", &S::brew));
    }
};

/// Skill in casting spells by strokes.
struct CastSkill {
    double share{};   ///< share of occasions at which the bot casts; 0: never
    double force{};   ///< mean force of a stroke (N); more is faster
    double jitter{};  ///< size of the deviations of a stroke (share of its size)
    double harsh{};   ///< share of strokes that are drawn harshly
    static constexpr auto fields() {
        using S = CastSkill;
        return std::tuple(ecs::field("share", &S::share), ecs::field("force", &S::force),
                          ecs::field("jitter", &S::jitter), ecs::field("harsh", &S::harsh));
    }
};

/// Behaviour at an edge from which a fall hurts.
struct EdgeSkill {
    double panic{};     ///< health below which the bot panics under fire (HP); 0: never
    double heedless{};  ///< share of side steps in a panic that heed no edge
    static constexpr auto fields() {
        return std::tuple(ecs::field("panic", &EdgeSkill::panic),
                          ecs::field("heedless", &EdgeSkill::heedless));
    }
};

/// Skill of a bot, from assets/bots/level_N.toml, which describes each number.
struct BotSkill {
    std::uint32_t level{};
    std::uint32_t dodges{};  ///< 1: steps out of the way of bolts that it sees coming
    std::uint32_t arcs{};    ///< 1: throws missiles that fly on a parabola
    std::uint32_t spare{};
    Tick reaction{};         ///< ticks from seeing to acting
    double aim_error{};      ///< standard deviation of the aim (rad)
    double turn_speed{};     ///< largest turning speed (rad/s)
    double view_cos{};       ///< cosine of half its field of view
    Tick burst{}, rest{};    ///< ticks of fire in a burst, and ticks between bursts
    double keep{}, range{};  ///< preferred distance to the foe, and largest distance of shots (m)
    double lead{};           ///< share of the foe's motion that the aim takes into account
    double strafe{};         ///< share of a fight in which the bot steps sideways
    Tick strafe_step{};      ///< ticks after which the bot may change its step
    double vial_below{};     ///< health below which the bot walks to power-ups that give health (HP)
    double spark_below{};    ///< share of the wand's energy below which the bot walks to a spark
    double reserve{};        ///< share of the energy that the bot keeps for a near foe
    double cover_below{};    ///< health below which the bot hides if there is nothing to fetch (HP)
    double variety{};        ///< share of choices that are a wand which is readied first
    double charge{};         ///< largest readiness of such a wand, 0 to 1
    double throws{};         ///< share of these choices that are a wand which throws on a parabola
    double over_cover{};     ///< chance in each gameplay tick to throw over what hides the foe
    LiftSkill lift{};
    StirSkill stir{};
    EdgeSkill edge{};
    CastSkill cast{};
    double swing_gain{};  ///< length of way that a rope over a gap must save (m); 0: never swings
    static constexpr auto fields() {
        using S = BotSkill;
        return std::tuple(
            ecs::field("level", &S::level), ecs::field("dodges", &S::dodges), ecs::field("arcs", &S::arcs),
            ecs::field("spare", &S::spare), ecs::field("reaction", &S::reaction),
            ecs::field("aim_error", &S::aim_error), ecs::field("turn_speed", &S::turn_speed),
            ecs::field("view_cos", &S::view_cos), ecs::field("burst", &S::burst),
            ecs::field("rest", &S::rest), ecs::field("keep", &S::keep), ecs::field("range", &S::range),
            ecs::field("lead", &S::lead), ecs::field("strafe", &S::strafe),
            ecs::field("strafe_step", &S::strafe_step), ecs::field("vial_below", &S::vial_below),
            ecs::field("spark_below", &S::spark_below), ecs::field("reserve", &S::reserve),
            ecs::field("cover_below", &S::cover_below), ecs::field("variety", &S::variety),
            ecs::field("charge", &S::charge), ecs::field("throws", &S::throws),
            ecs::field("over_cover", &S::over_cover), ecs::field("lift", &S::lift),
            ecs::field("stir", &S::stir), ecs::field("edge", &S::edge), ecs::field("cast", &S::cast),
            ecs::field("swing_gain", &S::swing_gain));
    }
};

/// Reads the part of a skill that concerns aiming and shooting, from a level's file or the range's:
/// reaction_s, aim_error_deg, turn_deg_per_s, view_deg, burst_s, rest_s, range_m.
BotSkill read_marksmanship(const ConfigTable& table);
/// Loads the skill of a level. The error is one line: a level that does not exist, or a fault in its file.
Expected<BotSkill> load_bot_skill(const std::filesystem::path& assets, int level);

/// Device of a bot. Its counts are those of a mouse.
input::DeviceSpec bot_device(std::uint32_t player, int level);

/// All bots of a match.
class Bots {
public:
    Bots();
    ~Bots();
    Bots(Bots&&) noexcept;
    Bots& operator=(Bots&&) noexcept;

    /// Adds a bot for `player`, which fills the samples of device number `device` in the match's input
    /// frames.
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

}  // namespace thaum::game
