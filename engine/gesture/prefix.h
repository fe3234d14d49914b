// gesture/prefix.h: the likely gesture of a stroke that is still being drawn.
//
// A recogniser compares whole strokes, so it takes the first half of an S for another gesture, or for none.
// Here each recorded stroke is cut at eight shares of its length, and the stroke so far is compared with all
// of these beginnings: by the dot product of their shapes first, then elastically with the nearest ones
// (elastic.h). It is unknown how much of the stroke is still to come. But people draw a gesture at about the
// same size and pace each time. So the distance of a beginning grows with the differences of its length and
// its duration from those of the stroke so far. How much these differences weigh depends on how well the
// recorded strokes of a gesture agree in length and duration. With one recorded stroke of each gesture, that
// is unknown, and durations do not count. Nor do durations count where the force only follows the speed:
// there a hand is slow or fast on purpose, for a gentle or a harsh stroke.
//
// Where several strokes of a gesture were recorded, the distances to all of them count, and the nearest
// counts most.
//
// Strokes of closed gestures may start anywhere, so beginnings are cut from several starts. A gesture that is
// not sensitive to direction has those of its strokes drawn backwards as well. Rotations are not tried.
//
// Force. Twins are gestures of one shape that differ in force (recogniser.h). Between them, the mean force so
// far decides: it is compared with the mean force of equally long beginnings. While it lies between the
// forces of two twins, neither is likely.
//
// Confidence. Distances become a probability as in calibration.h, by weights that are fitted to beginnings of
// synthetic strokes and scribbles. The share of the gesture that has been drawn is evidence too: late in a
// stroke, the right gesture has larger distances than early. Everything is fixed at construction, and equal
// input gives equal bits. At most sixteen solid and sixteen flat beginnings are compared elastically, however
// many there are.
//
// Steady answers. `tell` repeats its last answer until that gesture has become unlikely or another one is
// likely enough, so that what the player sees does not flicker.
#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "gesture/calibration.h"
#include "gesture/elastic.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

class Recogniser;

/// Shares of a recorded stroke's length at which it is cut; the parts from its start to each cut are compared
/// with a stroke that is still being drawn.
inline constexpr std::array<double, lanes> prefix_shares{0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1};

/// The first points of a stroke, up to a share of its length (0 to 1). There is at least one point, unless
/// the stroke is empty.
Points beginning_of(Points stroke, double share);

/// Probability from which on the likely gesture is shown to the player, and probability below which a gesture
/// that is shown is hidden again.
inline constexpr double likely_enough = 0.8, likely_still = 0.4;

/// The gesture that an unfinished stroke is likely to become.
struct LikelyGesture {
    static constexpr std::uint32_t none = 0xffffffff;

    std::uint32_t gesture = none;  ///< the likeliest gesture; none for a stroke without a shape
    /// Evidence as for a whole stroke, but `usual` is the logarithm of the share of the gesture drawn so far.
    Evidence evidence{};
    /// Probability that the stroke will be `gesture`, 0 to 1. It is 0 for a stroke that is shorter than the
    /// first beginning, because that is too early to judge.
    double probability{};
};

/// Settings of a PrefixReader.
struct PrefixSettings {
    Channels channels{};
    std::uint64_t seed = 1;  ///< seed of the synthetic strokes
    /// false: skip the synthetic strokes, for a caller that calibrates with real ones.
    bool calibrate = true;
};

/// Working memory for calls of a PrefixReader. It is reused, so that only the first call allocates. Each
/// thread needs its own.
struct PrefixSpace {
    /// Beginning of a recorded stroke that is to be compared elastically.
    struct Candidate {
        /// Distance from the stroke so far by the dot product, plus the amounts that differences of length
        /// and of duration add.
        float distance{};
        std::uint32_t place{};  ///< index of the recorded stroke in PrefixReader's beginnings
        std::uint32_t lane{};   ///< index in prefix_shares at which the stroke is cut
    };
    ShapeSpace points{};
    Shape shape{};
    EightShapes eight{};
    std::array<std::array<float, shape_points * max_channels>, lanes> chosen{};
    std::vector<Candidate> candidates{};
    /// For one gesture, the beginning of a recorded stroke that is nearest to the stroke so far.
    struct Nearest {
        float distance{};
        /// Natural logarithm of the share of the recorded stroke's length that the stroke so far has reached.
        float log_share{};
        float force{};  ///< mean force of the recorded beginning (unit of the strokes)
    };
    /// For each gesture, the beginning of a recorded stroke that is nearest to the stroke so far.
    std::vector<Nearest> nearest{};
    /// For each recorded stroke, the distance of its nearest beginning.
    std::vector<float> stroke_distance{};
    float force{};  ///< mean force of the stroke so far (unit of the strokes)
};

/// Compares unfinished strokes with beginnings of the templates.
class PrefixReader {
public:
    /// Cuts the recorded strokes into beginnings. The error names the gesture and the fault: no stroke, a
    /// stroke without a shape, or too many strokes. Gestures that Recogniser::make refuses are refused here,
    /// too.
    static Expected<PrefixReader> make(std::span<const Gesture> gestures,
                                       const PrefixSettings& settings = {});

    /// Number of gestures.
    std::size_t gestures() const { return names_.size(); }
    /// Name of a gesture.
    const std::string& name(std::uint32_t gesture) const { return names_[gesture]; }
    /// Finds the likeliest gesture of a stroke that may be unfinished. Allocates nothing after the first call
    /// with the same space.
    LikelyGesture read(Points stroke, PrefixSpace& space) const;
    /// The gesture that is shown to the player as the likely one, or LikelyGesture::none. `told` is the
    /// answer for a shorter part of the same stroke, or none. Allocates as `read` does.
    std::uint32_t tell(Points stroke, std::uint32_t told, PrefixSpace& space) const;

private:
    /// Eight beginnings of one recorded stroke (shares of its length: prefix_shares), from one of its starts
    /// and in one direction.
    struct Beginnings {
        std::uint32_t gesture{};
        std::uint32_t stroke{};  ///< number of the recorded stroke, among those of all gestures
        bool as_drawn{};         ///< true: from the stroke's own start and in its own direction
        std::size_t channels{};
        EightShapes values{};
        std::array<float, lanes> square{};       ///< dot product of each beginning with itself
        std::array<float, lanes> log_length{};   ///< natural logarithm of the length (unit of the strokes)
        std::array<float, lanes> log_seconds{};  ///< natural logarithm of the duration (s)
        std::array<float, lanes> force{};        ///< mean force (unit of the strokes)
    };
    /// Distances that are added if the natural logarithms of two lengths (or of two durations) differ by 1.
    struct Weights {
        float length{}, seconds{};
    };

    Weights weights_of_agreement() const;
    Expected<void> add(const Gesture& gesture, PrefixSpace& space);
    bool add_stroke(std::span<const StrokePoint> stroke, const GestureOptions& options, PrefixSpace& space);
    void calibrate(std::span<const Gesture> gestures, std::uint64_t seed, PrefixSpace& space);
    std::size_t choose(const Shape& shape, PrefixSpace& space) const;
    void verify(const Shape& shape, std::size_t first, std::size_t end, PrefixSpace& space) const;
    void join_strokes(PrefixSpace& space) const;
    void take_twins(const Recogniser& recogniser);
    bool are_twins(std::uint32_t a, std::uint32_t b) const;
    double share_by_distance(std::uint32_t gesture, float distance, const PrefixSpace& space) const;
    double share_by_force(std::uint32_t gesture, const PrefixSpace& space) const;
    LikelyGesture likelihood_of(std::uint32_t gesture, const PrefixSpace& space) const;
    LikelyGesture likeliest(const PrefixSpace& space) const;

    Channels channels_{};
    std::vector<std::string> names_;
    std::vector<Beginnings> beginnings_;
    std::vector<std::uint32_t> gesture_of_stroke_;
    std::vector<std::vector<std::uint32_t>> twins_;  ///< for each gesture, others that differ in force alone
    Calibration calibration_{};
    Weights weights_{};
    bool needs_solid_ = false, needs_flat_ = false;
};

}  // namespace thaum::gesture
