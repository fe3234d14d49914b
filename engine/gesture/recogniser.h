// gesture/recogniser.h: recognises which gesture a stroke is, with a probability, and how hard it was drawn.
//
//     stroke -> shape -> dot product with every template -> elastic distance to the best 8 to 64
//            -> distance of each gesture -> probability, runner-up, acceptance
//
// There is no training. One to three strokes of each gesture are enough. The dot product (paper 000, Mora and
// Lee 2008, section 8, here of positions, directions, turns and force) takes some nanoseconds a template. It
// leaves few templates for the elastic distance, which decides. The distance of a gesture is that of its
// nearest template and, with half the weight, of the second nearest. The mean of several recorded strokes of
// a gesture is a template as well.
//
// Variations. A stroke of a closed gesture may start anywhere: the dot product chooses the start among the
// points of the template. A gesture with a tolerance of rotation is turned by the angle with the largest dot
// product. A gesture that is not sensitive to direction has its templates drawn backwards as well.
//
// Force. Gestures of one shape whose strokes differ in mean force are twins. The more their forces differ and
// the farther all other gestures are, the less alike their strokes need be. Between twins the mean force of
// the stroke decides, together with the small difference of the distances.
//
// Confidence: distances become a probability as calibration.h describes. Everything is fixed at construction.
// `recognise` allocates nothing, and equal input gives equal bits in every thread and on every processor.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/error.h"
#include "gesture/calibration.h"
#include "gesture/elastic.h"
#include "gesture/gesture.h"

namespace thaum::gesture {

/// How hard a stroke was drawn.
enum class ForceClass : std::uint8_t { gentle, normal, harsh };

/// Result of recognising a stroke.
struct Recognition {
    static constexpr std::uint32_t none = 0xffffffff;

    std::uint32_t gesture = none;    ///< nearest gesture; none for a stroke without a shape
    std::uint32_t runner_up = none;  ///< nearest gesture of another shape; none if no other was compared
    float distance{};                ///< elastic distance of the nearest gesture
    float runner_up_distance{};
    Evidence evidence{};   ///< the distances in the form to which a calibration is fitted
    double probability{};  ///< probability that the stroke, drawn on purpose, was meant as `gesture`, 0 to 1
    /// Probability that the stroke was meant as `gesture`, 0 to 1, under the assumption that half of all
    /// strokes mean nothing. A stroke is accepted by this probability.
    double even_probability{};
    bool accepted{};  ///< false: the stroke counts as none of the gestures
    ForceClass force = ForceClass::normal;
    double mean_force{};  ///< mean force along the path (unit of the device)
    /// Time of the first point that is not left out as a rest, after the stroke's first point (s).
    double start{};
    /// Time of the last point that is not left out as a rest, after the stroke's first point (s).
    double end{};
};

/// Settings of a Recogniser.
struct RecogniserSettings {
    Channels channels{};
    /// True to compare every template elastically, not only those that the dot product chooses. This is
    /// slower, and serves to test that choice.
    bool exhaustive = false;
    double min_probability = 0.5;  ///< `even_probability` from which on a stroke is accepted
    std::uint64_t seed = 1;        ///< seed of the synthetic strokes that set the thresholds
    /// True to count a force that only follows the speed of the hand, too. In continuous motion the pace
    /// distinguishes a gesture, which is slow at its corners and ends, from other motion of the hand. But a
    /// stroke that is drawn evenly, as with a mouse, is then far from a template that is not.
    bool pace_counts = false;
    /// False to skip the synthetic strokes, for a caller that calibrates with real ones. Then no stroke is
    /// refused for its distance, and the usual distance of a gesture is that between its recorded strokes.
    bool calibrate = true;
};

/// Working memory for calls of a Recogniser. It is reused, so that only the first call allocates. Each thread
/// needs its own.
class RecogniserSpace {
public:
    RecogniserSpace();

private:
    friend class Recogniser;
    friend class Spotter;
    friend class CloseLook;
    struct Survivor {
        float score{};               ///< dot product with the stroke
        std::uint32_t place{};       ///< index of the template
        std::uint32_t shift{};       ///< point at which a closed template starts
        float cosine = 1, sine = 0;  ///< cosine and sine of the angle by which the template is turned
    };
    struct Nearest {
        float first{}, second{};  ///< least distances to two different recorded strokes
        std::uint32_t stroke{};   ///< number of the recorded stroke at the distance `first`
        std::uint32_t count{};    ///< number of recorded strokes compared: 0, 1, or 2 for two and more
    };
    ShapeSpace points_;
    Shape solid_, planar_;
    EightShapes eight_, strokes_;
    std::array<std::array<float, shape_points * max_channels>, lanes> turned_{};
    std::vector<Survivor> survivors_, compared_;
    std::array<float, max_templates> scores_{};
    std::array<Nearest, max_gestures> nearest_{};
    std::size_t survivor_count_{};
};

/// Recognises strokes as one of several gestures by comparing them with recorded strokes, its templates.
class Recogniser {
public:
    /// Prepares the templates and calibrates with synthetic strokes. The error names the gesture and the
    /// fault: no stroke, a stroke without a shape, or too many strokes.
    static Expected<Recogniser> make(std::span<const Gesture> gestures,
                                     const RecogniserSettings& settings = {});

    /// Number of gestures.
    std::size_t gestures() const { return names_.size(); }
    /// Name of a gesture.
    const std::string& name(std::uint32_t gesture) const { return names_[gesture]; }
    /// Number of templates: recorded strokes, their copies drawn backwards, and means of the strokes of a
    /// gesture.
    std::size_t templates() const { return templates_.size(); }
    /// Settings with which the recogniser was made.
    const RecogniserSettings& settings() const { return settings_; }
    /// Conversion of distances to probabilities, and the thresholds of acceptance.
    const Calibration& calibration() const { return calibration_; }
    /// Replaces the calibration, for example by one fitted to strokes of users.
    void set_calibration(Calibration calibration) { calibration_ = std::move(calibration); }

    /// Recognises a whole stroke. Allocates nothing after the first call with the same space.
    Recognition recognise(Points stroke, RecogniserSpace& space) const;
    /// Recognises a part of continuous motion like a whole stroke, except that no rest of the hand is left
    /// out.
    Recognition recognise_part(Points part, RecogniserSpace& space) const;
    /// Recognises a stroke as if the recogniser lacked the gesture `left_out`. With strokes of that gesture
    /// this tests how strokes that mean nothing are treated.
    Recognition recognise_without(Points stroke, std::uint32_t left_out, RecogniserSpace& space) const;

    /// Probability that a stroke was meant as `gesture`, given its distances from this gesture and from the
    /// second nearest (the runner-up), if half of all strokes mean nothing.
    double probability_of(std::uint32_t gesture, float distance, bool has_runner_up,
                          float runner_up_distance) const;
    /// How hard a stroke of this gesture was drawn, by its mean force (unit of the device).
    ForceClass force_class(std::uint32_t gesture, double mean_force) const;
    /// True if the two gestures are twins: of one shape, so that only force tells their strokes apart. A
    /// gesture is no twin of itself.
    bool are_twins(std::uint32_t a, std::uint32_t b) const;
    /// Of a gesture and its twins (gestures of its shape with another force), the one whose templates have
    /// the mean force nearest to `mean_force`.
    std::uint32_t twin_by_force(std::uint32_t gesture, double mean_force) const;

    /// True if the course of the force within a stroke counts. It does not if it is switched off, or if the
    /// recorded forces only follow the speed of the hand (unless RecogniserSettings::pace_counts); mean
    /// forces still tell twins (gestures of one shape) apart then.
    bool counts_force() const { return counts_force_; }
    /// True if some gesture takes z, the depth of a stroke, into account.
    bool needs_solid() const { return needs_solid_; }
    /// True if some gesture ignores z, the depth of a stroke.
    bool needs_flat() const { return needs_flat_; }
    /// Least arc length of the templates (unit of the strokes).
    float shortest() const { return shortest_; }
    /// Largest arc length of the templates (unit of the strokes).
    float longest() const { return longest_; }
    /// Usual time for which a stroke of the gesture lasts (s); 0 if the templates have no times.
    float usual_seconds(std::uint32_t gesture) const { return usual_seconds_[gesture]; }

private:
    friend class Spotter;
    friend class CloseLook;
    struct Template {
        std::uint32_t gesture{};
        /// Number of the recorded stroke among those of the gesture. A copy drawn backwards has the same
        /// number. A template that is the mean of all strokes has the number after the last stroke.
        std::uint32_t stroke{};
        std::uint32_t channels{};
        std::size_t values{};  ///< index in `values_`; the values of a closed gesture stand there twice
        float size{}, length{};
        float self{};  ///< dot product of the template's shape with itself
        bool closed{};
        bool turns{};                 ///< true: the gesture tolerates rotation
        float cosine{}, sine{};       ///< cosine and sine of the largest tolerated angle
        float smallest{}, largest{};  ///< bounds of a stroke's size, as multiples of `size`
    };
    using Survivor = RecogniserSpace::Survivor;

    struct Limits {
        std::uint32_t left_out = Recognition::none;
        float length_range = 0;  ///< largest ratio of the lengths of stroke and template; 0: any
        bool means = true;       ///< false to leave out the means of recorded strokes
        Rests rests = Rests::left_out;
        /// False to leave out not only the gesture `left_out` but also its twins (same shape, other force).
        bool twins = true;
    };

    Expected<void> add(const Gesture& gesture, RecogniserSpace& space);
    bool add_template(Points stroke, std::uint32_t number, std::uint32_t stroke_number,
                      RecogniserSpace& space);
    Expected<void> add_what_strokes_share(const Gesture& gesture, std::size_t first, std::size_t copies,
                                          RecogniserSpace& space);
    Shape shape_of(const Template& t) const;
    void add_mean(std::size_t first, std::size_t step, std::size_t end, RecogniserSpace& space);
    float spread_of(std::size_t first, std::size_t step, RecogniserSpace& space) const;
    void calibrate(std::span<const Gesture> gestures, RecogniserSpace& space);
    void find_twins(std::span<const Gesture> gestures, RecogniserSpace& space);
    Recognition recognise_within(Points stroke, const Limits& limits, RecogniserSpace& space) const;
    Recognition decide(const Shape* solid, const Shape* flat, const Limits& limits,
                       RecogniserSpace& space) const;
    void choose(const Shape& shape, const Limits& limits, std::size_t most, RecogniserSpace& space) const;
    static void keep_best(std::size_t count, std::size_t most, RecogniserSpace& space);
    void verify(const Shape& shape, RecogniserSpace& space) const;
    void note(float distance, const Template& t, RecogniserSpace& space) const;
    const float* lane_values(const Survivor& survivor, std::size_t lane, RecogniserSpace& space) const;
    /// Writes the fine shape (32 points) of a template, from the start and with the turn that fit the stroke
    /// best. Returns which channels it has and whether its axes were made more alike.
    FineKind fine_template(const Survivor& survivor, FineShape& shape) const;
    void score(const Shape& shape, std::size_t count, RecogniserSpace& space) const;
    /// The turn with the largest dot product of stroke and template, and also the best start if the template
    /// is closed.
    Survivor turned_score(const Shape& shape, const Template& t) const;
    /// For a closed template, the point to start at that gives the largest dot product with the stroke.
    Survivor closed_score(const Shape& shape, const Template& t) const;
    Recognition result_of(const Shape& shape, const RecogniserSpace& space) const;
    float distance_of(std::uint32_t gesture, float farthest, const RecogniserSpace& space) const;
    double by_twins(float force, float farthest, const RecogniserSpace& space, Recognition& r) const;
    std::size_t verified_at_most() const;

    RecogniserSettings settings_;
    std::vector<std::string> names_;
    /// Options of each gesture. Where a gesture sets no bounds of gentle and harsh force, the usual ones are
    /// filled in.
    std::vector<GestureOptions> options_;
    std::vector<std::uint32_t> strokes_of_;          ///< number of recorded strokes of each gesture
    std::vector<double> template_force_;             ///< mean force of the templates of each gesture
    std::vector<std::vector<std::uint32_t>> twins_;  ///< for each gesture, others that differ in force alone
    std::vector<Template> templates_;
    std::vector<float> values_;
    std::vector<FineShape> fine_;       ///< fine shape of each template
    std::vector<float> usual_seconds_;  ///< usual duration of the strokes of each gesture (s)
    Calibration calibration_;
    bool counts_force_{}, needs_solid_{}, needs_flat_{};
    float shortest_{}, longest_{};
};

}  // namespace thaum::gesture
