// game/app/gesture/gesture_report.h: what `thaum gesture eval` has measured, as text, JSON and SVG.
#pragma once
#include <optional>
#include <string>

#include "gesture/trials/evaluation.h"

namespace thaum::app {

struct GestureReport {
    std::string file, method, protocol, channels;
    std::size_t templates{}, repeats{}, strokes{}, users{};
    gesture::Evaluation evaluation;
    double own_calibration_error{};  ///< error of the probabilities from the templates alone
    bool has_own_calibration = false;
    double at = 1;  ///< share of each tested stroke that was shown
    std::optional<gesture::Certainty>
        certainty{};               ///< how often an early answer is told to the player, and then right
    double median_us{}, p99_us{};  ///< time of a recognition, shape included (us)
};

std::string report_text(const GestureReport& report);
std::string report_json(const GestureReport& report);
/// Confusion matrix on the left, reliability diagram on the right.
std::string report_svg(const GestureReport& report);

}  // namespace thaum::app
