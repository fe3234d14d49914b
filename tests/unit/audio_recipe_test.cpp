// Tests of sound recipes (texts from which sounds are computed): which are refused, and with which messages;
// equal recipes give equal samples.
#include <cmath>

#include "audio/analysis.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/one_line.h"
#include "unit/audio_recipes.h"
#include "unit/message_of.h"

namespace thaum::audio {
namespace {

const std::string good_tone = part("tone", "hz = 440\ndecay = 0.2");

TEST(AudioRecipe, RefusesFaultsInOneLine) {
    const std::vector<std::pair<std::string, std::string_view>> faults{
        {"version = 2\n", "test.toml:1: version 2 cannot be read"},
        {head(0) + good_tone, "test.toml:4: 'seconds' is 0"},
        {head(2) + good_tone, "'seconds' is 2, must be from 0.05 to 1.5"},
        {head(17, true) + good_tone, "'seconds' is 17, must be from 0.05 to 16"},
        {head(0.5), "a sound has 1 to 16 parts"},
        {head(0.5) + part("tone", "hz = nan"), "'hz' is nan"},
        {head(0.5) + part("tone", "hz = inf"), "'hz' is inf"},
        {head(0.5) + part("tone", "hz = 1e9"), "'hz' is 1e+09"},
        {head(0.5) + part("tone", "hz = 0"), "'hz' is 0"},
        {head(0.5) + part("tone", ""), "key 'hz' is missing"},
        {head(0.5) + part("tone", "hz = 5000\nratios = [1, 5]"), "a partial of 25000 Hz is above 20000 Hz"},
        {head(0.5) + part("tone", "hz = 500\nratios = [1, 2]\nlevels = [1]"),
         "must have equally many numbers"},
        {head(0.5) + part("tone", "hz = 500\nratios = []"), "must be a list of 1 to 16 numbers"},
        {head(0.5) + part("tone", "hz = 500\nratios = [nan]"), "'ratios' is nan"},
        {head(0.5) + part("tone", "hz = 500\nratios = 2"), "must be a list"},
        {head(0.5) + part("tone", "hz = 500\npitch = 2"), "unknown key 'parts.pitch'"},
        {head(0.5) + part("drum", "hz = 500"), "'kind' must be one of: tone, noise, grains, score"},
        {head(0.5) + part("noise", "hz = 500\nfilter = \"comb\""),
         "'filter' must be one of: low, band, high"},
        {head(0.5) + part("grains", "rate = 1e6\nlow_hz = 500\nring = 0.1"), "'rate' is 1e+06"},
        {head(10, true) + part("grains", "rate = 2000\nlow_hz = 500\nring = 0.001"), "more than 4000 grains"},
        {head(1.5, true) + part("grains", "rate = 2000\nlow_hz = 500\nring = 1"), "takes too long to make"},
        {head(0.5) + part("score", "beats_per_minute = 60\ndecay = 1"), "a score has 1 to 200 notes"},
        {head(0.5) + part("score", "beats_per_minute = 60\nnotes = [{ beat = 0, beats = 0.1, key = 60 }]"),
         "a score needs 'decay'"},
        {head(1, true) + part("tone", "hz = 440\nsweep_to = 600"), "cannot sweep"},
        {head(1, true) + part("tone", "hz = 440\nattack = 0.1"), "no 'start' or 'attack'"},
    };
    for (const auto& [toml, words] : faults) {
        const auto message = refusal(toml);
        EXPECT_NE(message.find(words), std::string::npos) << words << "\n  said: " << message;
        EXPECT_EQ(message, in_one_line(message));
        EXPECT_EQ(message.find("test.toml"), 0U) << message;
    }
}

TEST(AudioRecipe, LimitsTheWork) {
    std::string toml = head(16, true);
    const std::string notes = "{ beat = 0, beats = 16, key = 40 }, ";
    std::string all;
    for (int i = 0; i < 60; ++i) all += notes;
    toml +=
        part("score", text("beats_per_minute = 60\ndecay = 16\nratios = [1, 2, 3, 4]\nnotes = [", all, "]"));
    EXPECT_NE(refusal(toml).find("takes too long to make"), std::string::npos);
}

TEST(AudioRecipe, WorkIsAtLeastTheSamplesAdded) {
    const auto recipe = read_recipe(head(1) + part("tone", "hz = 440\nratios = [1, 2, 3]"), "test").value();
    EXPECT_EQ(work_of(recipe), 3 * 48'000);
}

/// A sound recipe with all kinds of parts.
std::string everything(bool loops) {
    return head(0.6, loops) + "drive = 2\necho_s = 0.1\necho = 0.4\n" +
           part("tone",
                "hz = 300\nsweep_to = 150\nsweep_s = 0.2\ndecay = 0.4\nratios = [1, 2.5]\ntremolo_hz = 9\n"
                "tremolo = 0.5\nvibrato_hz = 6\nvibrato = 1") +
           part("tone", "hz = 210\nlevel = 0.2\nvibrato_hz = 5\nvibrato = 0.5") +
           part("noise", "filter = \"band\"\nhz = 1500\nvibrato_hz = 3\nvibrato = 7\nlevel = 0.3") +
           part("noise", "filter = \"low\"\nhz = 4000\nsweep_to = 300\ndecay = 0.5\nlevel = 0.3") +
           part("grains",
                "rate = 40\nrate_to = 90\nlow_hz = 400\nhigh_hz = 1800\nring = 0.05\nglide = 5\neven = 0.4") +
           part("score",
                "beats_per_minute = 240\ndecay = 0.5\nnotes = [{ beat = 1, beats = 0.5, key = 71.5 }]");
}

std::uint64_t hash_of(const Sound& sound) { return hash_bytes(std::as_bytes(std::span(sound.samples))); }

TEST(AudioRecipe, SamplesAreTheSameOnEveryMachine) {
    EXPECT_EQ(hash_of(made(everything(false))), 11098594882461400845ULL);
    EXPECT_EQ(hash_of(made(everything(true))), 17300803471974343964ULL);
    EXPECT_NE(hash_of(made(everything(true))), hash_of(made("seed = 7\n" + everything(true))));
}

/// Largest difference between neighbouring samples within a loop, and the difference between its last sample
/// and its first, where it repeats.
struct Steps {
    double inside{}, seam{};
};

Steps steps_of(const std::vector<float>& samples) {
    Steps steps{0, std::abs(static_cast<double>(samples.front()) - static_cast<double>(samples.back()))};
    for (std::size_t i = 1; i < samples.size(); ++i)
        steps.inside = std::max(
            steps.inside, std::abs(static_cast<double>(samples[i]) - static_cast<double>(samples[i - 1])));
    return steps;
}

TEST(AudioRecipe, LoopsOfEveryPartHaveNoSeam) {
    const std::vector<std::string> lasting{
        part("tone", "hz = 333.3\nratios = [1, 1.007, 2.61]"),
        part("tone", "hz = 201.7\nvibrato_hz = 3.3\nvibrato = 7\ntremolo_hz = 4.4\ntremolo = 0.9"),
        part("noise", "filter = \"low\"\nhz = 90"),
        part("noise", "filter = \"band\"\nhz = 150\nsharpness = 30\nvibrato_hz = 1.1\nvibrato = 9"),
        part("grains", "rate = 30\nlow_hz = 70\nhigh_hz = 100\nring = 0.3"),
        part(
            "score",
            "attack = 0.3\ndecay = 1\nbeats_per_minute = 120\nnotes = [{ beat = 0.3, beats = 0.8, key = 40.3 "
            "}]"),
    };
    for (const auto& keys : lasting) {
        for (const double seconds : {0.5, 0.73, 1.0007}) {
            auto samples = made(head(seconds, true) + keys).samples;
            const auto whole = steps_of(samples);
            EXPECT_LE(whole.seam, 1.01 * whole.inside) << keys << seconds;
            // The slope of the curve does not jump at the seam either.
            const auto kink = [&](std::size_t i) {
                const std::size_t n = samples.size();
                return std::abs(static_cast<double>(samples[(i + n - 1) % n]) -
                                2 * static_cast<double>(samples[i]) +
                                static_cast<double>(samples[(i + 1) % n]));
            };
            double inside = 0;
            for (std::size_t i = 1; i + 1 < samples.size(); ++i) inside = std::max(inside, kink(i));
            EXPECT_LE(std::max(kink(0), kink(samples.size() - 1)), 1.05 * inside) << keys << seconds;
        }
    }
    // A tone of 333.3 Hz, cut in the middle of a period, has a seam that steps_of must detect.
    auto cut = made(head(0.5, true) + lasting[0]).samples;
    cut.resize(cut.size() - 61);
    EXPECT_GT(steps_of(cut).seam, 2 * steps_of(cut).inside);
}

TEST(AudioRecipe, SilenceStaysSilent) {
    const auto sound = made(head(0.2) + part("tone", "hz = 440\nlevel = 0\ndecay = 0.1"));
    EXPECT_EQ(peak_of(sound.samples), 0);
    EXPECT_EQ(sound.samples.size(), 9600U);
}

TEST(AudioSounds, FolderIsReadInOrder) {
    const TemporaryFolder folder;
    for (const char* name : {"b", "a_long", "a"})
        ASSERT_TRUE(write_text_file(folder.path() / text(name, ".toml"), head(0.1) + good_tone));
    ASSERT_TRUE(write_text_file(folder.path() / "SOUNDS.md", "words"));
    const auto bank = load_sounds(folder.path()).value();
    ASSERT_EQ(bank.sounds.size(), 3U);
    EXPECT_EQ(bank.sounds[0].name, "a");
    EXPECT_EQ(bank.sounds[2].name, "b");
    EXPECT_EQ(bank.find("a_long"), 1U);
}

TEST(AudioSounds, FolderFaultsNameTheFile) {
    const TemporaryFolder folder;
    const auto fault = [&] { return message_of(load_sounds(folder.path())); };
    EXPECT_NE(fault().find("holds no sounds"), std::string::npos) << fault();
    for (int i = 0; i < 9; ++i)
        ASSERT_TRUE(write_text_file(folder.path() / text("a", i, ".toml"), head(15, true) + good_tone));
    EXPECT_NE(fault().find("longer than 120 s"), std::string::npos) << fault();
    EXPECT_NE(message_of(load_sounds(folder.path() / "none")).find("cannot be read"), std::string::npos);
}

TEST(AudioSounds, AFaultyRecipeCostsItsOwnSoundOnly) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_text_file(folder.path() / "a.toml", head(0.1) + good_tone));
    ASSERT_TRUE(write_text_file(folder.path() / "bell.toml", head(0.1) + part("tone", "hz = 5")));
    ASSERT_TRUE(write_text_file(folder.path() / "large.toml", std::string(70'000, '#')));
    ASSERT_TRUE(write_text_file(folder.path() / "z.toml", head(0.1) + good_tone));
    const auto bank = load_sounds(folder.path()).value();
    ASSERT_EQ(bank.sounds.size(), 2U);
    EXPECT_EQ(bank.find("z"), 1U);
    EXPECT_FALSE(bank.find("bell"));
    ASSERT_EQ(bank.faulty.size(), 2U);
    EXPECT_EQ(bank.faulty[0].name, "bell");
    EXPECT_EQ(bank.faulty[0].fault.message,
              text(folder.path().string(), "/bell.toml:9: 'hz' is 5, must be from 20 to 20000"));
    EXPECT_NE(bank.faulty[1].fault.message.find(text(folder.path().string(), "/large.toml")),
              std::string::npos)
        << bank.faulty[1].fault.message;
}

TEST(AudioSounds, WithoutSamplesASoundHasAllElse) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_text_file(folder.path() / "a.toml", head(0.1) + good_tone));
    const auto bank = load_sounds(folder.path(), WithSamples::no), whole = load_sounds(folder.path());
    ASSERT_TRUE(bank.has_value() && whole.has_value());
    ASSERT_EQ(bank->sounds.size(), 1U);
    EXPECT_TRUE(bank->sounds[0].samples.empty());
    EXPECT_FALSE(whole->sounds[0].samples.empty());
    EXPECT_EQ(bank->sounds[0].description, whole->sounds[0].description);
    EXPECT_EQ(bank->sounds[0].reach_m, whole->sounds[0].reach_m);
}

}  // namespace
}  // namespace thaum::audio
