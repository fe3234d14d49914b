// gesture/calibration.h: how the distances of a stroke from the gestures become a probability, and the
// decision whether it is accepted.
//
// The evidence of a recognition is three numbers: the logarithm of the stroke's distance from the nearest
// gesture, the logarithm of the ratio of its distance from the second nearest gesture (the runner-up) to that
// distance (at most 2), and the logarithm of the distance that strokes of the nearest gesture usually have
// from one another. The probability that the stroke was meant is a logistic function of them (Platt 1999),
// whose weights are fitted to labelled strokes by Newton's method. Labelled strokes are synthetic at
// recording time (variations.h), or real where there are some.
//
// Synthetic strokes differ in three ways from what a person draws. Half of them or more mean no gesture. They
// are nearer to the templates than strokes of other users are, in some sets by half. And they scatter more
// than the strokes of one user. So the probability that they give is too low for a stroke that somebody drew
// on purpose: on average by 0.1 to 0.7 with one template of another user. `probability_on_purpose` corrects
// that. It decides which of two gestures was meant by the ratio of their distances alone, with one weight for
// all sets of gestures. It takes into account that few strokes mean no gesture, and that some strokes which
// resemble none are only drawn differently from the templates.
#pragma once
#include <array>
#include <span>
#include <vector>

namespace thaum::gesture {

/// Numbers on which the probability of a recognition depends.
struct Evidence {
    double distance{};  ///< natural logarithm of the stroke's distance from the nearest gesture
    /// Natural logarithm of the ratio of the stroke's distance from the second nearest gesture (the
    /// runner-up) to that from the nearest one, 0 to 2.
    double margin{};
    double usual{};  ///< natural logarithm of the usual distance between strokes of this gesture
};

/// The evidence from the distances of a stroke to the nearest gesture and to the second nearest (the
/// runner-up), both >= 0. `usual` is the distance that strokes of the nearest gesture usually have from one
/// another, > 0.
Evidence evidence_of(float distance, float runner_up, float usual);

/// Evidence of a stroke whose meaning is known.
struct LabelledEvidence {
    Evidence evidence;
    bool meant{};  ///< true if the user meant the nearest gesture
    double weight = 1;
};

/// Turns distances into the probability that a stroke was meant as its nearest gesture.
struct Calibration {
    /// Weights of the constant 1 and of the numbers distance, margin and usual of an Evidence.
    std::array<double, 4> weights{};
    std::vector<float> usual;  ///< for each gesture, the usual distance between its strokes
    /// For each gesture, the distance from which on a stroke is not accepted as that gesture.
    std::vector<float> threshold;

    /// Probability that the stroke was meant as the nearest gesture, 0 to 1.
    double probability(const Evidence& evidence) const;
};

/// Probability that a stroke which somebody drew on purpose was meant as the nearest gesture, from the
/// distances of that gesture and of the second nearest (the runner-up), both >= 0. `even` is the probability
/// fitted to synthetic strokes, half of which mean no gesture.
double probability_on_purpose(float distance, float runner_up, double even);

/// Fits the weights of the logistic function to strokes whose meaning is known. If all of them were meant, or
/// none, the weights give a probability near 1, or near 0.
std::array<double, 4> fit_weights(std::span<const LabelledEvidence> samples);

}  // namespace thaum::gesture
