// game/app/gesture/gesture_report.h: the measurements of `thaum gesture eval` as text, JSON and SVG.
#pragma once
#include <optional>
#include <string>

#include "gesture/trials/evaluation.h"

namespace thaum::game::inline app {

struct GestureReport {
    std::string file, method, protocol, channels;
    std::size_t templates{}, repeats{}, strokes{}, users{};
    gesture::Evaluation evaluation;
    /// Calibration error of the probabilities that the recogniser computes from the templates alone.
    double own_calibration_error{};
    bool has_own_calibration = false;
    double at = 1;  ///< share of each tested stroke that the recogniser was given, from its start
    std::optional<gesture::Certainty>
        /// How often a gesture is shown to the player before the stroke ends, and how often it is then right
        certainty{};
    /// Median and 99th percentile of the time of a recognition, with normalisation of the stroke (us)
    double median_us{}, p99_us{};
};

std::string report_text(const GestureReport& report);
std::string report_json(const GestureReport& report);
/// SVG picture with the confusion matrix on the left and the reliability diagram on the right.
std::string report_svg(const GestureReport& report);

}  // namespace thaum::game::inline app
