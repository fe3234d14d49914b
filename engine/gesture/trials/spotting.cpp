#include "gesture/trials/spotting.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "core/units.h"
#include "gesture/trials/evaluation.h"

namespace thaum::gesture {
namespace {

constexpr double min_overlap = 0.5;
constexpr float tightest = 0.02F, loosest = 0.4F, threshold_step = 0.0025F;
constexpr auto thresholds = static_cast<std::size_t>((loosest - tightest) / threshold_step + 1.5F);

float threshold_at(std::size_t number) { return tightest + threshold_step * static_cast<float>(number); }

struct Found {
    Candidate candidate;
    double at{};  ///< time at which the candidate was found (s)
};

/// Numbers of right, false and missed reports in one session, if candidates (parts of the motion that may be
/// gestures) up to one threshold of the score are reported.
struct Count {
    std::size_t right{}, wrong{}, missed{};
    std::vector<double> delays;  ///< times from the end of a gesture to its report (s)

    void add(const Count& other) {
        right += other.right;
        wrong += other.wrong;
        missed += other.missed;
        delays.insert(delays.end(), other.delays.begin(), other.delays.end());
    }
    double f1() const {
        const double all = static_cast<double>(2 * right + wrong + missed);
        return all > 0 ? 2 * static_cast<double>(right) / all : 0;
    }
};

struct Label {
    std::uint32_t gesture{};
    double start{}, end{};
};

std::vector<Found> candidates_in(const Session& session, const Recogniser& recogniser,
                                 const SpotterSettings& settings, double& skipped) {
    const auto spotter = std::make_unique<Spotter>(recogniser, settings);
    std::vector<Found> found;
    for (std::size_t i = 0; i < session.points.size(); ++i) {
        auto p = session.points[i];
        const double until = i + 1 < session.points.size() ? session.points[i + 1].t : p.t + 1;
        const double most = std::min(until, p.t + 2);  // a hand that rests for 2 s needs no further ticks
        for (double t = p.t; t < most; t += tick_seconds) {
            p.t = t;
            for (const auto& c : spotter->scan(p)) {
                if (c.score <= loosest) found.push_back({c, t});
            }
        }
    }
    const auto ends = static_cast<double>(std::max<std::uint64_t>(spotter->ends(), 1));
    skipped += static_cast<double>(spotter->skipped_ends()) / ends;
    return found;
}

/// The labels of a session (gestures that must be reported), and the strokes that may be reported but need
/// not be.
struct Truth {
    std::vector<Label> labels, ignored;
};

void judge(const Candidate& c, double told, const Truth& truth, std::vector<char>& used, Count& count) {
    const auto& labels = truth.labels;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto& label = labels[i];
        if (used[i] != 0 || label.gesture != c.gesture) continue;
        const double both = std::min(label.end, c.end) - std::max(label.start, c.start);
        if (both < min_overlap * std::min(label.end - label.start, c.end - c.start)) continue;
        used[i] = 1;
        ++count.right;
        count.delays.push_back(told - label.end);
        return;
    }
    const bool is_ignored = std::any_of(truth.ignored.begin(), truth.ignored.end(), [&](const Label& l) {
        return l.gesture == c.gesture && std::min(l.end, c.end) > std::max(l.start, c.start);
    });
    count.wrong += !is_ignored;
}

Count count_at(float threshold, std::span<const Found> found, const Truth& truth, double wait) {
    CandidateChoice choice(wait, threshold);
    std::vector<char> used(truth.labels.size());
    Count count;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const double now = found[i].at;
        const double due = choice.due();
        if (const auto r = choice.at(now)) judge(*r, due, truth, used, count);
        if (const auto r = choice.add(found[i].candidate, now)) judge(*r, now, truth, used, count);
    }
    const double due = choice.due();
    if (const auto r = choice.at(1e300)) judge(*r, due, truth, used, count);
    count.missed = truth.labels.size() - count.right;
    return count;
}

/// Numbers of right, false and missed reports, for each session and each threshold of the score up to which
/// candidates are reported.
using Counts = std::vector<std::array<Count, thresholds>>;

Count sum_of_others(const Counts& counts, std::size_t without, std::size_t threshold) {
    Count sum;
    for (std::size_t s = 0; s < counts.size(); ++s) {
        if (s == without) continue;
        sum.right += counts[s][threshold].right;
        sum.wrong += counts[s][threshold].wrong;
        sum.missed += counts[s][threshold].missed;
    }
    return sum;
}

SpottingScore score_of(const Count& count, double hours) {
    SpottingScore s;
    s.right = count.right;
    s.wrong = count.wrong;
    s.missed = count.missed;
    const auto ratio = [](std::size_t a, std::size_t b) {
        return b > 0 ? static_cast<double>(a) / static_cast<double>(b) : 0;
    };
    s.precision = ratio(count.right, count.right + count.wrong);
    s.recall = ratio(count.right, count.right + count.missed);
    s.f1 = count.f1();
    // The square root of a Poisson-distributed count, after adding 3/8, has a standard deviation of 1/2
    // (Anscombe 1948). The 95 % interval is 1.96 times that, 0.98, to either side.
    const double n = static_cast<double>(count.wrong), root = std::sqrt(n + 0.375);
    s.false_per_hour = n / hours;
    s.low_per_hour = std::max(0.0, std::pow(std::max(0.0, root - 0.98), 2.0) - 0.375) / hours;
    s.high_per_hour = (std::pow(root + 0.98, 2.0) - 0.375) / hours;
    auto delays = count.delays;
    std::sort(delays.begin(), delays.end());
    s.delay = delays.empty() ? 0 : delays[delays.size() / 2];
    return s;
}

/// Result summed over all sessions. The threshold for each session is the one that is best on the other
/// users' sessions, so that no session is tested with a threshold fitted to it.
template <class Better>
SpottingScore cross_validated(const Counts& counts, double hours, Better value) {
    Count sum;
    double threshold = 0;
    for (std::size_t s = 0; s < counts.size(); ++s) {
        std::size_t best = 0;
        double most = -1e300;
        for (std::size_t t = 0; t < thresholds; ++t) {
            const double v = value(sum_of_others(counts, s, t), s);
            if (v > most) {
                most = v;
                best = t;
            }
        }
        sum.add(counts[s][best]);
        threshold += static_cast<double>(threshold_at(best)) / static_cast<double>(counts.size());
    }
    auto score = score_of(sum, hours);
    score.threshold = threshold;
    return score;
}

double hours_of(const Session& s) { return (s.points.back().t - s.points.front().t) / 3600; }

class SpottingRun {
public:
    SpottingRun(const SessionSet& sessions, std::span<const SessionLabel> labels,
                std::span<const Stroke> strokes, const SpottingSettings& settings)
        : sessions_(sessions), settings_(settings), strokes_(strokes), index_(index_of(strokes)) {
        for (const auto& session : sessions.sessions)
            truths_.push_back({labels_of(session, labels), labels_of(session, settings.ignored)});
    }

    Expected<Spotting> run() {
        std::size_t labels = 0;
        for (const auto& t : truths_) labels += t.labels.size();
        if (labels == 0) return fail("no label names a user of the sessions and a gesture of the strokes");
        Spotting result;
        result.sessions = sessions_.sessions.size();
        result.labels = labels;
        counts_.resize(sessions_.sessions.size());
        for (const auto& session : sessions_.sessions) result.hours += hours_of(session);
        for (std::size_t repeat = 0; repeat < settings_.repeats; ++repeat) {
            for (std::size_t s = 0; s < sessions_.sessions.size(); ++s) {
                if (auto done = run_session(s, repeat); !done) return done.error();
            }
        }
        const double hours = result.hours * static_cast<double>(settings_.repeats);
        result.best = cross_validated(counts_, hours, [](const Count& c, std::size_t) { return c.f1(); });
        const auto limited = [&](double most) {
            return cross_validated(counts_, hours, [&](const Count& c, std::size_t s) {
                const double others =
                    hours - hours_of(sessions_.sessions[s]) * static_cast<double>(settings_.repeats);
                const double rate = static_cast<double>(c.wrong) / others;
                return rate <= most ? static_cast<double>(c.right) : -rate;
            });
        };
        result.at_six = limited(6);
        result.at_two = limited(2);
        result.skipped = skipped_ / static_cast<double>(settings_.repeats * sessions_.sessions.size());
        return result;
    }

private:
    std::vector<Label> labels_of(const Session& session, std::span<const SessionLabel> labels) const {
        std::vector<Label> own;
        for (const auto& l : labels) {
            const auto g = std::find(index_.gestures.begin(), index_.gestures.end(), l.gesture);
            if (l.user != session.user || g == index_.gestures.end()) continue;
            own.push_back({static_cast<std::uint32_t>(g - index_.gestures.begin()), l.start, l.end});
        }
        return own;
    }

    Expected<void> run_session(std::size_t s, std::size_t repeat) {
        const auto& session = sessions_.sessions[s];
        const auto user =
            std::find(index_.users.begin(), index_.users.end(), session.user) - index_.users.begin();
        Random random = random_stream(settings_.seed, 0x100 * s + repeat);
        const auto templates = draw_templates(index_, Protocol::leave_user_out,
                                              static_cast<std::uint32_t>(user), settings_.templates, random);
        const bool missing =
            std::any_of(templates.begin(), templates.end(), [](const auto& t) { return t.empty(); });
        if (missing) return fail("a gesture has no stroke of another user than the session's");
        const auto gestures = gestures_of(strokes_, index_, templates);
        const auto recogniser = Recogniser::make(
            gestures, {.channels = settings_.channels, .seed = settings_.seed, .pace_counts = true});
        if (!recogniser) return recogniser.error();
        const auto found = candidates_in(session, *recogniser, settings_.spotter, skipped_);
        for (std::size_t t = 0; t < thresholds; ++t)
            counts_[s][t].add(count_at(threshold_at(t), found, truths_[s], settings_.spotter.wait));
        return {};
    }

    const SessionSet& sessions_;
    const SpottingSettings& settings_;
    std::span<const Stroke> strokes_;
    GestureIndex index_;
    std::vector<Truth> truths_;
    Counts counts_;
    double skipped_ = 0;
};

}  // namespace

Expected<Spotting> evaluate_spotting(const SessionSet& sessions, std::span<const SessionLabel> labels,
                                     std::span<const Stroke> strokes, const SpottingSettings& settings) {
    return SpottingRun(sessions, labels, strokes, settings).run();
}

}  // namespace thaum::gesture
