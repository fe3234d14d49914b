// tactile/effect.h: effects on the body as data: what players feel when something happens. Files:
// assets/tactile/effects.
//
// An effect is a grating that is drawn over the skin at 1 m/s (paper 004, "Virtual Reality Game Modeling for
// a Haptic Jacket", section 3.2; see grating.h), so a wavelength of 12 mm lasts 12 ms and gives a carrier of
// 83 Hz. Its force, as a share of the 5 N of the paper's motors, is the strength of the motors. The paper
// names five parameters: amplitude A, wavelength L, stiffness K, effect pattern and force shaping; here they
// are `weakest` to `strongest`, `wavelength`, `stiffness`, `pattern` and `envelope`.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "core/units.h"
#include "tactile/body.h"
#include "tactile/clip.h"
#include "tactile/grating.h"

namespace thaum::tactile {

/// Force that counts as full strength (N): that of the motors of the haptic jacket in paper 004.
inline constexpr double full_force = 5;
/// Speed at which the grating, the virtual ridges of an effect, is drawn over the skin (m/s).
inline constexpr double skin_speed = 1;

/// Time from the first beat of a heart to the second (ms).
inline constexpr double second_beat_ms = 160;
/// Amplitude of a heart's second beat as a share of the first beat's amplitude.
inline constexpr double second_beat = 0.6;

/// How a grating, the virtual ridges drawn over the skin, makes a force: along the normal of the flat wall
/// beneath it (impact), or along the normal of the grating (vibration). `both` is the mean of the two.
enum class Method : std::uint8_t { impact, vibration, both };

/// Purposes of effects, such as blasts or warnings. Each purpose has a volume fader of its own.
enum class Purpose : std::uint8_t {
    impact,
    blast,
    fall,
    walk,
    magic,
    warning,
    recoil,
    fluid,
    texture,
    music
};
inline constexpr std::size_t purpose_count = 10;
/// Names of the purposes of effects as in data files, in the order of Purpose.
const std::vector<std::string_view>& purpose_names();

/// Strength over time: the strength rises, is held, and falls (ms).
struct Envelope {
    double attack{};
    double hold{};
    double decay{};
    bool smooth{};  ///< true: smooth curves; false: straight lines

    /// Duration of the whole envelope (ms).
    double length() const { return attack + hold + decay; }
    /// Strength at a time since the beginning (ms), 0 to 1.
    double at(double ms) const;
    /// Greatest strength within a span of time (ms). Frames use it, so that even a short effect is felt.
    double peak(double from, double to) const;
};

/// How an effect is laid over the body.
///
///     single     about one place
///     spread     a wave that runs over the skin from a place
///     sweep      one place that moves to another (apparent motion)
///     heartbeat  about one place, two beats in each period
///     clip       as recorded in a .tact file; envelope and places are not used
enum class Pattern : std::uint8_t { single, spread, sweep, heartbeat, clip };

/// Something felt on the body, as a data file describes it.
struct Effect {
    std::string name{};
    std::string description{};  ///< plain description for a table of effects
    std::string caption{};      ///< words on the screen while the effect is felt; empty: none
    bool important{};           ///< true: the caption is shown even to players who want few captions
    Method method{};
    double weakest{};     ///< amplitude of the virtual ridges (the grating) at strength 0 (m)
    double strongest{};   ///< amplitude of the virtual ridges (the grating) at strength 1 (m)
    double wavelength{};  ///< distance between neighbouring ridges of the grating (m)
    double stiffness{};   ///< stiffness of the skin's contact with the grating (N/m)
    double damping{};     ///< damping of the skin's contact with the grating (N s/m)
    Envelope envelope{};
    Pattern pattern{};
    double speed{};       ///< speed of a wave that spreads over the skin (m/s)
    double reach{};       ///< distance at which a wave that spreads over the skin has faded away (m)
    double slowest_hz{};  ///< heartbeats a second at strength 0 (Hz)
    double fastest_hz{};  ///< heartbeats a second at strength 1 (Hz)
    /// Duration of a sweep, or of the heartbeats after one call of TactileMixer::start (ms).
    double length_ms{};
    /// One or two places where the effect is felt; empty: where the caller says.
    std::vector<BodyPoint> places{};
    std::optional<BodyPoint> to{};  ///< place at which a sweep ends
    /// Width of the felt spot along the two directions of the skin's chart, as the standard deviation of a
    /// Gaussian (cells, the distances between neighbouring actuators).
    vec2 sigma_cells{0.7};
    std::string clip_file{};        ///< name of the .tact file beside the effect's own file
    std::vector<ClipFrame> clip{};  ///< frames of the recording in clip_file
    Purpose purpose{};
    /// Priority, 0 to 9. When no more effects can play at a time, a new effect replaces one of lower or equal
    /// priority.
    int priority{};

    /// Frequency of the carrier (Hz).
    double carrier() const { return skin_speed / wavelength; }
    /// Amplitude of the grating, the virtual ridges drawn over the skin, for a strength from 0 to 1 (m).
    double amplitude(double strength) const { return weakest + (strongest - weakest) * strength; }
    /// Amplitude of the motors, 0 to 1: half of the force's swing over a period, as a share of full_force (5
    /// N).
    double level(double strength) const;
    /// Time until the effect is silent at every place (ms).
    double duration_ms() const;
};

/// Force of an effect at one moment, as a share of full_force (5 N).
struct Signal {
    /// Component along the normal of the flat wall beneath the grating (the virtual ridges).
    double into_skin{};
    /// Component along the flat wall beneath the grating (the virtual ridges); 0 for impacts.
    double along_skin{};
};
/// Force at a time since the beginning (ms), before any limit, for outputs that play the wave itself.
Signal signal(const Effect& effect, double strength, double ms);

/// Reads an effect file. An error names file, line and key. The frames of a clip are not
/// read; `load_effects` reads them.
Expected<Effect> read_effect(const Config& file, std::string name);

/// All effects of a program, sorted by name. An effect's number, by which the mixer is told to play it, is
/// its index.
struct EffectBank {
    std::vector<Effect> effects;
    std::vector<LeftOut> faulty{};  ///< effects that were left out because of faults, sorted by name

    /// Returns the number of the effect with this name; std::nullopt: there is none.
    std::optional<std::uint32_t> find(std::string_view name) const;
};

/// Reads every .toml file of a folder, each at most 64 KiB, and the .tact files that they name. A faulty
/// effect is left out; the others are kept. The error says that the folder cannot be read, or has too many
/// effects.
Expected<EffectBank> load_effects(const std::filesystem::path& folder);

}  // namespace thaum::tactile
