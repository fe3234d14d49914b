// bench/match_scene.h: matches that are measured, and the clock they are measured by.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/match/simulation.h"

namespace thaum::bench {

double mean(const std::vector<double>& samples);
/// us
double median_of(std::size_t count, const std::function<void()>& run);

/// Says on stderr why `what` has no row.
void say_why_not(std::string_view what, const Error& error);
template <class T>
bool there(const Expected<T>& value, std::string_view what) {
    if (!value) say_why_not(what, value.error());
    return value.has_value();
}

/// Of a match that cannot end while it is measured. Null: there is none, and it was said why.
std::shared_ptr<const game::MatchData> duel_data(std::vector<std::string> overrides = {});

/// Two wizards whom a bench moves, or nobody.
struct SceneMatch {
    std::unique_ptr<game::Simulation> match;
    input::InputFrame frame;  ///< the same in every tick

    void run(Tick count);
    ecs::SystemCount counted(std::string_view system) const;
};

/// All has come to rest; systems are timed.
std::optional<SceneMatch> idle_match(std::vector<std::string> overrides = {});

void place(game::Simulation& match, std::uint32_t player, vec3 at, double yaw, double pitch);

}  // namespace thaum::bench
