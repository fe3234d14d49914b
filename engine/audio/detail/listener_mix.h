// audio/detail/listener_mix.h: the voices that one listener hears.
//
// For each block, ListenerMix frees the sources that have ended or faded, finds the gain of every voice,
// gives the 64 loudest voices a source, and lets the others fade out within the block. OpenAL moves each gain
// evenly over the block that it renders, so neither a change nor a fade clicks.
#pragma once
#include <array>
#include <memory>
#include <span>

#include "audio/detail/checked_frame.h"
#include "audio/detail/loopback.h"

namespace thaum::audio::detail {

/// The voices of one block, after their values were checked.
struct BlockVoices {
    std::span<const Voice> lasts;
    std::span<const Voice> begins;
};

class ListenerMix {
public:
    /// Makes the mix of the listener with the number `index`, 0 or 1. The facts about the sounds must outlive
    /// this object.
    ListenerMix(std::unique_ptr<Loopback> device, std::span<const SoundFacts> sounds, std::uint32_t index);

    /// Renders one block. `clock` is the number of samples since the mixer was made; `faders` holds the gain
    /// of each group of sounds, such as music.
    void block(const Listener& listener, BlockVoices voices, const std::array<double, sound_groups>& faders,
               std::uint64_t clock, MixReport& report, std::span<float> stereo);
    /// True if a block without voices would be silent.
    bool is_silent() const { return playing_count_ == 0 && silent_blocks_ >= 2; }
    /// Ends all voices at once.
    void silence();
    std::uint32_t voices() const { return heard_; }

    bool hrtf() const { return device_->hrtf(); }
    void set_hrtf(bool wanted) { device_->set_hrtf(wanted); }

private:
    /// A voice that plays, because it has a source of OpenAL.
    struct Playing {
        Voice voice;
        std::uint32_t source{};
        bool lasting{};
        bool fading{};  ///< true: the source is fading out and is freed after this block
        bool chosen{};
        double gain{};
        double pitch{};
        double muffled{};
        fvec3 place{};
    };
    /// A voice that wants a source of OpenAL in this block, to play or to go on playing.
    struct Candidate {
        const Voice* voice{};
        std::int32_t playing{-1};  ///< index of the voice in the list of playing voices; -1: not in the list
        bool lasting{};
        double gain{};
    };
    /// Room for playing and fading voices: as many voices may fade at a time as may play.
    static constexpr std::size_t max_playing = 2 * max_heard;
    static_assert(max_playing + max_heard <= Loopback::max_at_once);
    static constexpr std::size_t max_candidates = max_playing + 32 + max_begins;

    void free_ended();
    void gather(const Listener& listener, BlockVoices voices, const std::array<double, sound_groups>& faders,
                MixReport& report);
    void add(const Candidate& candidate);
    std::int32_t find_lasting(const Voice& voice) const;
    double gain_of(const Voice& voice, const Listener& listener,
                   const std::array<double, sound_groups>& faders) const;
    void choose(MixReport& report);
    void fade_the_rest();
    void change(Playing& playing, const Candidate& candidate, const Listener& listener);
    void start(const Candidate& candidate, const Listener& listener, std::uint64_t clock);

    std::unique_ptr<Loopback> device_;
    std::span<const SoundFacts> sounds_;
    std::uint32_t index_;
    std::uint32_t heard_{};
    std::uint32_t silent_blocks_{2};

    std::array<Playing, max_playing> playing_{};
    std::size_t playing_count_{};
    std::array<Candidate, max_candidates> candidates_{};
    std::size_t candidate_count_{};
    std::array<std::uint32_t, max_heard> starting_{};
    std::size_t starting_count_{};
};

}  // namespace thaum::audio::detail
