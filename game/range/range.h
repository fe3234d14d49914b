// game/range/range.h: the shooting range: a match of a practising player (player 0) and a dummy (player 1). No
// round ends, no player wins, and a dead wizard returns. Wands and their shots are those of any match.
// Nothing is recorded, so the data may change while the match runs (range_files.h).
#pragma once
#include <filesystem>

#include "game/range/apprentice.h"

namespace thaum::game {

/// Data of a range.
struct RangeData {
    std::shared_ptr<const MatchData> match;  ///< its `files` lists all files that were read
    DummyRules dummy;
};

/// Changes of a range's rules that a practising player chooses. The alignment makes them one atomic word for
/// every compiler.
struct alignas(2) RangeChanges {
    bool endless_energy = false;  ///< wands are always full
    bool harmless_brew = false;   ///< the brew does nothing to wizards
    bool operator==(const RangeChanges&) const = default;
};
/// The same data with these changes.
RangeData changed(const RangeData& data, const RangeChanges& changes);

/// Reads the data of a match and assets/range.toml. The round length and kill limit of `choice.match` are
/// ignored. No brew spoils, and ingredients are back at once. The error names file, line and key.
Expected<RangeData> load_range(const std::filesystem::path& assets, const DataChoice& choice);

/// Device of the dummy. Its counts are those of a bot.
input::DeviceSpec dummy_device();

/// A running range: the match and its dummy.
struct RangeMatch {
    std::unique_ptr<Simulation> match;
    Dummy dummy;

    /// Plays one tick with the practising player's sample.
    void tick(const input::DeviceSample& sample);
    /// Continues with other data from the next tick on. Both wizards stay where they are.
    void adopt(const RangeData& data);
    /// Continues with other gestures of the practising player. The error says which does not fit.
    Expected<void> use_gestures(std::vector<input::ProfileData> profile);
};

/// Gives a living wizard health (HP), up to that of a new wizard. Only the range may do so, as it is not recorded.
void heal_wizard(Simulation& match, std::uint32_t player, double points);

/// Puts away what a living wizard's wand holds, and gives the wizard full health.
void refresh_wizard(Simulation& match, std::uint32_t player);

/// Refreshes a living wizard, and puts it to a place and direction of view: at rest, not stirring, with empty hands.
void place_wizard(Simulation& match, std::uint32_t player, const LessonPlace& place);

/// `more` are further devices, such as arms. Own gestures in `profile` that do not fit the data are left out.
RangeMatch make_range(const RangeData& data, const input::DeviceSpec& device, DummyKind kind,
                      std::uint64_t seed, std::vector<input::DeviceSpec> more = {},
                      std::vector<input::ProfileData> profile = {});

/// Results of the practising player since the score was last reset.
struct RangeScore {
    std::uint32_t shots{}, hits{}, kills{};
    double damage{};   ///< harm done (HP)
    double minutes{};  ///< time since the first shot (min)
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
    Tick began_{};  ///< start of the time that is scored (ticks of play)
};

/// Text of a score: "12 of 64 hit (19 %), 72 HP, 1 kill, 188 HP a minute".
std::string words_of(const RangeScore& score);

}  // namespace thaum::game
