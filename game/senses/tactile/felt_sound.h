// game/senses/tactile/felt_sound.h: sounds as they are felt on a jacket (paper 004's acoustic-tactile display): how strong
// music and effects are in three bands of frequencies, for each listener. It follows the audio frames of a match and
// knows the course of each sound (audio/bands.h). So it needs no samples and no sound device, and equal frames give
// equal strengths.
#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include "audio/bands.h"
#include "core/error.h"

namespace thaum::game {

/// The bands, from the lowest, by the names of their tables in assets/tactile/sound.toml.
inline constexpr std::array<std::string_view, 3> felt_band_names{"low", "middle", "high"};
inline constexpr std::size_t felt_bands = felt_band_names.size();

struct FeltBands {
    std::array<audio::Band, felt_bands> bands{};
    std::array<double, felt_bands> full{};  ///< amplitude that is felt at full strength
};
/// The error names the file, line and key.
Expected<FeltBands> load_felt_bands(const std::filesystem::path& file);

/// Courses of all sounds of a bank in these bands.
struct FeltCourses {
    FeltBands bands{};
    std::vector<audio::BandCourse> sounds{};  ///< by number of the sound
};
FeltCourses felt_courses(const audio::SoundBank& bank, const FeltBands& bands);

/// Sounds that a player wants to feel.
enum class FeltGroups : std::uint8_t { music, effects, both };
struct FeltSoundWish {
    double strength{};  ///< 0 (off) to 1
    FeltGroups groups{};
    bool operator==(const FeltSoundWish&) const = default;
};

/// Strength of each band, 0 to 1.
using BandStrengths = std::array<double, felt_bands>;

class FeltSound {
public:
    /// Keeps the reference.
    explicit FeltSound(const FeltCourses& courses) : courses_(courses) {}

    /// Takes the frame of the eight ticks that have passed.
    void follow(const audio::AudioFrame& frame);
    /// Forgets all voices, after a jump to another time.
    void stop();
    /// What a listener of the last frame (0 or 1) feels.
    BandStrengths strengths(std::uint32_t listener, const FeltSoundWish& wish) const;

private:
    /// A voice that sounds.
    struct Playing {
        audio::Voice voice{};
        double at{};  ///< time since its start (samples of its sound)
        bool told{};  ///< lasting voices: it is in the present frame
    };
    /// Voices that begin are the shorter ones: the largest match has far fewer at once.
    static constexpr std::size_t most_begun = 64, most_lasting = 32;
    /// Sums of squared amplitudes by group and band.
    using Powers = std::array<std::array<double, felt_bands>, audio::sound_groups>;

    bool is_known(const audio::Voice& voice) const { return voice.sound < courses_.sounds.size(); }
    void begin(const audio::Voice& voice);
    void keep_up(const audio::Voice& voice);
    void add(const Playing& playing, const audio::AudioFrame& frame);
    static void advance(Playing& playing);

    const FeltCourses& courses_;
    std::array<Playing, most_begun> begun_{};
    std::array<Playing, most_lasting> lasting_{};
    std::size_t begun_count_{}, lasting_count_{};
    std::array<Powers, audio::most_listeners> powers_{};
};

}  // namespace thaum::game
