// A spell that exists only in this folder (mend.cpp, mend.toml, w.toml) must work like those of the game: a
// stroke or a combination of keys casts it, bots draw it, the screen shows its name, and it has sound and
// touch.
#include <gtest/gtest.h>

#include <cmath>

#include "game/bots/duel.h"
#include "game/components/casting.h"
#include "game/match/record.h"
#include "tests/fifth_spell/assets.h"
#include "unit/overlay_items.h"

namespace thaum::game::test {
namespace {

namespace hand = input::hand;
using input::Button;
using Data = std::shared_ptr<const MatchData>;

const std::filesystem::path& assets() {
    static const FifthSpellAssets folder;
    return folder.path();
}

Data data_of(std::vector<std::string> overrides = {}) {
    return std::make_shared<const MatchData>(
        load_match_data(assets(), {.overrides = std::move(overrides)}).value());
}

std::uint32_t number_of_mend() {
    for (std::uint32_t i = 0; i < spell_kinds().size(); ++i)
        if (spell_kinds()[i].name == "mend") return i;
    return 1000;
}

/// A match in which player 1 has lost health. The test's inputs in `frame` move that player.
struct Patient {
    Simulation match{data_of(), {1, {{.player = 0, .kind = input::DeviceKind::script, .name = "one"}}}};
    input::InputFrame frame;

    Patient() { match.context_to_change().world.get<Health>(wizard()).points = 50; }
    ecs::Entity wizard() const { return wizard_of(match.world(), 0); }
    double health() const { return match.world().get<Health>(wizard()).points; }
    double focus() const { return match.world().get<Focus>(wizard()).points; }
    input::DeviceSample& sample() { return frame.devices[0]; }
    void run(Tick length) {
        for (Tick t = 0; t < length; ++t) match.tick(frame);
    }
    std::uint32_t casts() const {
        std::uint32_t count = 0;
        std::uint64_t from = 0;
        match.events().each_new(from, [&](const Event& e) {
            count += e.kind == EventKind::cast && e.detail == number_of_mend() ? 1U : 0U;
        });
        return count;
    }
    /// Draws the gesture of the spell with the mouse.
    void draw() {
        const auto& gestures = *match.data().gestures;
        const auto& stroke = gestures.gestures()[*gestures.number("w")].strokes[0];
        sample().press(Button::trace);
        run(16);
        std::int32_t right = 0, up = 0;
        for (const auto& point : stroke) {
            const vec3 way = 1e4 * (point.at - stroke.front().at);
            const auto x = static_cast<std::int32_t>(std::lround(way.x)),
                       y = static_cast<std::int32_t>(std::lround(way.y));
            sample().counts[hand::look_right] = x - right;
            sample().counts[hand::look_up] = y - up;
            right = x, up = y;
            run(1);
            sample().counts[hand::look_right] = sample().counts[hand::look_up] = 0;
            run(7);
        }
        frame = {};
        run(16);
    }
};

TEST(FifthSpell, AStrokeCastsItAndItsOwnSystemRuns) {
    Patient patient;
    patient.draw();
    EXPECT_EQ(patient.casts(), 1U);
    EXPECT_NEAR(patient.focus(), 70, 1);
    patient.run(2500);
    EXPECT_NEAR(patient.health(), 70, 1e-6);
}

TEST(FifthSpell, AKeyChordCastsIt) {
    Patient patient;
    patient.sample().press(Button::trace);
    patient.run(16);
    patient.sample().wand = 5;
    patient.run(16);
    patient.frame = {};
    patient.run(2500);
    EXPECT_EQ(patient.casts(), 1U);
    EXPECT_NEAR(patient.health(), 70, 1e-6);
}

TEST(FifthSpell, ItRefusesByItself) {
    Patient patient;
    patient.match.context_to_change().world.get<Health>(patient.wizard()).points = 100;
    patient.draw();
    EXPECT_EQ(patient.casts(), 0U);
    EXPECT_NEAR(patient.focus(), 100, 0);
}

TEST(FifthSpell, BotsCastItByStrokes) {
    auto duel = make_bot_duel(assets(), data_of({"quick.kills=1000"}), {"level_3", "level_3"}, 2).value();
    std::uint64_t seen = 0;
    std::uint32_t casts = 0;
    for (int second = 0; second < 90 && casts == 0; ++second) {
        duel.run(1000);
        duel.match->events().each_new(seen, [&](const Event& e) {
            casts += e.kind == EventKind::cast && e.detail == number_of_mend() ? 1U : 0U;
        });
    }
    EXPECT_GT(casts, 0U);
}

TEST(FifthSpell, IsNamedInTheFeedAndHasASoundOfItsOwn) {
    Patient patient;
    patient.draw();
    auto picture = make_picture();
    take_picture(patient.match, picture);
    const auto overlay = hud_tests::overlay_of(picture, {.split = render::Split::side_by_side});
    EXPECT_TRUE(hud_tests::has_text(overlay, "Mend"));
    const auto& shown = patient.match.data().presentation->spells;
    ASSERT_EQ(shown.size(), spell_kinds().size());
    EXPECT_EQ(shown[number_of_mend()].sound, "boon");
    EXPECT_EQ(shown[number_of_mend()].tactile, "potion_ready");
}

}  // namespace
}  // namespace thaum::game::test
