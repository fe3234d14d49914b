#include "audio/detail/loopback.h"

#include <algorithm>
#include <cmath>

#include "audio/frame.h"
#include "core/text.h"

namespace thaum::audio::detail {
namespace {

/// Radius of every sound source (m). Nearer to the ear than this, panning fades out, so that a voice that
/// passes through the head does not jump from side to side. A voice at the ear stands at the centre: equal on
/// both sides.
constexpr float source_radius = 0.25F;

/// Resampler for a voice played faster or slower: cubic, number 2 in OpenAL's list.
constexpr ALint cubic_resampler = 2;

// Gain of a voice at full damping by walls, and the further factor on its tones above about 5 kHz.
constexpr double muffled_gain = 0.5, muffled_high_gain = 0.02;

Expected<void> expect_no_error(std::string_view doing) {
    const auto code = alGetError();
    if (code == AL_NO_ERROR) return {};
    return fail(text("OpenAL cannot ", doing, ": error ", code));
}

bool is_playable(float sample) { return std::abs(sample) <= 1; }

/// Samples that OpenAL can play: NaN becomes 0. `changed` holds the copy if any sample had to change.
std::span<const float> playable_samples(const Sound& sound, std::vector<float>& changed) {
    const auto& samples = sound.samples;
    if (!samples.empty() && std::all_of(samples.begin(), samples.end(), is_playable)) return samples;
    changed = samples;
    for (auto& sample : changed) sample = std::isfinite(sample) ? std::clamp(sample, -1.0F, 1.0F) : 0.0F;
    if (changed.empty()) changed.push_back(0);
    return changed;
}

}  // namespace

Expected<std::unique_ptr<Loopback>> Loopback::open(const SoundBank& bank, bool hrtf) {
    const auto al = find_openal();
    if (!al) return al.error();
    std::unique_ptr<Loopback> made(new Loopback(*al));
    if (auto done = made->make_context(hrtf); !done) return done.error();
    const auto scope = made->enter();
    if (auto done = made->upload(bank); !done) return done.error();
    if (auto done = made->make_sources(); !done) return done.error();
    made->warm_up();
    return made;
}

Loopback::~Loopback() {
    if (context_ != nullptr) {
        {
            const auto scope = enter();
            for (const auto& source : pool_)
                if (source.name != 0) alDeleteSources(1, &source.name);
            alDeleteBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
            const auto delete_filters =
                reinterpret_cast<LPALDELETEFILTERS>(alGetProcAddress("alDeleteFilters"));
            if (filter_ != 0 && delete_filters != nullptr) delete_filters(1, &filter_);
        }
        alcDestroyContext(context_);
    }
    if (device_ != nullptr) alcCloseDevice(device_);
}

std::vector<ALCint> Loopback::attributes(bool hrtf) const {
    return {ALC_FREQUENCY,
            static_cast<ALCint>(sample_rate),
            ALC_FORMAT_CHANNELS_SOFT,
            ALC_STEREO_SOFT,
            ALC_FORMAT_TYPE_SOFT,
            ALC_FLOAT_SOFT,
            ALC_HRTF_SOFT,
            hrtf ? ALC_TRUE : ALC_FALSE,
            ALC_OUTPUT_LIMITER_SOFT,
            ALC_FALSE,
            ALC_MONO_SOURCES,
            static_cast<ALCint>(pool_size),
            ALC_STEREO_SOURCES,
            0,
            ALC_MAX_AUXILIARY_SENDS,
            0,
            0};
}

Expected<void> Loopback::make_context(bool hrtf) {
    device_ = al_.open_loopback(nullptr);
    if (device_ == nullptr) return fail("OpenAL opens no device that mixes into memory");
    context_ = alcCreateContext(device_, attributes(hrtf).data());
    if (context_ == nullptr) return fail("OpenAL does not mix stereo at 48 kHz into memory");
    read_hrtf();
    const auto scope = enter();
    alDistanceModel(AL_NONE);
    defer_ = reinterpret_cast<LPALDEFERUPDATESSOFT>(alGetProcAddress("alDeferUpdatesSOFT"));
    process_ = reinterpret_cast<LPALPROCESSUPDATESSOFT>(alGetProcAddress("alProcessUpdatesSOFT"));
    const auto make_filters = reinterpret_cast<LPALGENFILTERS>(alGetProcAddress("alGenFilters"));
    const auto choose_filter = reinterpret_cast<LPALFILTERI>(alGetProcAddress("alFilteri"));
    set_filter_ = reinterpret_cast<LPALFILTERF>(alGetProcAddress("alFilterf"));
    if (defer_ == nullptr || process_ == nullptr || make_filters == nullptr || choose_filter == nullptr ||
        set_filter_ == nullptr || alIsExtensionPresent("AL_EXT_FLOAT32") == AL_FALSE)
        return fail("this OpenAL lacks filters or samples as numbers; install OpenAL Soft 1.19 or newer");
    make_filters(1, &filter_);
    choose_filter(filter_, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
    return expect_no_error("make a filter");
}

void Loopback::read_hrtf() {
    ALCint on = ALC_FALSE;
    alcGetIntegerv(device_, ALC_HRTF_SOFT, 1, &on);
    hrtf_ = on == ALC_TRUE;
}

void Loopback::set_hrtf(bool wanted) {
    al_.reset(device_, attributes(wanted).data());
    read_hrtf();
}

Expected<void> Loopback::upload(const SoundBank& bank) {
    buffers_.resize(bank.sounds.size());
    loops_.resize(bank.sounds.size());
    alGenBuffers(static_cast<ALsizei>(buffers_.size()), buffers_.data());
    for (std::size_t i = 0; i < buffers_.size(); ++i) {
        std::vector<float> changed;
        const auto samples = playable_samples(bank.sounds[i], changed);
        loops_[i] = bank.sounds[i].loops;
        alBufferData(buffers_[i], AL_FORMAT_MONO_FLOAT32, samples.data(),
                     static_cast<ALsizei>(samples.size_bytes()), static_cast<ALsizei>(sample_rate));
        if (auto kept = expect_no_error(text("keep the sound ", bank.sounds[i].name)); !kept) return kept;
    }
    return {};
}

Expected<void> Loopback::make_sources() {
    const bool can_resample = alIsExtensionPresent("AL_SOFT_source_resampler") != AL_FALSE &&
                              alGetInteger(AL_NUM_RESAMPLERS_SOFT) > cubic_resampler;
    for (std::uint32_t i = 0; i < pool_size; ++i) {
        auto& source = pool_[i];
        alGenSources(1, &source.name);
        alSourcei(source.name, AL_SOURCE_RELATIVE, AL_TRUE);
        alSourcef(source.name, AL_SOURCE_RADIUS, source_radius);
        if (can_resample) alSourcei(source.name, AL_SOURCE_RESAMPLER_SOFT, cubic_resampler);
        if (!buffers_.empty()) attach(source, static_cast<std::uint32_t>(i % buffers_.size()));
    }
    return expect_no_error("make the sources");
}

void Loopback::attach(Source& source, std::uint32_t sound) {
    alSourcei(source.name, AL_BUFFER, static_cast<ALint>(buffers_[sound]));
    alSourcei(source.name, AL_LOOPING, loops_[sound] ? AL_TRUE : AL_FALSE);
    source.sound = sound;
    source.has_sound = true;
}

void Loopback::warm_up() {
    if (buffers_.empty()) return;
    std::array<float, 2 * frame_samples> unheard{};
    // OpenAL Soft starts with memory for 256 voices. It doubles this memory when so many sources are started
    // that it could run out. Such a start is made now, so that none allocates during play.
    const auto playing = std::span(pool_).first(max_at_once);
    for (int round = 0; round < 3; ++round) {
        begin_changes();
        for (const auto& source : playing) {
            alSourcef(source.name, AL_GAIN, round == 0 ? 0.0F : 1e-6F * static_cast<float>(round));
            alSourcePlay(source.name);
        }
        end_changes();
        render(unheard);
    }
    for (const auto& source : playing) {
        alSourceStop(source.name);
        alSourcef(source.name, AL_GAIN, 0.0F);
    }
    render(unheard);
}

void Loopback::render(std::span<float> stereo) { al_.render(device_, stereo.data(), frame_samples); }

std::uint32_t Loopback::take(std::uint32_t sound) {
    Source* best = nullptr;
    for (auto& source : pool_) {
        if (source.busy) continue;
        const bool fits = source.has_sound && source.sound == sound;
        const bool best_fits = best != nullptr && best->has_sound && best->sound == sound;
        if (best == nullptr || (fits && !best_fits) || (fits == best_fits && source.freed < best->freed))
            best = &source;
    }
    // The pool has more sources than voices can play and fade at a time, so one is always free.
    if (!best->has_sound || best->sound != sound) attach(*best, sound);
    best->busy = true;
    return static_cast<std::uint32_t>(best - pool_.data());
}

void Loopback::give_back(std::uint32_t source) {
    alSourceStop(pool_[source].name);
    pool_[source].busy = false;
    pool_[source].freed = ++moment_;
}

bool Loopback::has_ended(std::uint32_t source) const {
    ALint state{};
    alGetSourcei(pool_[source].name, AL_SOURCE_STATE, &state);
    return state != AL_PLAYING;
}

void Loopback::set_gain(std::uint32_t source, double gain) const {
    alSourcef(pool_[source].name, AL_GAIN, static_cast<float>(gain));
}

void Loopback::set_pitch(std::uint32_t source, double pitch) const {
    alSourcef(pool_[source].name, AL_PITCH, static_cast<float>(pitch));
}

void Loopback::set_place(std::uint32_t source, fvec3 place) const {
    alSource3f(pool_[source].name, AL_POSITION, place.x, place.y, place.z);
}

void Loopback::set_muffled(std::uint32_t source, double muffled) const {
    if (muffled <= 0) {
        alSourcei(pool_[source].name, AL_DIRECT_FILTER, AL_FILTER_NULL);
        return;
    }
    set_filter_(filter_, AL_LOWPASS_GAIN, static_cast<float>(std::lerp(1, muffled_gain, muffled)));
    set_filter_(filter_, AL_LOWPASS_GAINHF, static_cast<float>(std::lerp(1, muffled_high_gain, muffled)));
    // The source keeps a copy of the filter's values, so one filter serves all sources.
    alSourcei(pool_[source].name, AL_DIRECT_FILTER, static_cast<ALint>(filter_));
}

void Loopback::set_start(std::uint32_t source, std::uint32_t sample) const {
    alSourcei(pool_[source].name, AL_SAMPLE_OFFSET, static_cast<ALint>(sample));
}

void Loopback::start(std::span<const std::uint32_t> sources) const {
    std::array<ALuint, pool_size> names{};
    for (std::size_t i = 0; i < sources.size(); ++i) names[i] = pool_[sources[i]].name;
    if (!sources.empty()) alSourcePlayv(static_cast<ALsizei>(sources.size()), names.data());
}

}  // namespace thaum::audio::detail
