// game/bots/range.h: the range: one who practises, player 0, and a dummy, player 1, in a match by its own data: no round ends,
// nobody wins or loses, who dies comes back. The wands and all they shoot with are those of any match. Nothing here is
// recorded, so its data may change while it runs (range_files.h).
#pragma once
#include <filesystem>

#include "game/bots/dummy.h"

namespace thaum::game {

inline constexpr std::uint32_t practising = 0, dummys = 1;  ///< players

struct RangeData {
    std::shared_ptr<const MatchData> match;  ///< its `files` are all that were read
    DummyRules dummy;
};

/// Reads a match's data and assets/range.toml. The length of `choice.match` means nothing here. The error names file, line
/// and key.
Expected<RangeData> load_range(const std::filesystem::path& assets, const DataChoice& choice);

/// How a dummy's device counts.
input::DeviceSpec dummy_device();

struct RangeMatch {
    std::unique_ptr<Simulation> match;
    Dummy dummy;

    /// One tick, with the sample of who practises.
    void tick(const input::DeviceSample& sample);
    /// Goes on by other data from the next tick on; both stay where they are.
    void adopt(const RangeData& data);
};

RangeMatch make_range(const RangeData& data, const input::DeviceSpec& device, DummyKind kind,
                      std::uint64_t seed, std::vector<input::DeviceSpec> more = {});

/// What who practises has done since the scores were last wiped.
struct RangeScore {
    std::uint32_t shots{}, hits{}, kills{};
    double damage{};   ///< HP
    double minutes{};  ///< since the first shot
    double damage_per_minute() const { return minutes > 0 ? damage / minutes : 0; }
};

class RangeScorer {
public:
    /// Counts from now on.
    void wipe(const Simulation& match);
    RangeScore score(const Simulation& match);

private:
    RangeScore before_{};
    Tick began_{};  ///< ticks of play
};

/// "12 of 64 hit (19 %), 72 HP, 1 kill, 188 HP a minute"
std::string words_of(const RangeScore& score);

}  // namespace thaum::game
