// Data files that are added to the game's: a second wand and a second spell of a kind, a gesture and a
// potion. No source is needed for them, and a match recorded before them is replayed as it was played.
#include <gtest/gtest.h>

#include <algorithm>

#include "game/bots/duel.h"
#include "game/match/playback.h"
#include "game/match/record.h"
#include "seams/assets.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

using input::Button;

std::string words_of(const std::filesystem::path& file) { return read_text_file(file, 1U << 20U).value(); }

std::string replaced(std::string words, std::string_view from, std::string_view to) {
    const auto at = words.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return words.replace(at, from.size(), to);
}

/// The file of a wand of the kind "bolt" that shoots seldom and slowly, on key 6.
std::string arrow_toml() {
    auto words = replaced(words_of(assets() / "wands/bolt.toml"), "slot = 1", "slot = 6\nkind = \"bolt\"");
    words = replaced(words, "per_s = 8", "per_s = 0.2");
    words = replaced(words, "speed_m_s = 40", "speed_m_s = 20");
    const auto event = words.find("[event.bolt_hit]"), sound = words.find("[sound]");
    return words.erase(event, sound - event);
}

/// The file of a lift wand of the same kind as the game's, which holds things of 20 kg at most, on key 7.
std::string tongs_toml() {
    auto words = replaced(words_of(assets() / "wands/lift.toml"), "mass_max_kg = 120", "mass_max_kg = 20");
    const auto slot = words.find("slot = ");
    return words.replace(slot, words.find('\n', slot) - slot, "slot = 7\nkind = \"lift\"");
}

/// The file of a spell of the kind "shield" that absorbs little.
std::string veil_toml() {
    auto words =
        replaced(words_of(assets() / "spells/shield.toml"), "slot = 1", "slot = 5\nkind = \"shield\"");
    words = replaced(words, "gesture = \"circle\"", "gesture = \"w\"");
    words = replaced(words, "absorbs_hp = 30", "absorbs_hp = 7");
    return replaced(words, "shown = \"Shield\"", "shown = \"Veil\"");
}

/// The file of a potion with other ingredients than those of the game.
std::string zest_toml() {
    auto words = replaced(words_of(assets() / "potions/haste.toml"), "name = \"ember\"", "name = \"iron\"");
    return replaced(words, "name = \"salt\"", "name = \"down\"");
}

const std::filesystem::path& more_assets() {
    static const auto& folder = *[] {
        auto* made = new SeamAssets;
        made->add("wands", "arrow.toml", arrow_toml());
        if (!write_text_file(made->path() / "wands/tongs.toml", tongs_toml())) std::abort();
        made->add("spells", "veil.toml", veil_toml());
        made->add("gestures", "w.toml",
                  words_of(std::filesystem::path(THAUM_SOURCE_DIR) / "tests/fifth_spell/w.toml"));
        made->add("potions", "aaa_zest.toml", zest_toml());
        return made;
    }();
    return folder.path();
}

std::shared_ptr<const MatchData> more_data(std::vector<std::string> overrides = {}) {
    return std::make_shared<const MatchData>(
        load_match_data(more_assets(), {.overrides = std::move(overrides)}).value());
}

std::string fault_of(const std::string& folder, const std::string& file, const std::string& words) {
    SeamAssets changed;
    changed.add(folder, file, words);
    return message_of(load_match_data(changed.path(), {}));
}

TEST(AddedFiles, AreAllRead) {
    const auto data = more_data();
    ASSERT_EQ(data->wands.size(), 7U);
    EXPECT_EQ(data->wands[5].name, "arrow");
    EXPECT_EQ(data->wands[5].kind->name, "bolt");
    EXPECT_EQ(data->wands[6].name, "tongs");
    ASSERT_EQ(data->spells.size(), 5U);
    EXPECT_EQ(name_of_spell(data->spells, 4), "veil");
    EXPECT_EQ(data->recipes.front().name, "aaa_zest");
    EXPECT_TRUE(data->gestures->number("w"));
}

/// A match with two scripted players, of whom the first uses a wand or casts a spell.
struct Play {
    Simulation match;
    input::InputFrame frame{};

    explicit Play(std::vector<std::string> overrides = {})
        : match(more_data(std::move(overrides)), two_hands()) {}
    ecs::Entity wizard(std::uint32_t player) const { return wizard_of(match.world(), player); }
    double health(std::uint32_t player) const { return match.world().get<Health>(wizard(player)).points; }
    std::uint32_t missiles(std::string_view wand) const {
        std::uint32_t count = 0;
        wand_of(match.data(), wand).rules->show(match.world(), [&](const Missile&) { ++count; });
        return count;
    }
    void run(Tick length) {
        for (Tick t = 0; t < length; ++t) match.tick(frame);
    }
};

TEST(AddedFiles, MissilesOfTwoWandsOfAKindKeepTheirOwnNumbers) {
    Play play;
    const auto speed_of = [&](std::string_view wand) {
        double speed = 0;
        wand_of(play.match.data(), wand).rules->show(play.match.world(), [&](const Missile& missile) {
            speed = glm::length(missile.velocity);
        });
        return speed;
    };
    play.frame.devices[0].wand = 6;
    play.frame.devices[0].press(Button::fire);
    play.run(16);
    EXPECT_EQ(play.missiles("arrow"), 1U);
    EXPECT_EQ(play.missiles("bolt"), 0U);
    EXPECT_NEAR(speed_of("arrow"), 20, 1e-9);
    const auto place_of = [&] {
        vec3 place{};
        wand_of(play.match.data(), "arrow").rules->show(play.match.world(), [&](const Missile& missile) {
            place = missile.position;
        });
        return place;
    };
    const auto before = place_of();
    play.run(100);
    EXPECT_NEAR(glm::distance(place_of(), before), 2, 1e-9) << "it flies once a step, not once a wand";
    play.frame = {};
    play.frame.devices[0].wand = 1;
    play.run(16);
    play.frame.devices[0].press(Button::fire);
    play.run(16);
    EXPECT_EQ(play.missiles("arrow"), 1U);
    EXPECT_EQ(play.missiles("bolt"), 1U);
    EXPECT_NEAR(speed_of("bolt"), 40, 1e-9);
    const auto slot = wand_of(play.match.data(), "arrow").stats.slot;
    const auto& energy = play.match.world().get<WandBelt>(play.wizard(0)).energy;
    EXPECT_LT(energy[slot], wand_of(play.match.data(), "arrow").stats.energy_cap) << "its own energy";
}

TEST(AddedFiles, AWandHoldsOnlyWhatItTookItself) {
    Play play;
    auto& context = play.match.context_to_change();
    const auto& tongs = wand_of(play.match.data(), "tongs");
    const auto& lift = wand_of(play.match.data(), "lift");
    ecs::Entity light{}, heavy{};
    play.match.world().view<const Prop, const Body>().each(
        [&](ecs::Entity e, const Prop&, const Body& body) { (body.mass <= 20 ? light : heavy) = e; });
    ASSERT_TRUE(light && heavy);
    const auto wizard = play.wizard(0);
    const WandUse use{context, wizard, 1, tongs.stats};
    EXPECT_FALSE(tongs.rules->catch_thing(use, heavy)) << "too heavy for this wand";
    ASSERT_TRUE(tongs.rules->catch_thing(use, light));
    EXPECT_EQ(tongs.rules->held_thing(play.match.world(), wizard), light);
    EXPECT_FALSE(lift.rules->held_thing(play.match.world(), wizard));
    EXPECT_EQ(lift.rules->holding_force(play.match.world(), wizard, 9.81), 0);
    EXPECT_GT(tongs.rules->holding_force(play.match.world(), wizard, 9.81), 0);
}

TEST(AddedFiles, ASpellOfAKindHasItsOwnNumbersAndName) {
    Play play;
    play.frame.devices[0].press(Button::trace);
    play.run(16);
    play.frame.devices[0].wand = 5;
    play.run(16);
    EXPECT_EQ(play.match.world().get<Health>(play.wizard(0)).ward, 7);
    const auto cast = last_of(play.match, EventKind::cast);
    ASSERT_EQ(count_of(play.match, EventKind::cast), 1U);
    EXPECT_EQ(name_of_spell(play.match.data().spells, cast.detail), "veil");
}

TEST(AddedFiles, AMatchRecordedBeforeThemIsPlayedAsItWas) {
    const TemporaryFolder folder;
    const auto log = folder.path() / "before.thaumlog";
    auto duel = make_bot_duel(assets(), duel_data(), {"level_3", "level_3"}, 4).value();
    const auto header = log_header(duel.match->data(), duel.match->setup(), {"bot 3", "bot 3"});
    auto writer = input::LogWriter::create(log, header).value();
    for (Tick t = 0; t < ticks(12.0); ++t) tick_and_record(*duel.match, duel.next_frame(), &writer);
    ASSERT_TRUE(close_log(writer, *duel.match));

    auto playback = Playback::open(log, more_assets());
    ASSERT_TRUE(playback) << playback.error().message;
    EXPECT_EQ(playback->match().data().wands.size(), 5U);
    EXPECT_EQ(playback->match().data().recipes.size(), 5U);
    while (playback->step()) {}
    EXPECT_FALSE(playback->divergence());
    EXPECT_EQ(playback->match().state_hash(), duel.match->state_hash());
    EXPECT_EQ(log_header(playback->match().data(), playback->match().setup(), {"bot 3", "bot 3"}), header)
        << "recorded once more, it names the same files";
}

TEST(AddedFiles, AMatchWithThemNamesThemAndNeedsThem) {
    const auto header = log_header(*more_data(), two_hands(), {"one", "two"});
    for (const auto* name :
         {"wands/arrow.toml", "spells/veil.toml", "gestures/w.toml", "potions/aaa_zest.toml"})
        EXPECT_NE(std::ranges::find(header.files, name, &input::DataFile::name), header.files.end()) << name;
    EXPECT_TRUE(match_of_log(header, more_assets()));
    EXPECT_EQ(match_of_log(header, assets()).error().message,
              "data file wands/arrow.toml is not part of this version");
}

TEST(AddedFiles, MistakesAreToldAtTheirLine) {
    EXPECT_NE(fault_of("wands", "arrow.toml", replaced(arrow_toml(), "kind = \"bolt\"", "kind = \"bold\""))
                  .find("arrow.toml:4: 'kind' is 'bold', which is no kind of wand; did you mean 'bolt'?"),
              std::string::npos);
    EXPECT_NE(fault_of("wands", "arrow.toml", replaced(arrow_toml(), "kind = \"bolt\"", ""))
                  .find("'kind' is 'arrow'"),
              std::string::npos);
    EXPECT_NE(
        fault_of("wands", "arrow.toml", replaced(arrow_toml(), "slot = 6", "slot = 3")).find("'slot' is 3"),
        std::string::npos);
    EXPECT_NE(fault_of("wands", "arrow.toml", text(arrow_toml(), "\n[event.bolt_hit]\nmark = \"hit\"\n"))
                  .find("'event': the file with the name of the wand's kind"),
              std::string::npos);
    EXPECT_NE(fault_of("spells", "veil.toml", replaced(veil_toml(), "kind = \"shield\"", "kind = \"swing\""))
                  .find("'swing', which is no kind of spell"),
              std::string::npos);
    EXPECT_NE(fault_of("wands", "lob.toml", replaced(arrow_toml(), "slot = 6", "slot = 3"))
                  .find("'kind' is 'bolt', but the file has the name of another kind"),
              std::string::npos);
    EXPECT_NE(fault_of("wands", "Arrow.toml", arrow_toml()).find("the name of a data file"),
              std::string::npos);
}

}  // namespace
}  // namespace thaum::game::test
