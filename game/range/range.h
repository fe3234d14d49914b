// game/range/range.h: the shooting range: a match of a practising player (player 0) and a dummy (player 1).
// No round ends, no player wins, and a dead wizard returns. Wands and shots are as in any match. Nothing is
// recorded, so the data files may change while the match runs (range_files.h).
#pragma once
#include <filesystem>

#include "game/range/apprentice.h"

namespace thaum::game::inline range {

/// Data of a practice range.
struct RangeData {
    /// Data of the match; its `files` lists all files that were read.
    std::shared_ptr<const MatchData> match;
    DummyRules dummy;
};

/// Changes of a practice range's rules that a practising player chooses. The alignment lets every compiler
/// store both flags in one atomic word.
struct alignas(2) RangeChanges {
    bool endless_energy = false;  ///< true: wands are always full of energy
    bool harmless_brew = false;   ///< true: the brew neither slows, lifts nor hurts wizards
    bool operator==(const RangeChanges&) const = default;
};
/// The data with these changes applied.
RangeData changed(const RangeData& data, const RangeChanges& changes);

/// Reads the data of a match and assets/range.toml. The round length and kill limit of `choice.match` are
/// ignored. No useful brew boils over, and ingredients return at once. The error names file, line and key.
Expected<RangeData> load_range(const std::filesystem::path& assets, const DataChoice& choice);

/// Description of the dummy's device: no hardware, but input that the program computes, as for a bot.
input::DeviceSpec dummy_device();

/// A running range: the match and its dummy.
struct RangeMatch {
    std::unique_ptr<Simulation> match;
    Dummy dummy;

    /// Plays one tick with the practising player's sample.
    void tick(const input::DeviceSample& sample);
    /// Continues with other data from the next tick on. Both wizards keep their positions.
    void adopt(const RangeData& data);
    /// Continues with other gestures of the practising player. The error says which gesture does not suit the
    /// data.
    Expected<void> use_gestures(std::vector<input::ProfileData> profile);
};

/// Gives health (HP) to a living wizard, at most up to that of a new wizard. Allowed on the practice range
/// only, because its matches are not recorded.
void heal_wizard(Simulation& match, std::uint32_t player, double points);

/// Ends what a living wizard's wand does, such as holding a thing, and gives the wizard full health.
void refresh_wizard(Simulation& match, std::uint32_t player);

/// Refreshes a living wizard, and moves it to a position and direction of view: at rest, not stirring, with
/// empty hands.
void place_wizard(Simulation& match, std::uint32_t player, const LessonPlace& place);

/// Makes a running range. `more`: further devices, such as arms. If a recorded gesture in `profile` does not
/// suit the data, none of them is used.
RangeMatch make_range(const RangeData& data, const input::DeviceSpec& device, DummyKind kind,
                      std::uint64_t seed, std::vector<input::DeviceSpec> more = {},
                      std::vector<input::ProfileData> profile = {});

/// Results of the practising player since the score was last reset.
struct RangeScore {
    std::uint32_t shots{}, hits{}, kills{};
    double damage{};   ///< harm to the dummy (HP)
    double minutes{};  ///< time since the first shot, or since the score was reset (min)
    double damage_per_minute() const { return minutes > 0 ? damage / minutes : 0; }
};

/// Computes the score since the last reset.
class RangeScorer {
public:
    /// Resets the score to zero.
    void reset(const Simulation& match);
    RangeScore score(const Simulation& match);

private:
    RangeScore before_{};
    Tick began_{};  ///< beginning of the time for which the score counts (ticks of play)
};

/// Text of a score: "12 of 64 hit (19 %), 72 HP, 1 kill, 188 HP a minute".
std::string words_of(const RangeScore& score);

}  // namespace thaum::game::inline range
