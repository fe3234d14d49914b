// gesture/calibration.h: how distances become a probability and an acceptance.
//
// The evidence of a recognition is three numbers: the logarithm of the distance, the logarithm of the ratio of the
// runner-up's distance to it (at most 2), and the logarithm of the usual distance of the gesture. The probability
// that the stroke was meant is a logistic function of them (Platt 1999), whose weights are fitted to labelled strokes
// by Newton's method. Labelled strokes are synthetic at recording time (variations.h), or real where there are some.
//
// Synthetic strokes differ in three ways from what a person draws. Half of them or more mean nothing. They are nearer to the
// templates than strokes of other users, in some sets by half. And they scatter more than strokes of one user. So the
// probability that they give is too low for a stroke that somebody drew on purpose: on average by 0.1 to 0.7 with one
// template of another user. `probability_on_purpose` mends that. Which of two gestures was meant is a matter of the ratio of
// their distances alone, with one weight for all sets of gestures. That a stroke means nothing is rare, and some that seem
// to are only drawn otherwise than the templates.
#pragma once
#include <array>
#include <span>
#include <vector>

namespace thaum::gesture {

struct Evidence {
    double distance{};  ///< natural logarithm of the nearest gesture's distance
    double margin{};    ///< natural logarithm of the ratio of the runner-up's distance to it, 0 to 2
    double usual{};     ///< natural logarithm of the usual distance of strokes of this gesture
};

/// Evidence of two distances, >= 0. `usual` is a distance > 0.
Evidence evidence_of(float distance, float runner_up, float usual);

struct LabelledEvidence {
    Evidence evidence;
    bool meant{};  ///< true if the stroke was meant as the nearest gesture
    double weight = 1;
};

struct Calibration {
    /// Weights of 1, distance, margin and usual distance.
    std::array<double, 4> weights{};
    std::vector<float> usual;      ///< usual distance of each gesture
    std::vector<float> threshold;  ///< distance from which on a stroke is not the gesture

    double probability(const Evidence& evidence) const;
};

/// Probability that a stroke which somebody drew on purpose was meant as the nearest gesture, by its distance and the
/// runner-up's, both >= 0. `even` is the probability by synthetic strokes, of which every second one means nothing.
double probability_on_purpose(float distance, float runner_up, double even);

/// Fits the weights. With evidence of one kind alone, the result is the weights whose probability is near that kind.
std::array<double, 4> fit_weights(std::span<const LabelledEvidence> samples);

}  // namespace thaum::gesture
