// game/bots/balance.h: what decides a match beside the wands: which sources of magic the players use, and how
// many kills are made by magic. It is counted from the events of a match alone, so any match can be counted.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "game/components/match.h"

namespace thaum::game::inline bots {

/// Sources of magic. The pot is the cauldron; its magic are potions and what a brew does by itself.
enum class Magic : std::uint8_t { pot, spells, orb, crystal };
inline constexpr std::array<std::string_view, 4> magic_names{"pot", "spells", "orb", "crystal"};
inline constexpr std::size_t magic_sources = magic_names.size();

/// Health that a victim lost last before dying (HP), by which a kill is judged.
inline constexpr double judged_health = 30;
/// Time after casting a spell, and after being pushed by one, for which blows count as under a spell (ticks):
/// as long as the spells Shield and Fog last as they are shipped, and as a push may throw a wizard.
inline constexpr Tick spell_acts = ticks(6), push_acts = ticks(2);

struct KillCount {
    Tick waited{};  ///< ticks of play since the last kill of the round, or since its beginning
    bool magic{};   ///< at least half of the `judged_health` was lost by magic or under it
};

/// What was counted in one round.
struct RoundCount {
    /// Whether each player used each source: whether it healed the player, held off a blow or pushed the foe,
    /// or a blow fell while it acted for the player who struck, or a potion for the player who was struck.
    std::array<std::array<bool, magic_sources>, 2> used{};
    std::vector<KillCount> kills;  ///< only deaths that are credited to the other player
    /// How often the other player came to have more kills. A death of one's own making takes one away, as in
    /// the score.
    std::uint32_t lead_changes{};
};

/// Counts the rounds of one match from its events, in the order of their ticks. The first round begins at
/// tick 0 of play, each other one with its event.
class BalanceCounter {
public:
    void note(const Event& event);
    /// What has been counted since the present round began.
    const RoundCount& round() const { return count_; }

private:
    struct Harm {
        double points{};
        bool magic{};
    };
    /// Magic that acts on a wizard, or that the wizard holds.
    struct Enchantment {
        Tick potion_until{}, spell_until{}, pushed_until{};
        bool lens{};  // also true while the Great Work goes on, since that needs the Lens
    };

    bool use(std::uint32_t player, Magic source);
    void note_blow(const Event& blow);
    void note_death(const Event& death);

    RoundCount count_;
    Tick last_kill_{};
    std::array<int, 2> score_{};
    std::uint32_t leader_{no_player};
    std::array<Enchantment, 2> acting_{};
    std::array<std::vector<Harm>, 2> harms_{};  // what each wizard lost last, the newest at the end
};

}  // namespace thaum::game::inline bots
