// game/bots/bot.h: an opponent that plays through a device, as a person does.
//
// A bot sees what a player could see (things in its field of view and not behind others, with a delay), decides, and emits
// one device sample a tick. It belongs to the devices, not to the match: the log holds its samples, and a replay runs
// without it. Its mind lives in a World of its own, so that a match with bots can be saved and continued whole.
#pragma once
#include <filesystem>
#include <memory>

#include "core/bytes.h"
#include "core/config.h"
#include "game/match/simulation.h"

namespace thaum::game {

/// Levels go from 1 to this.
inline constexpr int bot_levels = 3;

/// How it uses what takes loose things up.
struct LiftSkill {
    double share{};          ///< of its chances to take something up; 0: it never does
    double seek{};           ///< m that it walks to a thing
    double largest{};        ///< m, from the middle of a thing to its corners
    double lead{};           ///< share of the foe's motion that a throw allows for
    double within{};         ///< rad: it throws when its aim is that close
    Tick hold{};             ///< ticks that it waits for the right moment
    Tick rest{};             ///< ticks between two things, about
    std::uint32_t guards{};  ///< 1: holds it before itself while shots come
    std::uint32_t spare{};
    static constexpr auto fields() {
        using S = LiftSkill;
        return std::tuple(
            ecs::field("share", &S::share), ecs::field("seek", &S::seek), ecs::field("largest", &S::largest),
            ecs::field("lead", &S::lead), ecs::field("within", &S::within), ecs::field("hold", &S::hold),
            ecs::field("rest", &S::rest), ecs::field("guards", &S::guards), ecs::field("spare", &S::spare));
    }
};

/// How it stirs.
struct StirSkill {
    double share{};  ///< of its chances to go to the cauldron; 0: it never does
    double seek{};   ///< m that it walks there
    Tick hold{};     ///< ticks that it stirs at most
    Tick rest{};     ///< ticks between two times
    static constexpr auto fields() {
        using S = StirSkill;
        return std::tuple(ecs::field("share", &S::share), ecs::field("seek", &S::seek),
                          ecs::field("hold", &S::hold), ecs::field("rest", &S::rest));
    }
};

/// From assets/bots/level_N.toml, which says what each number does.
struct BotSkill {
    std::uint32_t level{};
    std::uint32_t dodges{};  ///< 1: steps out of the way of bolts that it sees coming
    std::uint32_t arcs{};    ///< 1: throws what flies in an arc
    std::uint32_t spare{};
    Tick reaction{};         ///< ticks from light to hand
    double aim_error{};      ///< rad, one standard deviation
    double turn_speed{};     ///< rad/s
    double view_cos{};       ///< cosine of half its field of view
    Tick burst{}, rest{};    ///< ticks of fire, and between
    double keep{}, range{};  ///< m: the distance it likes, and up to which it shoots
    double lead{};           ///< share of the foe's motion that its aim allows for
    double strafe{};         ///< share of a fight in which it steps sideways
    Tick strafe_step{};      ///< ticks after which it may change its step
    double vial_below{};     ///< HP: health is worth a walk below that
    double spark_below{};    ///< share of the wand's energy: a spark is worth a walk below that
    double reserve{};        ///< share of the energy that it keeps for a foe who is near
    double cover_below{};    ///< HP: it hides below that, where there is nothing to fetch
    double variety{};        ///< share of its choices that fall on a wand that is readied first
    double charge{};         ///< how far it readies one at most, 0 to 1
    double throws{};         ///< share of these that fly in an arc
    double over_cover{};     ///< chance at a look to throw over what hides the foe
    LiftSkill lift{};
    StirSkill stir{};
    double swing_gain{};  ///< m of way that a rope over a gap must save; 0: it never swings
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
            ecs::field("stir", &S::stir), ecs::field("swing_gain", &S::swing_gain));
    }
};

/// How it aims and shoots, of a level's file or of the range's: reaction_s, aim_error_deg, turn_deg_per_s, view_deg, burst_s,
/// rest_s, range_m.
BotSkill read_marksmanship(const ConfigTable& table);
/// The error is one line: a level that does not exist, or what is wrong with its file.
Expected<BotSkill> load_bot_skill(const std::filesystem::path& assets, int level);

/// How a bot's device counts: as a mouse's.
input::DeviceSpec bot_device(std::uint32_t player, int level);

class Bots {
public:
    Bots();
    ~Bots();
    Bots(Bots&&) noexcept;
    Bots& operator=(Bots&&) noexcept;

    /// Device number `device` of the match's frames is played by a bot for `player`.
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
