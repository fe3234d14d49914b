// Tests of sounds that are felt on a jacket: which row of a jacket's cells a tone drives and how its level
// changes; distance, walls and groups; silence.
#include "game/senses/tactile/felt_sound.h"

#include <cmath>

#include "audio/mixer.h"
#include "audio/synth.h"
#include "core/file.h"
#include "core/hash.h"
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/tactile_scene.h"
#include "unit/audio_recipes.h"
#include "unit/game_duel.h"
#include "unit/message_of.h"

namespace thaum::game::test {
namespace {

using audio::SoundGroup;
using audio::Voice;

FeltBands shipped_bands() { return load_felt_bands(assets() / "tactile/sound.toml").value(); }

/// A bank of tones: loops of 40, 141 and 500 Hz as music, then one of 40 Hz as an effect. The index is the
/// number of the sound.
audio::SoundBank tones() {
    audio::SoundBank bank;
    for (const auto& [hz, group] :
         {std::pair(40, "music"), {140, "music"}, {500, "music"}, {40, "effects"}}) {
        const auto toml = text("version = 1\ndescription = \"a tone\"\ngroup = \"", group,
                               "\"\nloops = true\nseconds = 2\nlevel = 0.5\nnear_m = 2\nreach_m = 20\n"
                               "[[parts]]\nkind = \"tone\"\nhz = ",
                               hz, "\n");
        const auto recipe = audio::read_recipe(toml, text("tone_", hz, group)).value();
        bank.sounds.push_back(audio::make_sound(recipe));
    }
    return bank;
}
enum Tone : std::uint32_t { low, middle, high, low_effect };

const FeltCourses& courses() {
    static const auto all = felt_courses(tones(), shipped_bands());
    return all;
}

audio::AudioFrame frame_with(std::initializer_list<Voice> lasting) {
    audio::AudioFrame frame;
    frame.listener_count = 2;
    frame.listeners[1].position = {10, 0, 0};
    for (const auto& voice : lasting) frame.lasts.add(voice);
    return frame;
}

TEST(FeltSound, AToneIsStrongInItsBandAlone) {
    for (const std::uint32_t tone : {low, middle, high}) {
        FeltSound felt(courses());
        const auto frame = frame_with({{.sound = tone, .key = 1, .at_ear = true, .gain = 0.1}});
        for (int i = 0; i < 50; ++i) {
            felt.follow(frame);
            const auto strengths = felt.strengths(0, {1, FeltGroups::music});
            for (std::size_t band = 0; band < felt_bands; ++band) {
                const double whole = 0.1 * 0.5 / courses().bands.full.at(band);
                if (band == tone)
                    EXPECT_NEAR(strengths.at(band), whole, 0.1 * whole) << i;
                else
                    EXPECT_LT(strengths.at(band), 0.15 * whole) << i;
            }
        }
    }
}

TEST(FeltSound, TheWishScalesAndChoosesGroups) {
    FeltSound felt(courses());
    felt.follow(frame_with({{.sound = low, .key = 1, .at_ear = true, .gain = 0.1},
                            {.sound = low_effect, .key = 2, .at_ear = true, .gain = 0.1}}));
    const double music = felt.strengths(0, {1, FeltGroups::music})[0];
    const double effects = felt.strengths(0, {1, FeltGroups::effects})[0];
    EXPECT_NEAR(music, effects, 1e-9);
    EXPECT_NEAR(felt.strengths(0, {1, FeltGroups::both})[0], std::sqrt(2) * music, 1e-9);
    EXPECT_NEAR(felt.strengths(0, {0.25, FeltGroups::music})[0], music / 4, 1e-12);
    EXPECT_EQ(felt.strengths(0, {0, FeltGroups::both}), BandStrengths{});
}

TEST(FeltSound, DistanceWallsAndEarsAreThoseOfTheListener) {
    const auto strength = [](const Voice& voice, std::uint32_t listener) {
        FeltSound felt(courses());
        felt.follow(frame_with({voice}));
        return felt.strengths(listener, {1, FeltGroups::both})[0];
    };
    const double near = strength({.sound = low, .key = 1, .position = {1, 0, 0}, .gain = 0.1}, 0);
    EXPECT_GT(near, 0);
    EXPECT_NEAR(strength({.sound = low, .key = 1, .position = {4, 0, 0}, .gain = 0.1}, 0),
                near * audio::distance_gain(4, 2, 20), 1e-9);
    EXPECT_EQ(strength({.sound = low, .key = 1, .position = {-11, 0, 0}}, 1), 0) << "out of its reach";
    EXPECT_EQ(strength({.sound = low, .key = 1, .heard_by = 2, .at_ear = true}, 0), 0) << "the other's ears";
    EXPECT_GT(strength({.sound = low, .key = 1, .heard_by = 2, .at_ear = true}, 1), 0);
    EXPECT_NEAR(strength({.sound = low, .key = 1, .position = {1, 0, 0}, .gain = 0.1, .muffled = {1, 0}}, 0),
                near / 2, 1e-9);
    EXPECT_EQ(strength({.sound = 1000, .key = 1, .at_ear = true}, 0), 0) << "no sound of the bank";
}

TEST(FeltSound, ALastingVoiceEndsWithTheFramesAndStopForgetsAll) {
    FeltSound felt(courses());
    const auto frame = frame_with({{.sound = low, .key = 1, .at_ear = true}});
    felt.follow(frame);
    EXPECT_GT(felt.strengths(0, {1, FeltGroups::both})[0], 0);
    felt.follow(frame_with({}));
    EXPECT_EQ(felt.strengths(0, {1, FeltGroups::both}), BandStrengths{});
    audio::AudioFrame begins = frame_with({});
    for (int i = 0; i < 200; ++i) begins.begins.add({.sound = low_effect, .at_ear = true});
    felt.follow(begins);  // more sounds than there is room for; they loop, so they do not end by themselves
    felt.follow(begins);
    felt.follow(begins);
    EXPECT_EQ(felt.strengths(0, {1, FeltGroups::both})[0], 1);
    felt.stop();
    EXPECT_EQ(felt.strengths(0, {1, FeltGroups::both}), BandStrengths{});
}

TEST(FeltSound, FaultsInTheBandsAreToldInOneLine) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "sound.toml";
    const std::string remaining =
        "[middle]\nlow_hz = 80\nhigh_hz = 250\nfull = 1\n[high]\nlow_hz = 250\nhigh_hz = "
        "1000\nfull = 1\n";
    for (const auto& [low_band, words] :
         {std::pair("low_hz = 80\nhigh_hz = 20\nfull = 1\n", "'low_hz' must be below 'high_hz'"),
          {"low_hz = 1\nhigh_hz = 80\nfull = 1\n", "'low_hz' is 1"},
          {"low_hz = 20\nhigh_hz = 80\nfull = 0\n", "'full' is 0"},
          {"low_hz = 20\nhigh_hz = 80\n", "'full' is missing"}}) {
        ASSERT_TRUE(write_text_file(file, text("version = 1\n[low]\n", low_band, remaining)));
        const auto message = message_of(load_felt_bands(file));
        EXPECT_EQ(message.find(file.string()), 0U) << message;
        EXPECT_NE(message.find(words), std::string::npos) << message;
    }
    EXPECT_FALSE(load_felt_bands(folder.path() / "none.toml"));
}

/// A match in which player 1 has a jacket and hears sounds that the test chooses.
struct JacketRig {
    JacketRig() : match(duel_data(), two_hands()) {
        auto bank = tactile::load_effects(assets() / "tactile/effects");
        auto x40 = tactile::load_layout(assets() / "tactile/layouts/x40.toml");
        EXPECT_TRUE(bank && x40);
        effects = std::move(*bank);
        jacket = std::move(*x40);
        numbers = match_effects(effects, *match.data().presentation);
        scene.emplace(numbers, effects, 0);
        scene->set_hears(scene->add(jacket), true);
        scene->add(jacket);  // player 2, who hears nothing
        scene->take(match);
    }
    void play(const BandStrengths& strengths) {
        for (Tick t = 0; t < tactile::frame_ticks; ++t) match.tick({});
        scene->set_sound(strengths);
        scene->take(match);
    }
    /// Energy of each of the five rows of a jacket's cells (actuators), front and back together, from the
    /// top.
    std::array<double, 5> rows() const {
        std::array<double, 5> sums{};
        for (std::size_t i = 0; i < 40; ++i) {
            const double a = scene->frame(0).amplitude.at(i);
            sums.at(i % 20 / 4) += a * a;
        }
        return sums;
    }

    Simulation match;
    tactile::EffectBank effects;
    tactile::Layout jacket;
    MatchEffects numbers;
    std::optional<TactileScene> scene;
};

TEST(FeltSoundOnAJacket, EachToneLightsItsRowInFrontAndAtTheBack) {
    constexpr std::array<std::size_t, felt_bands> row_of{4, 2, 0};  // rows of cells: belly, waist, shoulders
    for (const std::uint32_t tone : {low, middle, high}) {
        JacketRig rig;
        FeltSound felt(courses());
        for (int i = 0; i < 20; ++i) {
            felt.follow(frame_with({{.sound = tone, .key = 1, .at_ear = true, .gain = 0.2}}));
            rig.play(felt.strengths(0, {1, FeltGroups::music}));
        }
        const auto rows = rig.rows();
        double all = 0, front = 0;
        for (const double row : rows) all += row;
        for (std::size_t i = 0; i < 20; ++i) front += std::pow(rig.scene->frame(0).amplitude.at(i), 2);
        EXPECT_GT(rows.at(row_of.at(tone)), 0.8 * all) << tone;
        EXPECT_NEAR(front, all / 2, 0.1 * all) << tone;
        EXPECT_TRUE(rig.scene->frame(1).is_silent()) << "a layout that does not hear";
        EXPECT_LE(all, tactile::MixerSettings{}.sum_limit);
    }
}

TEST(FeltSoundOnAJacket, TheRowFollowsTheStrengthAndIsSilentSoonAfterTheSound) {
    JacketRig rig;
    const auto& effect = rig.effects.effects[rig.numbers.sounds[0].value()];
    for (int i = 0; i < 100; ++i) {
        const double wanted = 0.5 - 0.45 * std::cos(2 * pi * i / 50);
        rig.play({wanted, 0, 0});
        double sum = 0;
        for (const double row : rig.rows()) sum += row;
        // The outermost cells (actuators) of the row would get too little for a motor and stay off, hence the
        // tolerance.
        EXPECT_NEAR(std::sqrt(sum), effect.level(wanted), 0.05 * effect.level(1)) << i;
    }
    for (int i = 0; i < 8; ++i) rig.play({});
    EXPECT_TRUE(rig.scene->frame(0).is_silent());
}

TEST(FeltSoundOnAJacket, ASilentMatchAndAnOffSettingDriveNothing) {
    JacketRig rig;
    FeltSound felt(courses());
    for (int i = 0; i < 50; ++i) {
        felt.follow(i < 25 ? frame_with({}) : frame_with({{.sound = low, .key = 1, .at_ear = true}}));
        rig.play(felt.strengths(0, i < 25 ? FeltSoundWish{1, FeltGroups::both} : FeltSoundWish{}));
        EXPECT_TRUE(rig.scene->frame(0).is_silent());
    }
    EXPECT_EQ(rig.scene->counts(0).replaced + rig.scene->counts(0).not_driven, 0U);
}

/// Frames of the jacket after a blow from the front, with the loudest sounds or without sounds.
std::vector<tactile::TactileFrame> blow(double loudness) {
    JacketRig rig;
    for (int i = 0; i < 10; ++i) rig.play({loudness, loudness, loudness});
    const auto middle = rig.match.world().get<Motion>(wizard_of(rig.match.world(), 0)).position;
    record(rig.match.context_to_change(), {.tick = rig.match.match().played,
                                           .kind = *event_kind("bolt_hit"),
                                           .subject = 0,
                                           .amount = 60,
                                           .place = middle + vec3(0, 0, -5)});
    std::vector<tactile::TactileFrame> frames;
    for (int i = 0; i < 60; ++i) {
        rig.play({loudness, loudness, loudness});
        frames.push_back(rig.scene->frame(0));
    }
    return frames;
}

TEST(FeltSoundOnAJacket, ABlowIsFeltAsWithoutSounds) {
    const auto loud = blow(1), quiet = blow(0);
    float felt = 0;
    for (std::size_t i = 0; i < 30; ++i) {
        for (std::size_t k = 0; k < 40; ++k) {
            EXPECT_EQ(loud[i].amplitude.at(k), quiet[i].amplitude.at(k)) << "frame " << i << ", cell " << k;
            felt = std::max(felt, loud[i].amplitude.at(k));
        }
    }
    EXPECT_GT(felt, 0.15F);
    EXPECT_TRUE(quiet.back().is_silent());
    EXPECT_FALSE(loud.back().is_silent()) << "the sounds come back";
}

/// Hash of all tactile frames of a duel of bots in which both players feel sounds, and of the duel's state.
std::pair<std::uint64_t, std::uint64_t> duel_felt(bool with_sound, std::size_t* felt_frames) {
    static const auto bank = audio::load_sounds(assets() / "sounds");
    EXPECT_TRUE(bank);
    static const auto all = felt_courses(*bank, shipped_bands());
    auto duel = make_bot_duel(assets(), duel_data(), {"level_3", "level_3"}, 5).value();
    const JacketRig data;
    TactileScene scene(data.numbers, data.effects, 0);
    scene.set_hears(scene.add(data.jacket), true);
    auto sounds = match_sounds(*bank, *duel.match->data().presentation);
    SoundScene heard(std::move(sounds));
    FeltSound felt(all);
    audio::AudioFrame frame;
    std::uint64_t hash = 0;
    constexpr std::array<std::uint32_t, players> both{0, 1};
    for (int i = 0; i < 20 * 125; ++i) {
        duel.run(tactile::frame_ticks);
        if (with_sound) {
            heard.take(*duel.match, both, frame);
            felt.follow(frame);
            scene.set_sound(felt.strengths(0, {1, FeltGroups::both}));
        }
        scene.take(*duel.match);
        *felt_frames += scene.frame(0).is_silent() ? 0 : 1;
        hash = hash_bytes(std::as_bytes(std::span(&scene.frame(0), 1)), hash);
    }
    return {hash, duel.match->state_hash()};
}

TEST(FeltSoundOnAJacket, EqualMatchesAreFeltEquallyAndFeelingChangesNothing) {
    std::size_t first_felt = 0, second_felt = 0, without = 0;
    const auto first = duel_felt(true, &first_felt), second = duel_felt(true, &second_felt);
    const auto plain = duel_felt(false, &without);
    EXPECT_EQ(first, second);
    EXPECT_EQ(first.second, plain.second) << "the state of the match";
    EXPECT_NE(first.first, plain.first);
    EXPECT_GT(first_felt, 2 * without) << "the score is felt all the time";
}

}  // namespace
}  // namespace thaum::game::test
