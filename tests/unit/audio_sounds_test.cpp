// Tests of the game's sounds: complete, within their levels, without clicks, and distinguishable from each
// other.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "audio/analysis.h"
#include "audio/synth.h"
#include "core/hash.h"
#include "core/maths.h"
#include "core/random.h"
#include "core/text.h"

namespace thaum::audio {
namespace {

const std::filesystem::path folder = std::filesystem::path(THAUM_SOURCE_DIR) / "assets/sounds";

const SoundBank& bank() {
    static const SoundBank made = [] { return load_sounds(folder).value(); }();
    return made;
}

double sample_of(const Sound& sound, std::size_t i) { return static_cast<double>(sound.samples[i]); }

/// Largest step between neighbouring samples within [from, to).
double max_step(const Sound& sound, std::size_t from, std::size_t to) {
    double largest = 0;
    for (std::size_t i = std::max<std::size_t>(from, 1); i < to; ++i)
        largest = std::max(largest, std::abs(sample_of(sound, i) - sample_of(sound, i - 1)));
    return largest;
}

TEST(GameSounds, AllAreThere) {
    std::string names;
    for (const auto& sound : bank().sounds) names += sound.name + " ";
    EXPECT_EQ(names,
              "blast_burst blast_charge blast_shot boil boil_over bolt_shot boon brew_fault brew_step carve "
              "cast_fog "
              "cast_push cast_recall cast_shield chipped core_near count_go count_tick death fall_hit "
              "hands_full heartbeat hit_metal hit_soft hit_stone hit_wizard hit_wizard_hard hit_wood "
              "ingredient_dropped ingredient_put_away ingredient_taken jump land last_seconds lens "
              "lift_hold lift_take lift_throw lob_burst lob_draw lob_shot mana_surge menu_back menu_choose "
              "menu_move "
              "menu_refused mode_change music_calm music_final music_pulse music_tension no_focus orb_hum "
              "orb_told poison potion potion_over power_heart power_spark power_vial pushed respawn "
              "round_drawn round_lost round_won shield_hit splash spoilt step_metal step_stone step_wood "
              "stir stroke_fails swing_latch swing_rope tool_change wand_change wand_dry work_begun "
              "work_broken work_done work_half work_lost wrested ");
    std::string loops;
    for (const auto& sound : bank().sounds)
        if (sound.loops) loops += sound.name + " ";
    EXPECT_EQ(loops,
              "blast_charge boil carve lift_hold lob_draw music_calm music_final music_pulse music_tension "
              "orb_hum stir swing_rope ");
}

TEST(GameSounds, AreTheSameWhenMadeAgain) {
    const auto again = load_sounds(folder).value();
    for (std::size_t i = 0; i < bank().sounds.size(); ++i)
        EXPECT_EQ(hash_bytes(std::as_bytes(std::span(bank().sounds[i].samples))),
                  hash_bytes(std::as_bytes(std::span(again.sounds[i].samples))))
            << bank().sounds[i].name;
}

TEST(GameSounds, FitIntoMemoryAndStart) {
    std::size_t samples = 0;
    for (const auto& sound : bank().sounds) samples += sound.samples.size();
    EXPECT_LT(samples * sizeof(float), 16'000'000U);
}

TEST(GameSounds, NoneClips) {
    for (const auto& sound : bank().sounds) {
        for (const float sample : sound.samples) ASSERT_TRUE(std::isfinite(sample)) << sound.name;
        EXPECT_LE(peak_of(sound.samples), 0.9 + 1e-6) << sound.name;
        EXPECT_GT(peak_of(sound.samples), 0.1) << sound.name;
    }
}

TEST(GameSounds, BeginAndEndWithoutAClick) {
    for (const auto& sound : bank().sounds) {
        const std::size_t n = sound.samples.size(), edge = sample_rate / 1000;
        const double inside = max_step(sound, 0, n);
        if (sound.loops) {
            EXPECT_LE(std::abs(sample_of(sound, 0) - sample_of(sound, n - 1)), inside) << sound.name;
            continue;
        }
        EXPECT_EQ(sample_of(sound, 0), 0) << sound.name;
        EXPECT_EQ(sample_of(sound, n - 1), 0) << sound.name;
        // The end is silent. The start may be as sharp as other parts of the sound, but no sharper.
        EXPECT_LE(max_step(sound, n - edge, n), 0.002) << sound.name;
        EXPECT_LE(max_step(sound, 0, 8), max_step(sound, 8, n)) << sound.name;
    }
}

TEST(GameSounds, AreHeardAtOnce) {
    constexpr std::size_t moment = sample_rate / 50;  // 20 ms (samples)
    for (const auto& sound : bank().sounds) {
        double sum = 0;
        for (std::size_t i = 0; i < moment; ++i) sum += sample_of(sound, i) * sample_of(sound, i);
        const double db = 10 * std::log10(sum / moment + 1e-20);
        EXPECT_GT(db, loudest_db(sound.samples) - 36) << sound.name;
        EXPECT_GT(db, -52) << sound.name;
    }
}

TEST(GameSounds, LoudnessIsInTheRangeOfItsGroup) {
    // Range of each group for the level of a sound's loudest 50 ms (dB). Footsteps are the quietest
    // effects, explosions the loudest.
    const std::map<SoundGroup, std::pair<double, double>> ranges{{SoundGroup::effects, {-25, -6}},
                                                                 {SoundGroup::music, {-23, -18}},
                                                                 {SoundGroup::interface, {-23, -13}}};
    for (const auto& sound : bank().sounds) {
        const auto [low, high] = ranges.at(sound.group);
        EXPECT_GE(loudest_db(sound.samples), low) << sound.name;
        EXPECT_LE(loudest_db(sound.samples), high) << sound.name;
    }
}

TEST(GameSounds, HaveNoOffset) {
    for (const auto& sound : bank().sounds) {
        const double sum = std::accumulate(sound.samples.begin(), sound.samples.end(), 0.0,
                                           [](double a, float b) { return a + static_cast<double>(b); });
        EXPECT_LT(std::abs(sum / static_cast<double>(sound.samples.size())), 0.003) << sound.name;
    }
}

TEST(GameSounds, ReachesAreSensible) {
    for (const auto& sound : bank().sounds) {
        EXPECT_LE(sound.near_m, 5) << sound.name;
        EXPECT_LE(sound.reach_m, 100) << sound.name;
    }
    const auto reach = [](std::string_view name) { return bank().sounds[*bank().find(name)].reach_m; };
    EXPECT_GT(reach("blast_burst"), 57);  // 57 m: the length of the court (an arena) from corner to corner
    EXPECT_LT(reach("step_stone"), 20);
}

TEST(GameSounds, LayersOfTheMusicFitTogether) {
    std::vector<double> sum;
    for (const auto& sound : bank().sounds) {
        if (sound.group != SoundGroup::music) continue;
        sum.resize(std::max(sum.size(), sound.samples.size()));
        ASSERT_EQ(sum.size(), sound.samples.size()) << sound.name;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += sample_of(sound, i);
    }
    EXPECT_EQ(sum.size(), 7.2 * sample_rate);
    double peak = 0;
    for (const double sample : sum) peak = std::max(peak, std::abs(sample));
    EXPECT_LT(peak, 0.9);
}

/// The sound with variations as they may occur in the game: faster or slower, quieter, with noise at -20 dB.
std::vector<float> varied(const Sound& sound, Random& random) {
    const double pitch = random.uniform(0.9, 1.1), gain = random.uniform(0.3, 1);
    double power = 0;
    for (const float sample : sound.samples)
        power += static_cast<double>(sample) * static_cast<double>(sample);
    const double noise = 0.1 * std::sqrt(3 * power / static_cast<double>(sound.samples.size()));
    std::vector<float> heard;
    for (double at = 0; at < static_cast<double>(sound.samples.size() - 1); at += pitch) {
        const auto i = static_cast<std::size_t>(at);
        const double share = at - static_cast<double>(i);
        const double sample = sample_of(sound, i) * (1 - share) + sample_of(sound, i + 1) * share;
        heard.push_back(static_cast<float>(gain * (sample + noise * random.uniform(-1, 1))));
    }
    return heard;
}

std::size_t nearest(const Signature& heard, const std::vector<Signature>& known) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < known.size(); ++i)
        if (distance(heard, known[i]) < distance(heard, known[best])) best = i;
    return best;
}

TEST(GameSounds, EachIsToldFromTheOthers) {
    std::vector<Signature> known;
    for (const auto& sound : bank().sounds) known.push_back(signature_of(sound.samples));
    constexpr int variations = 20;
    std::map<std::string, int> confusions;
    int wrong = 0;
    for (std::size_t i = 0; i < known.size(); ++i) {
        Random random = random_stream(22, i);
        for (int v = 0; v < variations; ++v) {
            const auto found = nearest(signature_of(varied(bank().sounds[i], random)), known);
            if (found == i) continue;
            ++wrong;
            ++confusions[text(bank().sounds[i].name, " heard as ", bank().sounds[found].name)];
        }
    }
    const int all = variations * static_cast<int>(known.size());
    std::printf("%d of %d variations of %zu sounds are taken for another sound\n", wrong, all, known.size());
    for (const auto& [pair, count] : confusions)
        std::printf("  %s: %d of %d\n", pair.c_str(), count, variations);
    EXPECT_LE(wrong, 0.05 * all);
}

}  // namespace
}  // namespace thaum::audio
