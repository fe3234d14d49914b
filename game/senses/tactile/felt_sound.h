// game/senses/tactile/felt_sound.h: sounds as felt on a jacket (paper 004's acoustic-tactile display): the
// strength of music and effects in three frequency bands, for each listener. It uses the audio frames of a
// match and the strength of each sound over time (audio/bands.h). So it needs neither samples nor a sound
// device, and equal frames give equal strengths.
#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include "audio/bands.h"
#include "core/error.h"

namespace thaum::game::inline senses {

/// Names of the bands, lowest first, which are also the names of their tables in assets/tactile/sound.toml.
inline constexpr std::array<std::string_view, 3> felt_band_names{"low", "middle", "high"};
inline constexpr std::size_t felt_bands = felt_band_names.size();

struct FeltBands {
    std::array<audio::Band, felt_bands> bands{};
    std::array<double, felt_bands> full{};  ///< for each band, amplitude that is felt at full strength
};
/// Loads the frequency bands in which sounds are felt. The error names file, line and key.
Expected<FeltBands> load_felt_bands(const std::filesystem::path& file);

/// Strength over time of all loaded sounds (the bank), in each frequency band of `bands`.
struct FeltCourses {
    FeltBands bands{};
    /// Strength over time of each sound, indexed by the sound's number.
    std::vector<audio::BandCourse> sounds{};
};
FeltCourses felt_courses(const audio::SoundBank& bank, const FeltBands& bands);

/// Kinds of sound that a player has chosen to feel.
enum class FeltGroups : std::uint8_t { music, effects, both };
struct FeltSoundWish {
    double strength{};  ///< strength of all sounds on the jacket, 0 (off) to 1
    FeltGroups groups{};
    bool operator==(const FeltSoundWish&) const = default;
};

/// Strength of sound in each frequency band, 0 to 1.
using BandStrengths = std::array<double, felt_bands>;

class FeltSound {
public:
    /// Keeps a reference to `courses` (strengths of the sounds over time), which must outlive this object.
    explicit FeltSound(const FeltCourses& courses) : courses_(courses) {}

    /// Reads the audio frame of the last eight ticks.
    void follow(const audio::AudioFrame& frame);
    /// Ends all voices (playing sounds), after a jump to another time.
    void stop();
    /// Strength in each frequency band that a listener of the last frame (0 or 1) feels.
    BandStrengths strengths(std::uint32_t listener, const FeltSoundWish& wish) const;

private:
    /// A voice, which is a sound that is playing.
    struct Playing {
        audio::Voice voice{};
        double at{};  ///< time since the voice started (samples of its sound)
        bool told{};  ///< for a voice that lasts, true: it is in the present frame
    };
    /// Capacity for sounds played once, and for lasting ones; even the largest match has far fewer at the
    /// same time.
    static constexpr std::size_t max_begun = 64, max_lasting = 32;
    /// Sums of squared amplitudes, by group of sounds and frequency band.
    using Powers = std::array<std::array<double, felt_bands>, audio::sound_groups>;

    bool is_known(const audio::Voice& voice) const { return voice.sound < courses_.sounds.size(); }
    void begin(const audio::Voice& voice);
    void keep_up(const audio::Voice& voice);
    void add(const Playing& playing, const audio::AudioFrame& frame);
    static void advance(Playing& playing);

    const FeltCourses& courses_;
    std::array<Playing, max_begun> begun_{};
    std::array<Playing, max_lasting> lasting_{};
    std::size_t begun_count_{}, lasting_count_{};
    std::array<Powers, audio::max_listeners> powers_{};
};

}  // namespace thaum::game::inline senses
