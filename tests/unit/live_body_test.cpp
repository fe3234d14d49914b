// Tests of what players of a session feel on the body during a match: the body figure (a drawing of the body)
// on the screen, a jacket, and sounds on the jacket, each only while it is switched on.
#include "game/live/body.h"

#include <gtest/gtest.h>

#include <thread>

#include "audio/synth.h"
#include "core/file.h"
#include "game/live/body_trial.h"
#include "unit/felt_output_rig.h"
#include "unit/game_duel.h"

namespace thaum::game {
namespace {

/// A session of two bots without loudspeakers, in which player 1 has a fake jacket.
struct FeltDuel {
    FeltDuel() {
        auto bank = audio::load_sounds(game::test::assets() / "sounds");
        auto mixer = audio::Mixer::create(bank.value(), {});
        sound = std::make_unique<LiveSound>(std::move(*bank), std::move(mixer.value()),
                                            std::make_unique<NoDevice>(), game::test::assets());
        body = LiveBody::load(game::test::assets()).value();
        settings.players[0].jacket = "osc:vest:1";
        felt->wants_every = true;
    }
    void apply(std::string_view layout = "x40") {
        sound->apply(settings);
        tactile.apply(settings);
        while (tactile.jacket_layout(0) != layout) std::this_thread::yield();
    }
    /// Plays a match for some seconds. Returns the picture at its end.
    game::Picture play(double seconds) {
        auto duel = game::test::make_duel(1);
        MatchSound words(nullptr);
        MatchBody match(body, tactile, sound.get());
        const auto given = [&] { return tactile.jacket_report(0).frames_sent; };
        const auto before = given();
        for (Tick t = 0; t < ticks(seconds); ++t) {
            duel.run(1);
            match.follow(*duel.match, words);
            // Waits for the output's thread, because its queue holds only 32 frames.
            const auto wanted = before + t / tactile::frame_ticks;
            while (t % 128 == 0 && given() + 8 < wanted) std::this_thread::yield();
        }
        while (given() < before + ticks(seconds) / tactile::frame_ticks) std::this_thread::yield();
        auto picture = game::make_picture();
        match.show(picture);
        state = duel.match->state_hash();
        return picture;
    }
    std::size_t frames() {
        return felt->with([&] { return felt->frames.size(); });
    }

    class NoDevice final : public audio::SoundDevice {
    public:
        Expected<void> open() override { return fail("there is none"); }
        std::size_t wanted() override { return 0; }
        void write(std::span<const float>) override {}
        bool is_connected() override { return false; }
        void close() override {}
    };

    std::shared_ptr<input::rig::Felt> felt = std::make_shared<input::rig::Felt>();
    std::unique_ptr<LiveSound> sound;
    std::optional<LiveBody> body;
    Settings settings;
    LiveTactile tactile{[](const input::PadState&) { return nullptr; },
                        [this](const Jacket& jacket, std::uint32_t) -> std::unique_ptr<input::TactileOutput> {
                            if (!jacket) return nullptr;
                            return std::make_unique<input::rig::FakeOutput>(felt);
                        }};
    std::uint64_t state = 0;
};

TEST(LiveBodyThreads, SoundsReachAJacketWithoutLoudspeakersAndChangeNothing) {
    FeltDuel duel;
    duel.apply();
    duel.play(3);
    const auto plain = duel.frames();
    const auto plain_state = duel.state;
    EXPECT_EQ(duel.sound->felt_courses(), nullptr) << "nobody wants them";
    duel.settings.players[0].jacket_sound = 1;
    duel.settings.players[0].jacket_sound_of = game::FeltGroups::both;
    duel.apply();
    ASSERT_NE(duel.sound->felt_courses(), nullptr);
    duel.play(3);
    EXPECT_GT(duel.frames() - plain, plain + 150) << "the score is felt";
    EXPECT_EQ(duel.state, plain_state);
}

TEST(LiveBodyThreads, ThePlayerWhoDoesNotWantSoundsFeelsNone) {
    FeltDuel duel;
    duel.settings.players[1].jacket_sound = 1;  // no effect: player 2 has no jacket
    duel.apply();
    duel.play(2);
    const auto frames = duel.frames();
    duel.settings.players[1].jacket_sound = 0;
    duel.apply();
    duel.play(2);
    EXPECT_EQ(duel.frames(), 2 * frames);
}

TEST(LiveBodyThreads, AnOwnLayoutTakesThePlaceOfTheUsualOne) {
    FeltDuel duel;
    const auto jacket = parse_jacket(duel.settings.players[0].jacket).value();
    auto layout = load_own_layout("sleeves", jacket, game::test::assets()).value();
    const auto motors = layout.actuators.size();
    duel.tactile.use_own_layout(0, motors);
    duel.body->own[0] = std::move(layout);
    duel.apply("own");
    duel.play(20);
    ASSERT_GT(duel.frames(), 0U);
    float most = 0;
    duel.felt->with([&] {
        for (const auto& frame : duel.felt->frames) {
            EXPECT_EQ(frame.count, motors);
            for (const auto amplitude : frame.amplitude) most = std::max(most, amplitude);
        }
        return 0;
    });
    EXPECT_GT(most, 0) << "the duel is felt";
    // The fake now takes only the newest frame, like a real jacket.
    duel.felt->with([&] { return duel.felt->wants_every = false; });
    BodyTrial trial(*duel.body, duel.tactile);
    const auto before = duel.frames();
    ASSERT_TRUE(trial.start(0, tactile::Purpose::blast, {}, 0));
    duel.felt->wait([&] { return duel.felt->frames.size() > before; });
    EXPECT_EQ(duel.felt->with([&] { return duel.felt->frames.back().count; }), motors);
}

TEST(LiveBodyThreads, TheFigureIsMadeForThePlayersWhoSeeIt) {
    FeltDuel duel;
    duel.settings.players[1].figure = false;
    duel.apply();
    bool seen = false;
    for (const double seconds : {10.0, 20.0}) {
        const auto picture = duel.play(seconds);
        seen = seen || picture.wizards[0].senses.since_felt_s < 100;
        EXPECT_EQ(picture.wizards[1].senses.since_felt_s, 1e6);
    }
    EXPECT_TRUE(seen);
}

/// A fault in a file has no effect on what other files describe. A faulty layout of a jacket is replaced by
/// one without actuators, which stays silent.
TEST(LiveBody, AFaultyFileCostsItselfAlone) {
    const TemporaryFolder folder;
    std::filesystem::copy(game::test::assets() / "tactile", folder.path() / "tactile",
                          std::filesystem::copy_options::recursive);
    ASSERT_TRUE(write_text_file(folder.path() / "tactile/layouts/x40.toml", "version = 1\n"));
    ASSERT_TRUE(write_text_file(folder.path() / "tactile/effects/stir.toml", "version = 1\npurpos = 3\n"));
    const auto body = LiveBody::load(folder.path()).value();
    EXPECT_FALSE(body.faults.empty());
    EXPECT_FALSE(body.effects.find("stir"));
    EXPECT_TRUE(body.effects.find("bolt_hit"));
    EXPECT_FALSE(body.figure.actuators.empty());
    const auto* jacket = body.jacket_of(0, "x40");
    ASSERT_NE(jacket, nullptr);
    EXPECT_TRUE(jacket->actuators.empty());
    tactile::TactileMixer mixer(*jacket, body.effects);
    for (std::uint32_t effect = 0; effect < body.effects.effects.size(); ++effect) {
        mixer.start(effect, tactile::Where::from({0, 0, 1}, 1.2), 1, 0);
        for (Tick now = 0; now < 80; now += tactile::frame_ticks) {
            const auto frame = mixer.mix(now);
            EXPECT_EQ(frame.count, 0U);
            EXPECT_TRUE(frame.is_silent());
        }
        mixer.stop();
    }
}

}  // namespace
}  // namespace thaum::game
