// unit/replay_rig.h: a recorded duel with kills and a pause, and its hash after every tick.
#pragma once
#include <unistd.h>

#include "core/file.h"
#include "game/match/replay_index.h"
#include "unit/game_duel.h"

namespace thaum::game::test {

/// Ticks at which a player presses the pause button: the first press pauses the match, the second one
/// continues it.
constexpr Tick paused_at = 2040, resumed_at = 2300;

/// The log of a duel in which bolts kill quickly. The file is removed after the test.
struct RecordedDuel {
    /// `twisted`: from this tick on the recorded hashes are wrong, as if the program had computed another
    /// match.
    explicit RecordedDuel(std::string_view name, Tick ticks, std::optional<Tick> twisted = {})
        : path(folder.path() / name), length(ticks) {
        auto duel =
            make_bot_duel(assets(), duel_data({"bolt.shot.damage=100"}), {"level_3", "level_3"}, 5).value();
        auto& match = *duel.match;
        auto log = input::LogWriter::create(path, log_header(match.data(), match.setup(), {"bot 3", "bot 3"}),
                                            input::WhenBehind::wait)
                       .value();
        hashes.push_back(match.state_hash());
        for (Tick t = 0; t < length; ++t) {
            auto frame = duel.next_frame();
            if (t == paused_at || t == resumed_at) frame.devices[0].press(input::Button::pause);
            match.tick(frame);
            log.append(frame);
            hashes.push_back(match.state_hash());
            const auto wrong = std::uint64_t{twisted && match.now() >= *twisted};
            if (match.now() % hash_interval == 0)
                log.append_hash(match.now(), match.state_hash() + wrong, match.force_hash());
        }
        result = result_line(match);
        EXPECT_TRUE(log.close(result));
    }
    Playback opened() const { return Playback::open(path, assets()).value(); }

    const TemporaryFolder folder{};
    const std::filesystem::path path;
    Tick length;
    std::vector<std::uint64_t> hashes{};  ///< hashes[t]: hash of the state after t ticks
    std::string result{};
};

inline const std::atomic<bool> never{false};

}  // namespace thaum::game::test
