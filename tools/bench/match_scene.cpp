#include "tools/bench/match_scene.h"

#include <cstdio>

#include "game/bots/bot_file.h"
#include "game/data/match_data.h"
#include "tools/bench/measure.h"

namespace thaum::bench {

using game::Simulation;

double mean(const std::vector<double>& samples) {
    double sum = 0;
    for (const double s : samples) sum += s;
    return sum / static_cast<double>(samples.size());
}

double median_of(std::size_t count, const std::function<void()>& run) {
    std::vector<double> samples;
    for (std::size_t i = 0; i < count; ++i) samples.push_back(us_of(run));
    return median(samples);
}

void say_why_not(std::string_view what, const Error& error) {
    std::fprintf(stderr, "bench: %s: %s\n", std::string(what).c_str(), error.message.c_str());
}

std::shared_ptr<const game::MatchData> duel_data(std::vector<std::string> overrides,
                                                 const std::string& arena) {
    overrides.insert(overrides.end(), {"quick.kills=1000", "quick.seconds=36000"});
    auto data =
        game::load_match_data(game::find_assets(), {.arena = arena, .overrides = std::move(overrides)});
    return there(data, "duel") ? std::make_shared<const game::MatchData>(std::move(*data)) : nullptr;
}

void SceneMatch::run(Tick count) {
    for (Tick t = 0; t < count; ++t) match->tick(frame);
}

ecs::SystemCount SceneMatch::counted(std::string_view system) const {
    const auto& schedule = match->live();
    for (std::size_t i = 0; i < schedule.size(); ++i) {
        if (schedule.system(i).name == system) return schedule.counted(i);
    }
    return {};
}

Expected<game::BotDuel> heaviest_duel() {
    auto data = duel_data();
    if (!data) return fail("the data files could not be loaded; see the message above");
    const auto bot = game::strongest_bot(game::find_assets());
    if (!bot) return bot.error();
    return game::make_bot_duel(game::find_assets(), data, {*bot, *bot}, 1);
}

std::optional<SceneMatch> idle_match(std::vector<std::string> overrides) {
    auto data = duel_data(std::move(overrides));
    if (!data) return std::nullopt;
    const input::DeviceSpec nobody{.player = 0, .kind = input::DeviceKind::script, .name = "nobody"};
    auto other = nobody;
    other.player = 1;
    SceneMatch scene{std::make_unique<Simulation>(data, game::MatchSetup{1, {nobody, other}}), {}};
    scene.match->live().timing = true;
    scene.run(6000);
    return scene;
}

void place(Simulation& match, std::uint32_t player, vec3 at, double yaw, double pitch) {
    auto& world = match.world_to_change();
    const auto wizard = game::wizard_of(world, player);
    auto& motion = world.get<game::Motion>(wizard);
    motion.position = at;
    motion.velocity = {};
    match.physics().set_state(wizard.index, motion);
    world.get<game::Gaze>(wizard) = {yaw, pitch};
}

}  // namespace thaum::bench
