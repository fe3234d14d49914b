// gesture/trials/spotting.h: how well gestures are found in continuous motion.
//
// Templates come from other users than the session's. The session is fed to the spotter in ticks of 1 ms;
// between two points of the session the hand rests at the earlier one. A report is right if it names the
// gesture of a label and overlaps the label by half of the shorter of both, once for each label. All
// other reports are false, except those that overlap an ignored stroke of the same gesture, which count
// neither way. Such strokes are attempts without a label, as in the protocol of Taranta et al. (2020),
// whose sessions hold many of them.
//
// For each user, the threshold of the score (the largest one that is reported) is chosen on the sessions of
// the other users.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "core/error.h"
#include "gesture/spotter.h"
#include "gesture/stroke_csv.h"

namespace thaum::gesture {

/// Settings of an evaluation of the spotter, which finds gestures in continuous motion.
struct SpottingSettings {
    std::size_t templates = 1;  ///< number of templates of each gesture
    std::size_t repeats = 3;    ///< number of rounds, each with other random templates
    Channels channels{false, false};
    std::uint64_t seed = 1;
    SpotterSettings spotter{};
    std::vector<SessionLabel> ignored{};  ///< strokes that may be reported but need not be
};

/// Result for one way to choose thresholds, over all repeats.
struct SpottingScore {
    std::size_t right{}, wrong{}, missed{};
    double precision{}, recall{}, f1{};
    double false_per_hour{};
    double low_per_hour{}, high_per_hour{};  ///< ends of the 95 % confidence interval of false_per_hour
    double threshold{};                      ///< mean of the chosen thresholds (largest reported score)
    double delay{};                          ///< median time from the end of the label to the report (s)
};

/// How well gestures are found in sessions.
struct Spotting {
    SpottingScore best;    ///< score at the thresholds with the best F1 on other users
    SpottingScore at_six;  ///< score at thresholds with at most 6 false reports an hour on other users
    SpottingScore at_two;  ///< score at thresholds with at most 2 false reports an hour on other users
    double hours{};        ///< total length of all sessions, each counted once (h)
    std::size_t sessions{}, labels{};
    /// Share of the points at which windows (parts of the motion) end that were skipped to limit the work of
    /// a tick.
    double skipped{};
};

/// Tests the spotter on sessions. The error names what is missing: a label, another user, or a gesture of the
/// labels among the strokes.
Expected<Spotting> evaluate_spotting(const SessionSet& sessions, std::span<const SessionLabel> labels,
                                     std::span<const Stroke> strokes, const SpottingSettings& settings);

}  // namespace thaum::gesture
