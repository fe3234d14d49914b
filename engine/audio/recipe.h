// audio/recipe.h: recipes of sounds as plain data, read from TOML files (assets/sounds, SOUNDS.md there).
//
// A sound is the sum of its parts. Each part has an envelope, which sets its gain over time:
//
//     level      ________
//               /        \.
//              /           '- .
//     0  _____/                 ' - . _____
//       start attack hold    decay
//
// A sound that loops is a circle: whatever would pass its end continues at its start, so it has no seam.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "audio/sound.h"
#include "core/error.h"

namespace thaum::audio {

/// Gain of a part over time.
struct Envelope {
    double start{};        ///< time at which the part begins (s)
    double attack{0.002};  ///< time of the rise (s)
    double hold{};         ///< time at the full level (s)
    double decay{};        ///< time of a fall by 60 dB (s); 0: the part lasts to the end of the sound
    double level{1};       ///< amplitude of the part, before the finished sound is scaled
    double tremolo_hz{};   ///< periods of the tremolo per second (Hz)
    double tremolo{};      ///< share of the level that the tremolo takes away, 0 to 1
};

/// A frequency over time. It glides evenly, in octaves, to `sweep_to`, then stays.
struct Pitch {
    double hz{};          ///< frequency at the start (Hz)
    double sweep_to{};    ///< frequency at the end of the sweep (Hz)
    double sweep_s{};     ///< length of the sweep (s)
    double vibrato_hz{};  ///< periods of the vibrato per second (Hz)
    double vibrato{};     ///< largest deviation by the vibrato (semitones)
};

/// One sine wave of a tone.
struct Partial {
    double ratio{1};  ///< frequency as a multiple of the tone's frequency
    double level{1};  ///< amplitude as a multiple of the tone's level
    double decay{1};  ///< decay as a multiple of the tone's decay
};

/// Sine waves: a tone, a swept tone, or the modes of a struck body.
struct Tone {
    Envelope envelope;
    Pitch pitch;
    std::vector<Partial> partials;
};

/// Filter of a noise: which frequencies pass.
enum class NoiseFilter : std::uint8_t { low, band, high };

/// White noise through two equal filters in a row. Its strength does not depend on the width of the band.
struct Noise {
    Envelope envelope;
    Pitch pitch;  ///< cutoff of a low or high filter, centre of a band
    NoiseFilter filter{};
    double sharpness{0.7};  ///< quality factor of each filter; a band is about hz / sharpness wide
};

/// Short decaying sine waves at random times, as in a creak, a rattle or bubbles.
struct Grains {
    Envelope envelope;  ///< gain of a grain, taken at the time at which it starts
    double rate{};      ///< grains per second at the start of the part
    double rate_to{};   ///< grains per second at the end of the part
    double even{};      ///< regularity: 0 for random intervals, 1 for equal ones
    double low_hz{};    ///< lowest frequency of a grain (Hz)
    double high_hz{};   ///< highest frequency of a grain (Hz)
    double ring{};      ///< time in which a grain falls by 60 dB (s)
    double glide{};     ///< rise of a grain's frequency while the grain falls by 60 dB (semitones)
    /// Spread of the strengths of grains. 0: all are equally strong; 1: each has a random share, 0 to 1, of
    /// the level.
    double spread{};
};

/// One note of a score.
struct Note {
    double beat{};    ///< time at which the note starts (beats)
    double beats{};   ///< length of the note (beats)
    double key{};     ///< MIDI number: 69 is 440 Hz, and each 1 more is a semitone up
    double level{1};  ///< amplitude as a multiple of the part's level
};

/// Notes that are all played with the same envelope and partials. The envelope's `hold` is unused: a note is
/// held for its own length.
struct Score {
    Envelope envelope;
    std::vector<Partial> partials;
    double vibrato_hz{};  ///< periods of the vibrato per second (Hz)
    double vibrato{};     ///< largest deviation by the vibrato (semitones)
    double beats_per_minute{};
    std::vector<Note> notes;
};

/// One layer of a sound.
using Part = std::variant<Tone, Noise, Grains, Score>;

/// A sound as a data file describes it.
struct Recipe {
    std::string name;
    std::string description;
    std::string caption;  ///< words on the screen for people who do not hear the sound; empty: none
    bool important{};     ///< true: the caption is shown even to players who want few captions
    SoundGroup group{};
    bool loops{};
    double near_m{1.5};  ///< distance up to which the sound has its full loudness (m)
    double reach_m{40};  ///< distance beyond which the sound is silent (m)
    double seconds{};    ///< length of the sound (s)
    double level{};      ///< largest amplitude of the finished sound, at most 0.9
    double drive{};      ///< strength of the compression of loud moments, 0 to 20
    double echo_s{};     ///< delay of the echo (s); 0: none
    double echo{};       ///< amplitude of each echo as a share of the one before
    std::uint64_t seed{};
    std::vector<Part> parts;
};

/// Reads a recipe. `name` names the sound; messages call the file NAME.toml.
Expected<Recipe> read_recipe(std::string_view toml, std::string name);

/// Number of operations on samples that making the sound of a recipe takes. `read_recipe` refuses a recipe
/// with too many.
double work_of(const Recipe& recipe);

}  // namespace thaum::audio
