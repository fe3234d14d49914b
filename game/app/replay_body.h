// game/app/replay_body.h: writes the vibrations that players feel on the body during a replayed match, as a
// table. Equal logs give equal files.
#pragma once
#include <memory>
#include <string>

#include "game/live/body.h"
#include "game/live/body_sound.h"

namespace thaum::game::inline app {

class ReplayBody {
public:
    /// `sounds`: groups of sounds that are also felt, at full strength. The error is one line.
    static Expected<ReplayBody> create(const MatchData& data, const std::filesystem::path& assets,
                                       std::optional<FeltGroups> sounds);

    /// Appends a row (felt_rows.h) for each player who feels something, at every eighth tick.
    void follow(const Simulation& match, std::string& rows);

private:
    /// Data to which scenes and mixers of tactile effects keep references, so it must not move in memory.
    struct State {
        LiveBody body;
        MatchEffects effects;
        std::array<std::optional<TactileScene>, players> scenes{};
        FeltSoundWish wish{};
        std::optional<FeltCourses> courses{};
        std::optional<BodySound> sound{};
    };
    static Expected<void> add_sound(State& state, const MatchData& data, const std::filesystem::path& assets);
    explicit ReplayBody(std::unique_ptr<State> state) : state_(std::move(state)) {}

    std::unique_ptr<State> state_;
};

}  // namespace thaum::game::inline app
