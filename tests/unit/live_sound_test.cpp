// Tests of the sound of a live session with a fake device: menus, matches, messages, and a device that is
// unplugged.
#include "game/live/sound.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <set>

#include "audio/synth.h"
#include "core/clock.h"
#include "core/file.h"
#include "game/live/body.h"
#include "unit/game_duel.h"

namespace thaum::game::live_tests {
namespace {

/// Number and energy of the blocks that a device has played; used by both threads.
struct Heard {
    std::mutex mutex;
    double energy{};
    std::size_t blocks{};
    bool there = true;  ///< true: the device can be opened and stays connected
};

/// A fake sound device that accepts one block at each call.
class HeardDevice final : public audio::SoundDevice {
public:
    explicit HeardDevice(std::shared_ptr<Heard> heard) : heard_(std::move(heard)) {}
    Expected<void> open() override {
        const std::lock_guard lock(heard_->mutex);
        return heard_->there ? Expected<void>() : fail("pulled out");
    }
    std::size_t wanted() override { return 1; }
    void write(std::span<const float> block) override {
        const std::lock_guard lock(heard_->mutex);
        ++heard_->blocks;
        for (const float sample : block) heard_->energy += static_cast<double>(sample * sample);
    }
    bool is_connected() override {
        const std::lock_guard lock(heard_->mutex);
        return heard_->there;
    }
    void close() override {}

private:
    std::shared_ptr<Heard> heard_;
};

struct SoundOfSession {
    SoundOfSession() {
        auto bank = audio::load_sounds(game::test::assets() / "sounds").value();
        auto mixer = audio::Mixer::create(bank, {}).value();
        sound = std::make_unique<LiveSound>(std::move(bank), std::move(mixer),
                                            std::make_unique<HeardDevice>(heard));
    }

    /// Waits until the device has played this many more blocks, and returns their energy.
    double play(std::size_t blocks) {
        const auto [first, before] = now();
        for (;;) {
            const auto [count, energy] = now();
            if (count >= first + blocks) return energy - before;
            sleep_until_ns(monotonic_ns() + 1'000'000);
        }
    }
    std::pair<std::size_t, double> now() {
        const std::lock_guard lock(heard->mutex);
        return {heard->blocks, heard->energy};
    }

    std::shared_ptr<Heard> heard = std::make_shared<Heard>();
    std::unique_ptr<LiveSound> sound;
};

TEST(LiveSoundTest, AMenuIsHeardAndSilenceIsSilent) {
    SoundOfSession session;
    EXPECT_EQ(session.play(5), 0);
    session.sound->play(MenuSound::choose);
    EXPECT_GT(session.play(20), 0.1);
    session.play(60);
    EXPECT_EQ(session.play(5), 0);
}

TEST(LiveSoundTest, AFaderAtZeroIsSilent) {
    SoundOfSession session;
    Settings settings;
    settings.sound_interface = 0;
    session.sound->apply(settings);
    session.play(5);
    session.sound->play(MenuSound::choose);
    EXPECT_LT(session.play(30), 1e-9);
}

TEST(LiveSoundTest, AMatchIsHeardAndReadAndEndsWithIt) {
    SoundOfSession session;
    session.sound->apply(Settings{});
    auto duel = game::test::make_duel(1);
    auto picture = game::make_picture();
    {
        MatchSound match(session.sound.get());
        match.listen(true, true);
        for (Tick t = 0; t < ticks(4); ++t) {
            duel.run(1);
            match.follow(*duel.match);
            if (t % 8 == 0 && t > ticks(3)) session.play(1);
        }
        EXPECT_GT(session.play(10), 0.001);
        match.show(picture);
    }
    EXPECT_GT(picture.wizards[0].senses.heard_lines + picture.wizards[1].senses.heard_lines, 0U);
    session.play(60);
    EXPECT_LT(session.play(5), 1e-9) << "lasting sounds end with the match";
}

TEST(LiveSoundTest, AFaultyRecipeIsToldInOneLineAndSilencesItsOwnSoundOnly) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    fs::copy(game::test::assets() / "sounds", folder.path() / "sounds", fs::copy_options::recursive);
    ASSERT_TRUE(write_text_file(folder.path() / "sounds" / "bolt_shot.toml", "version = 1\nlevel = 7\n"));
    testing::internal::CaptureStderr();
    const auto sound = LiveSound::start(folder.path(), Settings{});
    ASSERT_NE(sound, nullptr);
    const auto data = game::test::duel_data();
    const auto sounds = game::match_sounds(sound->bank(), *data->presentation);
    const auto said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(said.find("the sound 'bolt_shot' is silent: "), 0U) << said;
    EXPECT_NE(said.find("sounds/bolt_shot.toml:"), std::string::npos) << said;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_EQ(sounds.missing.size(), 0U) << "it is told once";
    EXPECT_FALSE(sound->bank().find("bolt_shot"));
    EXPECT_TRUE(sound->bank().find("blast_shot"));
}

TEST(LiveSoundTest, WithoutSoundsTheHandAndTheBodyAreStillTold) {
    auto duel = game::test::make_duel(3);
    const auto body = std::optional(LiveBody::load(game::test::assets()).value());
    LiveTactile motors;
    MatchSound sound(nullptr);
    MatchBody felt(body, motors, nullptr);
    std::set<std::string> told;
    for (Tick t = 0; t < ticks(20); ++t) {
        duel.run(1);
        sound.follow(*duel.match);
        felt.follow(*duel.match, sound);
        for (std::uint32_t p = 0; p < game::players; ++p)
            for (const auto& line : sound.words(p).lines()) told.insert(game::words_of(line));
    }
    EXPECT_EQ(told.count("wand kicks"), 1U);
    EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const auto& line) {
        return line.find("bolt strikes from ") == 0;
    })) << "with its side";
}

TEST(LiveSoundTest, WithoutSoundOrReadersNothingIsMade) {
    SoundOfSession session;
    {
        const std::lock_guard lock(session.heard->mutex);
        session.heard->there = false;
    }
    while (session.sound->is_wanted()) sleep_until_ns(monotonic_ns() + 1'000'000);
    MatchSound match(session.sound.get());
    auto duel = game::test::make_duel(1);
    for (Tick t = 0; t < ticks(3); ++t) {
        duel.run(1);
        match.follow(*duel.match);
    }
    auto picture = game::make_picture();
    match.show(picture);
    EXPECT_EQ(picture.wizards[0].senses.heard_lines, 0U);
    session.sound->apply(Settings{});
    EXPECT_TRUE(session.sound->is_wanted()) << "the sounds are told in words";
}

}  // namespace
}  // namespace thaum::game::live_tests
