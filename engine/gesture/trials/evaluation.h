// gesture/trials/evaluation.h: tests a method of recognition on the strokes of a data set: how often it is
// right, and how well its probabilities predict that.
//
// Protocols. They differ in the strokes from which K templates of each gesture are drawn at random:
//
//     user_dependent   from one user; that user's other strokes are tested
//     leave_user_out   from all users but one; all strokes of that one are tested
//     random           from all users; all other strokes are tested
//
// Each protocol is repeated with other random templates. In an open set, a random share of the gestures has
// no templates: strokes of these are tested too, and the right answer is "nothing".
//
// Probabilities and thresholds for the strokes of one group are fitted to the strokes of the other groups. A
// group is a user; where the data have one user, the strokes with odd numbers and those with even numbers are
// two groups.
#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "gesture/trials/methods.h"

namespace thaum::gesture {

/// How an evaluation divides the strokes into templates and tested strokes (see the top of this file).
enum class Protocol : std::uint8_t { user_dependent, leave_user_out, random };

/// The protocol with this name; std::nullopt: there is none.
std::optional<Protocol> protocol_of(std::string_view name);

/// Settings of an evaluation.
struct EvaluationSettings {
    Method method = Method::standard;
    Protocol protocol = Protocol::leave_user_out;
    std::size_t templates = 1;  ///< number of templates of each gesture
    std::size_t repeats = 10;
    Channels channels{};
    double at = 1;  ///< share of each tested stroke's length that the method gets, from its start: 0 to 1
    double unknown_share = 0;  ///< share of gestures without templates, 0 to less than 1
    std::uint64_t seed = 1;
    /// true: keep the method's own probabilities, which it made from templates alone; false: fit new ones to
    /// the data set.
    bool own_calibration = false;
};

/// One tested stroke.
struct Trial {
    std::uint32_t truth{};   ///< gesture of the stroke
    std::uint32_t answer{};  ///< nearest gesture; 0xffffffff: the stroke has no shape
    bool known{};            ///< true if the gesture had templates
    std::uint32_t group{};
    Evidence evidence{};
    double probability{};  ///< probability that the stroke was meant as `answer`

    /// Whether the stroke's gesture had templates and the answer is that gesture.
    bool right() const { return known && answer == truth; }
};

/// Tested strokes with about the same probability, to compare it with the share of right answers among them.
struct ReliabilityBin {
    std::size_t count{};
    double confidence{};  ///< mean probability
    double right{};       ///< share of right answers
};

/// How well strokes of gestures without templates ("unknown") are refused, and the others ("known") accepted.
struct OpenSet {
    /// Share of the strokes of known gestures that are accepted as the right gesture, at the chosen
    /// thresholds.
    double correct_accepts{};
    double false_accepts{};  ///< share of unknown strokes that are accepted, at the chosen thresholds
    /// Share of known strokes that are accepted as the right gesture, at a threshold that is chosen on the
    /// tested strokes themselves so that it accepts 1 % of the unknown ones.
    double best_correct_accepts{};
};

/// Results of the test of one method on all strokes.
struct Evaluation {
    std::vector<std::string> gestures;
    std::vector<Trial> trials;
    double accuracy{};  ///< share of the strokes of known gestures whose nearest gesture is right
    std::vector<std::vector<std::size_t>>
        confusion;  ///< [truth][answer]; the last column is for strokes without a shape
    std::array<ReliabilityBin, 10> reliability{};
    /// Expected calibration error: mean of |confidence - right| over the bins, weighted by their strokes.
    double calibration_error{};
    std::optional<OpenSet> open_set;
};

/// The gestures and users of a data set in the order of their names, and to which of them each stroke
/// belongs.
struct GestureIndex {
    std::vector<std::string> gestures, users;
    /// For each stroke, the number of its gesture and of its user.
    std::vector<std::uint32_t> gesture_of, user_of;
};
/// Finds all gestures and users of a set.
GestureIndex index_of(std::span<const Stroke> strokes);

/// How often a method is sure of its answer, and how often it is right then.
struct Certainty {
    /// Share of the strokes whose answer has at least the wanted probability ("sure" answers).
    double told{};
    double right{};  ///< share of the sure answers that are right; 0 if there are none
};
/// Certainty of a method that gives only answers of at least this probability.
Certainty certainty_of(const Evaluation& evaluation, double min_probability);

/// The gestures of one fold (a round of the test), with the strokes that are their templates.
std::vector<Gesture> gestures_of(std::span<const Stroke> strokes, const GestureIndex& index,
                                 std::span<const std::vector<std::size_t>> templates);

/// Draws the templates of one fold (a round of the test) at random: for each gesture, the numbers of its
/// strokes. `user` is the user of the fold; not used by the protocol `random`.
std::vector<std::vector<std::size_t>> draw_templates(const GestureIndex& index, Protocol protocol,
                                                     std::uint32_t user, std::size_t count, Random& random);

/// Tests a method on strokes. The error names what the data lack: users for leave_user_out, or strokes for so
/// many templates.
Expected<Evaluation> evaluate(std::span<const Stroke> strokes, const EvaluationSettings& settings);

}  // namespace thaum::gesture
