// tools/bench/match_scene.h: matches to measure, and helpers for timing them.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "game/bots/duel.h"
#include "game/match/simulation.h"

namespace thaum::bench {

double mean(const std::vector<double>& samples);
/// Median time of a run (us).
double median_of(std::size_t count, const std::function<void()>& run);

/// Prints on standard error why the report has no row for `what`.
void say_why_not(std::string_view what, const Error& error);
template <class T>
bool there(const Expected<T>& value, std::string_view what) {
    if (!value) say_why_not(what, value.error());
    return value.has_value();
}

/// Data for a match that cannot end while it is measured. Null if they could not be loaded; the reason was
/// then printed.
std::shared_ptr<const game::MatchData> duel_data(std::vector<std::string> overrides = {},
                                                 const std::string& arena = game::DataChoice{}.arena);

/// A duel of those bots that need the most work in each tick, in a match that cannot end (duel_data).
Expected<game::BotDuel> heaviest_duel();

/// A match with two scripted wizards, or with no input at all.
struct SceneMatch {
    std::unique_ptr<game::Simulation> match;
    input::InputFrame frame;  ///< input of both players, the same in every tick until it is changed

    void run(Tick count);
    ecs::SystemCount counted(std::string_view system) const;
};

/// Makes a match in which everything has come to rest, and times its systems.
std::optional<SceneMatch> idle_match(std::vector<std::string> overrides = {});

void place(game::Simulation& match, std::uint32_t player, vec3 at, double yaw, double pitch);

}  // namespace thaum::bench
