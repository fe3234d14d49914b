// Fuzzes the readers of data files and settings. Accepted data must make a match that runs.
#include <fstream>

#include "core/file.h"
#include "fuzz/fuzz.h"
#include "game/bots/duel.h"
#include "game/context/effects.h"
#include "game/range/apprentice.h"
#include "game/range/range.h"
#include "game/settings/settings.h"

namespace thaum::fuzz {
namespace {

constexpr Tick played = 40;
/// The shipped files. Those in the scratch folder (Places) change.
const std::filesystem::path shipped_assets = std::filesystem::path(THAUM_SOURCE_DIR) / "assets";

std::string must_read(const std::filesystem::path& file) {
    auto content = read_text_file(file, 1U << 20U);
    return content ? std::move(*content) : std::string();
}

/// Gives both wizards the effects of all potions.
void drink_all(game::Simulation& match) {
    auto& context = match.context_to_change();
    for (std::uint32_t player = 0; player < game::players; ++player)
        for (const auto& recipe : context.data.recipes)
            game::begin_effects(context, game::wizard_of(match.world(), player), recipe.effects, {});
}

/// Plays a match in which both players walk, jump and shoot, under all potions. A fault causes an assertion
/// or a crash.
void play(game::MatchData data) {
    game::Simulation match(std::make_shared<const game::MatchData>(std::move(data)),
                           {1, {game::bot_device(0, "level_1"), game::bot_device(1, "level_1")}});
    input::InputFrame frame;
    for (std::size_t d = 0; d < game::players; ++d) {
        frame.devices[d].counts[input::hand::forward] = 127;
        frame.devices[d].counts[input::hand::trigger] = 255;
        frame.devices[d].press(input::Button::fire);
        frame.devices[d].press(input::Button::jump);
    }
    drink_all(match);
    for (Tick t = 0; t < played; ++t) match.tick(frame);
}

/// Changes a file as a text editor does. The program's own writers would refuse, because the program has read
/// the file.
bool edit(const std::filesystem::path& file, std::string_view words) {
    std::ofstream out(file, std::ios::binary);
    out << words;
    return out.flush().good();
}

/// Replaces a data file by `input` while `use` runs.
template <class Use>
Outcome with_file(const std::filesystem::path& file, const std::string& input, Use use) {
    const auto original = must_read(file);
    if (!edit(file, input)) return {.fault = "the scratch folder cannot be written"};
    Outcome outcome = use();
    if (!edit(file, original)) return {.fault = "the scratch folder cannot be written"};
    return outcome;
}

Outcome read_match_file(const char* name, const std::string& input, const Places& places) {
    return with_file(places.assets / name, input, [&]() -> Outcome {
        auto data = game::load_match_data(places.assets, {});
        if (!data) return {.refusal = data.error().message};
        play(std::move(*data));
        return {.accepted = true};
    });
}

constexpr const char *arena = "arenas/boiling_court.toml", *rules = "rules/quick.toml",
                     *wizard = "wizards/wizard.toml", *wand = "wands/bolt.toml",
                     *potion = "potions/ironhide.toml", *blast = "wands/blast.toml", *lob = "wands/lob.toml",
                     *bot = "bots/level_1.toml", *range = "range.toml", *lessons = "apprentice.toml";

template <const char* const& name>
std::vector<std::string> shipped(const Places& places) {
    return {must_read(places.assets / name)};
}

template <const char* const& name>
Outcome read_as(const std::string& input, const Places& places) {
    return read_match_file(name, input, places);
}

/// The shipped data of a match, read once: reading it takes most of the time of a run.
const Expected<std::shared_ptr<const game::MatchData>>& shipped_match() {
    static const auto shipped = []() -> Expected<std::shared_ptr<const game::MatchData>> {
        auto data = game::load_match_data(shipped_assets, {});
        if (!data) return data.error();
        return std::make_shared<const game::MatchData>(std::move(*data));
    }();
    return shipped;
}

/// The shipped practice range, read once.
const auto& shipped_range() {
    static const auto shipped = game::load_range(shipped_assets, {});
    return shipped;
}

Outcome read_bot(const std::string& input, const Places& places) {
    const auto& data = shipped_match();
    if (!data) return {.fault = data.error().message};
    return with_file(places.assets / bot, input, [&]() -> Outcome {
        auto duel = game::make_bot_duel(places.assets, *data, {"level_1", "level_1"}, 1);
        if (!duel) return {.refusal = duel.error().message};
        duel->run(played);
        return {.accepted = true};
    });
}

/// Plays every kind of dummy on one practice range, then continues it with the shipped data.
Outcome read_range(const std::string& input, const Places& places) {
    const auto& sound = shipped_range();
    if (!sound) return {.fault = sound.error().message};
    return with_file(places.assets / range, input, [&]() -> Outcome {
        const auto data = game::load_range(places.assets, {});
        if (!data) return {.refusal = data.error().message};
        auto match =
            game::make_range(*data, game::bot_device(game::practising, "level_1"), game::DummyKind::still, 1);
        input::DeviceSample sample;
        sample.press(input::Button::fire);
        for (Tick t = 0; t < 3 * played; ++t) {
            match.dummy.become(static_cast<game::DummyKind>(t / played));
            match.tick(sample);
        }
        match.adopt(*sound);
        match.tick(sample);
        return {.accepted = true};
    });
}

/// Plays the lessons for a while, then skips through them.
Outcome read_lessons(const std::string& input, const Places&) {
    auto lessons = game::parse_lessons(input, "apprentice.toml");
    if (!lessons) return {.refusal = lessons.error().message};
    const auto& data = shipped_range();
    if (!data) return {.fault = data.error().message};
    auto range =
        game::make_range(*data, game::bot_device(game::practising, "level_1"), game::DummyKind::still, 1);
    game::Apprentice apprentice(std::move(*lessons));
    input::DeviceSample sample;
    sample.press(input::Button::fire);
    sample.counts[input::hand::forward] = 127;
    for (Tick t = 0; t < 3 * played; ++t) {
        range.tick(sample);
        apprentice.follow(*range.match);
        if (t % 16 == 0) apprentice.skip();
        if (apprentice.share() < 0 || apprentice.share() > 1) return {.fault = "a share outside 0 to 1"};
    }
    return {.accepted = true};
}

std::vector<std::string> shipped_settings(const Places& places) {
    return {must_read(places.assets / "settings.toml")};
}

Outcome read_settings(const std::string& input, const Places&) {
    const auto settings = game::read_settings(input, "settings.toml");
    if (!settings) return {.refusal = settings.error().message};
    if (settings->fault) return {.refusal = settings->fault->message};
    return {.accepted = true};
}

}  // namespace

const Reader arena_reader{"arena", shipped<arena>, mutate_text, read_as<arena>};
const Reader rules_reader{"rules", shipped<rules>, mutate_text, read_as<rules>};
const Reader wizard_reader{"wizard", shipped<wizard>, mutate_text, read_as<wizard>};
const Reader wand_reader{"wand", shipped<wand>, mutate_text, read_as<wand>};
const Reader blast_reader{"blast", shipped<blast>, mutate_text, read_as<blast>};
const Reader lob_reader{"lob", shipped<lob>, mutate_text, read_as<lob>};
const Reader potion_reader{"potion", shipped<potion>, mutate_text, read_as<potion>};
const Reader bot_reader{"bot", shipped<bot>, mutate_text, read_bot};
const Reader range_reader{"range", shipped<range>, mutate_text, read_range};
const Reader lessons_reader{"lessons", shipped<lessons>, mutate_text, read_lessons};
const Reader settings_reader{"settings", shipped_settings, mutate_text, read_settings};

}  // namespace thaum::fuzz
