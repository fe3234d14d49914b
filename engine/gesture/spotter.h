// gesture/spotter.h: finds gestures in continuous motion, without a button.
//
//     point each tick -> front end: a point for each step of arc length, with the sum of length and the time
//                     -> windows of several lengths that end now: shape, dot product with the templates
//                     -> the 16 best pairs of window and template: elastic distance
//                     -> the best window of each gesture, once no better one follows: close look
//                        (close_look.h)
//                     -> candidates -> the best of those that overlap is reported after a short wait
//
// The score of a candidate is the distance of the close look, times factors for other signs of a gesture: how
// usual such distances are for the gesture, whether the hand rested before and after it, and whether it
// lasted as long as the templates.
//
// The work of a tick has a hard limit: `windows_per_tick` windows (parts of the motion), or one comparison of
// eight pairs, or one step of a close look. If a fast hand moves on before all windows that end at a point
// are compared, the rest of them is skipped. All memory is allocated by the constructor.
#pragma once
#include <memory>
#include <optional>

#include "gesture/close_look.h"

namespace thaum::gesture {

/// Settings of a Spotter.
struct SpotterSettings {
    /// Largest ratio between the arc lengths of a stroke and a template, the longer one divided by the other.
    double length_range = 3;
    /// Ratio between the arc lengths of a window (part of the motion that is compared) and the next shorter
    /// one.
    double window_ratio = 1.12;
    double longest = 8;  ///< longest duration of a stroke (s)
    /// Time after which a window (part of the motion) gets a close look (search for its exact ends) if no
    /// better one has come (s).
    double hold = 0.2;
    /// Time for which a candidate (part of the motion that may be a gesture) waits for a better one that
    /// overlaps it, before it is reported (s).
    double wait = 0.1;
    float max_score = 0.14F;  ///< largest score of a stroke that is reported; the smaller, the surer
    std::size_t windows_per_tick = 4;
};

/// A part of the motion that may be a gesture.
struct Candidate {
    std::uint32_t gesture = Recognition::none;
    std::uint32_t runner_up = Recognition::none;
    float distance{};
    float runner_up_distance{};
    float score{};  ///< score, as the top of this file describes it; the smaller, the surer
    /// Times of the first and the last point of this part of the motion (s)
    double start{}, end{};
    double mean_force{};

    bool operator==(const Candidate&) const = default;
};

/// A gesture that was found in continuous motion.
struct Spotted {
    Candidate what;
    double probability{};
    ForceClass force = ForceClass::normal;
    double told{};  ///< time at which the gesture was reported (s)
};

/// Chooses among candidates that overlap. Separate from Spotter, which finds them, so that tests can compare
/// thresholds of the score on the same candidates.
class CandidateChoice {
public:
    CandidateChoice(double wait, float max_score) : wait_(wait), max_score_(max_score) {}

    /// Considers a candidate that was found at time `now` (s). It waits for a better one. Returns the
    /// candidate that waited so far if the new one does not overlap it.
    std::optional<Candidate> add(const Candidate& candidate, double now);
    /// Returns the waiting candidate if no better one has come in time; called at time `now` (s).
    std::optional<Candidate> at(double now);
    double due() const { return due_; }  ///< time at which the waiting candidate is reported (s)

private:
    std::optional<Candidate> report();

    double wait_;
    float max_score_;
    std::optional<Candidate> waiting_;
    double due_ = 0;
    double start_ = -1e300, end_ = -1e300;  ///< times of the last reported gesture (s)
};

/// Looks for gestures in continuous motion.
class Spotter {
public:
    /// The recogniser must outlive the spotter.
    Spotter(const Recogniser& recogniser, const SpotterSettings& settings);

    /// Forgets all points and reports, as if the spotter were new. Allocates nothing.
    void restart();

    /// Takes the point of one tick. Points that are not finite, or whose time runs backwards, are ignored.
    /// Allocates nothing.
    std::optional<Spotted> feed(const StrokePoint& point);

    /// Takes a point like `feed`, but returns all candidates that were completed in this tick, without a
    /// choice among them.
    std::span<const Candidate> scan(const StrokePoint& point);

    /// Number of points so far at which windows (parts of the motion to compare) should end, skipped ones
    /// included.
    std::uint64_t ends() const { return ends_; }
    /// Number of those points at which not all windows were compared, because the hand moved on too fast.
    std::uint64_t skipped_ends() const { return skipped_; }

private:
    struct Pair {
        RecogniserSpace::Survivor match{};
        std::uint32_t window{};
        float score{};
    };
    struct Window {
        Shape shape;
        std::size_t first{};  ///< index of the first point of this part of the motion
        double start{}, end{};
    };
    /// The best window (part of the motion) of a gesture, waiting for a close look, the search for its exact
    /// ends.
    struct Held {
        bool waiting = false;
        Candidate what;
        /// Numbers of the window's first and last point, counted from the spotter's start. Points that have
        /// been dropped since are counted too.
        std::uint64_t first{}, last{};
        RecogniserSpace::Survivor match{};
        double due{};  ///< time at which the close look (search for the exact ends) may begin (s)
    };
    static constexpr std::size_t max_lengths = 48, max_pairs = 16;

    void append(const StrokePoint& point);
    void make_room();
    void start_scan();
    void look_at_length();
    void look_at_window(std::size_t first, bool depth);
    void sort_by_channels();
    /// Number of windows (parts of the motion) for each length: two if some gestures count depth and others
    /// do not.
    std::size_t kinds() const { return recogniser_.needs_solid() && recogniser_.needs_flat() ? 2 : 1; }
    void keep(const Pair& pair);
    void verify();
    void collect();
    void hold(const Candidate& candidate, std::size_t first, const RecogniserSpace::Survivor& match);
    bool begin_look();
    bool look_closer();
    void end_look();
    double quiet_factor(std::size_t first, std::size_t last) const;

    const Recogniser& recogniser_;
    /// For each gesture, a factor of its scores. It makes the scores of all gestures comparable, although
    /// strokes of some scatter more than those of others.
    std::vector<float> factors_;
    SpotterSettings settings_;
    CandidateChoice choice_;
    std::unique_ptr<RecogniserSpace> space_;
    ShapeSpace points_;
    StrokePoint origin_{};  ///< place and time to which the points are relative
    vec3 latest_{};         ///< place of the last point that was appended
    double now_ = -1e300;   ///< time of the last tick (s)
    float spacing_, end_step_;
    /// Arc length up to the point at which windows (parts of the motion that are compared) ended last.
    float last_end_ = 0;
    std::vector<Window> windows_;
    std::size_t window_count_ = 0, verified_ = 0;
    float next_length_ = 0;  ///< arc length of the window (part of the motion) that is compared next
    /// Index of the point at which all windows (parts of the motion) end that are compared in this scan.
    std::size_t end_ = 0;
    bool scanning_ = false, verifying_ = false;
    std::array<Pair, max_pairs> pairs_{};
    std::size_t pair_count_ = 0;
    struct Best {
        float distance{};
        std::uint32_t window{};
        bool found = false;
        RecogniserSpace::Survivor match{};
    };
    std::array<Best, max_gestures> best_{};
    /// For each gesture, its best window (part of the motion), which waits for the search for its exact ends.
    std::vector<Held> held_;
    std::vector<Candidate>
        seen_;  ///< for each gesture, the window that last had a close look, as it was before that look
    CloseLook look_;
    Held looked_at_{};
    std::uint64_t dropped_ = 0;  ///< number of old points that were dropped to make room for new ones
    std::uint32_t ticks_ = 0;
    std::vector<Candidate> candidates_;
    std::uint64_t ends_ = 0, skipped_ = 0;
};

}  // namespace thaum::gesture
