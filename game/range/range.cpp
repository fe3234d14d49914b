#include "game/range/range.h"

#include <algorithm>
#include <limits>

#include "core/file.h"
#include "core/text.h"
#include "game/bots/bot_file.h"
#include "game/context/stations.h"
#include "game/match/belt.h"
#include "game/match/own_gestures.h"
#include "game/match/player/walk.h"

namespace thaum::game::inline range {
namespace {

constexpr auto range_file = "range.toml";
// A time that never comes. It is half of the largest value, so that sums with it do not overflow.
constexpr Tick never = std::numeric_limits<Tick>::max() / 2;
/// energy that a wand regains (1/s), enough to fill it within one tick
constexpr double fills_at_once = 1e6;

Expected<DummyRules> read_range(const std::filesystem::path& assets, MatchData& match) {
    const auto source = read_text_file(assets / range_file, 1U << 16U);
    if (!source) return source.error();
    const auto file = Config::parse(*source, shown_path(assets, range_file), 1);
    if (!file) return file.error();
    match.files.push_back({range_file, file->value_hash()});
    const auto root = file->root();
    match.arena.pads = {match.arena.practice[practising], match.arena.practice[dummys]};
    const DummyRules dummy{.stride = root.table("strafing").number("stride_m", {0.5, 40}),
                           .skill = read_marksmanship(root.table("shooting"))};
    if (const auto checked = file->check(); !checked) return checked.error();
    return dummy;
}

RangeScore sum_of(const Simulation& match) {
    RangeScore sum;
    for (const auto& match_stats : match.world().single<EventLog>().match_stats[practising]) {
        sum.shots += match_stats.shots;
        sum.hits += match_stats.hits;
        sum.kills += match_stats.kills;
        sum.damage += match_stats.damage;
    }
    return sum;
}

}  // namespace

Expected<RangeData> load_range(const std::filesystem::path& assets, const DataChoice& choice) {
    auto match = load_match_data(assets, choice);
    if (!match) return match.error();
    const auto dummy = read_range(assets, *match);
    if (!dummy) return dummy.error();
    match->round.kills = std::numeric_limits<std::int32_t>::max();
    match->round.length = never;
    match->round.surges.clear();
    // On the practice range, only a brew that can no longer become a potion boils over, and ingredients
    // return to their niches at once.
    if (match->cauldron) {
        match->cauldron->spoils_after = never;
        match->cauldron->niche_again = 0;
    }
    return RangeData{std::make_shared<const MatchData>(std::move(*match)), *dummy};
}

RangeData changed(const RangeData& data, const RangeChanges& changes) {
    if (changes == RangeChanges{}) return data;
    auto match = *data.match;
    if (changes.endless_energy) {
        for (auto& wand : match.wands) wand.stats.energy_regain = fills_at_once;
    }
    if (changes.harmless_brew && match.cauldron) {
        auto& brew = *match.cauldron;
        brew.aura.thick_above = std::numeric_limits<double>::max();
        brew.aura.light_below = 0;
        brew.spoil_push = brew.spoil_harm = 0;
    }
    return {std::make_shared<const MatchData>(std::move(match)), data.dummy};
}

input::DeviceSpec dummy_device() {
    auto device = bot_device(dummys, "dummy");
    device.name = "dummy";
    return device;
}

void heal_wizard(Simulation& match, std::uint32_t player, double points) {
    auto& world = match.world_to_change();
    const auto wizard = wizard_of(world, player);
    if (world.has<Dead>(wizard)) return;
    const double full = match.data().wizard.health;
    auto& health = world.get<Health>(wizard);
    if (health.points > 0 && health.points < full) health.points = std::min(full, health.points + points);
}

void refresh_wizard(Simulation& match, std::uint32_t player) {
    auto& world = match.world_to_change();
    const auto wizard = wizard_of(world, player);
    if (world.has<Dead>(wizard)) return;
    put_away_wand(match.context_to_change(), wizard, match.match().played);
    heal_wizard(match, player, match.data().wizard.health);
}

void place_wizard(Simulation& match, std::uint32_t player, const LessonPlace& place) {
    auto& world = match.world_to_change();
    const auto wizard = wizard_of(world, player);
    if (world.has<Dead>(wizard)) return;
    refresh_wizard(match, player);
    leave_station(world, wizard);
    if (world.has<Pouch>(wizard)) world.remove<Pouch>(wizard);
    world.get<Motion>(wizard) = standing_at(match.data().wizard, place.feet);
    world.get<Gaze>(wizard) = {place.yaw, place.pitch};
    world.get<Stance>(wizard) = {};
    match.physics().set_state(wizard.index, std::as_const(world).get<Motion>(wizard));
}

RangeMatch make_range(const RangeData& data, const input::DeviceSpec& device, DummyKind kind,
                      std::uint64_t seed, std::vector<input::DeviceSpec> more,
                      std::vector<input::ProfileData> profile) {
    MatchSetup setup{.seed = seed, .devices = {device, dummy_device()}};
    for (auto& other : more) setup.devices.push_back(std::move(other));
    (void)use_profile(*data.match, std::move(profile), setup);  // after an error the setup is unchanged
    auto match = std::make_unique<Simulation>(data.match, std::move(setup));
    Dummy dummy(*match, dummys, kind, data.dummy, seed);
    return {std::move(match), std::move(dummy)};
}

void RangeMatch::tick(const input::DeviceSample& sample) {
    input::InputFrame frame;
    frame.devices[practising] = sample;
    frame.devices[dummys] = dummy.sample(*match);
    match->tick(frame);
}

void RangeMatch::adopt(const RangeData& data) {
    match = match->continued_with(data.match);
    dummy.adopt(*match, data.dummy);
}

Expected<void> RangeMatch::use_gestures(std::vector<input::ProfileData> profile) {
    auto setup = match->setup();
    if (auto used = use_profile(match->data(), std::move(profile), setup); !used) return used;
    const auto rules = dummy.rules();
    match = match->continued_with(match->shared_data(), std::move(setup));
    dummy.adopt(*match, rules);
    return {};
}

void RangeScorer::reset(const Simulation& match) { before_ = sum_of(match); }

RangeScore RangeScorer::score(const Simulation& match) {
    auto score = sum_of(match);
    score.shots -= before_.shots;
    score.hits -= before_.hits;
    score.kills -= before_.kills;
    score.damage -= before_.damage;
    const auto now = match.match().played;
    if (score.shots == 0) began_ = now;
    score.minutes = seconds(now - began_) / 60;
    return score;
}

std::string words_of(const RangeScore& score) {
    const auto share = score.shots > 0 ? text(" (", 100 * score.hits / score.shots, " %)") : std::string();
    return text(score.hits, " of ", score.shots, " hit", share, ", ", std::llround(score.damage), " HP, ",
                score.kills, score.kills == 1 ? " kill, " : " kills, ",
                std::llround(score.damage_per_minute()), " HP a minute");
}

}  // namespace thaum::game::inline range
