#include "game/senses/tactile/felt_sound.h"

#include <algorithm>
#include <cmath>

#include "audio/mixer.h"
#include "core/config.h"
#include "core/file.h"

namespace thaum::game::inline senses {
namespace {

/// Share of a sound's amplitude that remains behind a wall, as in the audio mixer.
constexpr double behind_wall = 0.5;

/// Loudness of a voice (a playing sound) for a listener.
double loudness(const audio::Voice& voice, const audio::BandCourse& course, const audio::AudioFrame& frame,
                std::size_t listener) {
    if (voice.at_ear) return voice.gain;
    const double distance = glm::length(voice.position - frame.listeners.at(listener).position);
    return voice.gain * audio::distance_gain(distance, course.near_m, course.reach_m) *
           (1 - (1 - behind_wall) * voice.muffled.at(listener));
}

}  // namespace

Expected<FeltBands> load_felt_bands(const std::filesystem::path& path) {
    const auto content = read_text_file(path, 1U << 16U);
    if (!content) return content.error();
    const auto file = Config::parse(*content, path.string(), 1);
    if (!file) return file.error();
    FeltBands out;
    for (std::size_t i = 0; i < felt_bands; ++i) {
        const auto table = file->root().table(felt_band_names.at(i));
        auto& band = out.bands.at(i);
        band = {table.number("low_hz", {10, 1000}), table.number("high_hz", {20, 1200})};
        if (band.low_hz >= band.high_hz) table.report("low_hz", "'low_hz' must be below 'high_hz'");
        out.full.at(i) = table.number("full", {0.001, 1});
    }
    if (const auto checked = file->check(); !checked) return checked.error();
    return out;
}

FeltCourses felt_courses(const audio::SoundBank& bank, const FeltBands& bands) {
    return {bands, audio::band_courses(bank, bands.bands)};
}

void FeltSound::begin(const audio::Voice& voice) {
    if (is_known(voice) && begun_count_ < max_begun) begun_.at(begun_count_++) = {.voice = voice};
}

/// Continues a lasting voice (a playing sound), or starts it.
void FeltSound::keep_up(const audio::Voice& voice) {
    if (!is_known(voice)) return;
    const auto end = lasting_.begin() + static_cast<std::ptrdiff_t>(lasting_count_);
    const auto known = std::find_if(lasting_.begin(), end, [&](const Playing& playing) {
        return playing.voice.key == voice.key && playing.voice.sound == voice.sound;
    });
    if (known == end && lasting_count_ == max_lasting) return;
    if (known == end) lasting_.at(lasting_count_++) = {};
    known->voice = voice;
    known->told = true;
}

void FeltSound::add(const Playing& playing, const audio::AudioFrame& frame) {
    const auto& course = courses_.sounds[playing.voice.sound];
    const auto levels = course.at(playing.at);
    const auto listeners = std::min<std::size_t>(frame.listener_count, audio::max_listeners);
    for (std::size_t i = 0; i < listeners; ++i) {
        if ((playing.voice.heard_by >> i & 1U) == 0) continue;
        const double gain = loudness(playing.voice, course, frame, i);
        auto& powers = powers_.at(i).at(static_cast<std::size_t>(course.group));
        for (std::size_t band = 0; band < felt_bands; ++band) {
            const double amplitude = gain * static_cast<double>(levels.at(band));
            powers.at(band) += amplitude * amplitude;
        }
    }
}

void FeltSound::advance(Playing& playing) {
    playing.at += playing.voice.pitch * static_cast<double>(audio::frame_samples);
    playing.told = false;
}

void FeltSound::follow(const audio::AudioFrame& frame) {
    powers_ = {};
    for (const auto& voice : frame.begins) begin(voice);
    for (const auto& voice : frame.lasts) keep_up(voice);
    const auto keep = [](auto& list, std::size_t& count, auto ended) {
        const auto end = list.begin() + static_cast<std::ptrdiff_t>(count);
        count = static_cast<std::size_t>(std::remove_if(list.begin(), end, ended) - list.begin());
    };
    keep(lasting_, lasting_count_, [](const Playing& playing) { return !playing.told; });
    keep(begun_, begun_count_, [this](const Playing& playing) {
        return courses_.sounds[playing.voice.sound].has_ended(playing.at);
    });
    const auto play = [&](Playing& playing) {
        add(playing, frame);
        advance(playing);
    };
    std::for_each_n(begun_.begin(), begun_count_, play);
    std::for_each_n(lasting_.begin(), lasting_count_, play);
}

void FeltSound::stop() {
    begun_count_ = lasting_count_ = 0;
    powers_ = {};
}

BandStrengths FeltSound::strengths(std::uint32_t listener, const FeltSoundWish& wish) const {
    constexpr auto music = static_cast<std::size_t>(audio::SoundGroup::music);
    constexpr auto effects = static_cast<std::size_t>(audio::SoundGroup::effects);
    BandStrengths out{};
    const auto& powers = powers_.at(listener);
    for (std::size_t band = 0; band < felt_bands; ++band) {
        double power = 0;
        if (wish.groups != FeltGroups::effects) power += powers.at(music).at(band);
        if (wish.groups != FeltGroups::music) power += powers.at(effects).at(band);
        out.at(band) = wish.strength * std::min(1.0, std::sqrt(power) / courses_.bands.full.at(band));
    }
    return out;
}

}  // namespace thaum::game::inline senses
