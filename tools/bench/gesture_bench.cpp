// Benchmarks gestures: time and error of the isolated recognition of each method over the number of
// templates, and the time of a tick of the spotter, which finds gestures in continuous motion.
//
// The gestures are generated: 100 smooth random curves, tested with variations of them. So the errors compare
// methods with one another; how well people's strokes are recognised is measured with `thaum gesture eval` on
// public data.
#include <memory>

#include "core/hash.h"
#include "core/text.h"
#include "gesture/recogniser.h"
#include "gesture/spotter.h"
#include "gesture/trials/methods.h"
#include "gesture/variations.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

constexpr std::size_t max_gestures = 100;
constexpr std::size_t stroke_points = 200;
constexpr std::size_t recognitions_in_a_call = 64;
/// Number of strokes that are timed. They fit into the cache, as does a stroke that has just been drawn.
constexpr std::size_t timed_strokes = 64;
constexpr std::uint64_t gesture_seed = 2026;

/// A random curve with slow turns and a varying force.
std::vector<gesture::StrokePoint> random_course(Random& random) {
    std::array<double, 4> turn{}, phase{};
    for (auto& t : turn) t = random.uniform(-3, 3);
    for (auto& p : phase) p = random.uniform(0, 2 * pi);
    std::vector<gesture::StrokePoint> points;
    vec3 at(0);
    for (std::size_t i = 0; i < stroke_points; ++i) {
        const double u = static_cast<double>(i) / stroke_points;
        double angle = phase[0], force = 2;
        for (std::size_t k = 0; k < turn.size(); ++k) {
            angle += turn[k] * det::sin(pi * static_cast<double>(k + 1) * u + phase[k]);
            force += 0.2 * turn[k] * det::sin(2 * pi * static_cast<double>(k + 1) * u);
        }
        points.push_back({2 * u, at, force});
        at += vec3(det::cos(angle), det::sin(angle), 0) / static_cast<double>(stroke_points);
    }
    return points;
}

std::vector<gesture::Gesture> generated_gestures(std::size_t count) {
    std::vector<gesture::Gesture> gestures;
    for (std::size_t g = 0; g < count; ++g) {
        Random random = random_stream(gesture_seed, g);
        gestures.push_back({text("g", g), {}, {random_course(random)}});
    }
    return gestures;
}

struct TestedStroke {
    std::uint32_t gesture{};
    std::vector<gesture::StrokePoint> points;
};

std::vector<TestedStroke> strokes_for(std::span<const gesture::Gesture> gestures, std::size_t count) {
    Random random = random_stream(gesture_seed, 0x7e57);
    const gesture::VariationSettings users{
        .tilt = 0.2, .stretch = 0.2, .bend = 0.07, .hurry = 0.4, .ends = 0.05};
    std::vector<TestedStroke> strokes;
    for (std::size_t i = 0; i < count; ++i) {
        const auto g = static_cast<std::uint32_t>(i % gestures.size());
        strokes.push_back({g, gesture::variation_of(gestures[g].strokes[0], random, users)});
    }
    return strokes;
}

/// A method of recognition with its templates, the example strokes with which a stroke is compared.
struct IsolatedRun {
    std::string method;
    std::size_t templates{};
    std::unique_ptr<gesture::Classifier> classifier;
    std::vector<TestedStroke> strokes;
    std::size_t next{};
    std::uint64_t allocations{};

    void run() {
        const auto before = allocation_count();
        for (std::size_t i = 0; i < recognitions_in_a_call; ++i) {
            const auto answer = classifier->classify(strokes[(next + i) % timed_strokes].points);
            do_not_optimise(answer);
        }
        allocations = allocation_count() - before;
        next += recognitions_in_a_call;
    }
};

Row row_of(IsolatedRun& run, std::vector<double> us) {
    for (double& one : us) one /= recognitions_in_a_call;
    std::size_t wrong = 0;
    std::uint64_t hash = 0;
    for (const auto& stroke : run.strokes) {
        const auto answer = run.classifier->classify(stroke.points);
        wrong += answer.gesture != stroke.gesture;
        hash = hash_combine(hash, hash_combine(answer.gesture, hash_value(answer.evidence.distance)));
    }
    const double error = static_cast<double>(wrong) / static_cast<double>(run.strokes.size());
    return {.area = "gesture",
            .name = run.method,
            .setting = {{"templates", static_cast<std::int64_t>(run.templates)}},
            .time_us = times(us),
            .error = ErrorMeasure{"error", error},
            .is_default = run.method == "default",
            .metrics = {{"allocations", static_cast<double>(run.allocations)}},
            .hash = hex(hash)};
}

void isolated_gestures(const Options& options, Report& report) {
    std::vector<IsolatedRun> runs;
    for (const std::size_t templates : {std::size_t{4}, std::size_t{16}, std::size_t{48}, max_gestures}) {
        const auto gestures = generated_gestures(templates);
        for (const std::string name : {"dot", "tdnn", "directions", "elastic", "default"}) {
            auto classifier =
                gesture::make_classifier(*gesture::method_of(name), gestures, {{false, true}, gesture_seed});
            if (!classifier) return report.faults.push_back(classifier.error().message);
            runs.push_back(
                {name, templates, std::move(*classifier), strokes_for(gestures, options.quick ? 400 : 2000)});
        }
    }
    std::vector<Contestant> contestants;
    for (auto& run : runs) contestants.push_back({{}, [&run] { run.run(); }});
    const auto samples = measure(contestants, {.seconds = options.quick ? 3.0 : 15.0, .least = 21});
    for (std::size_t i = 0; i < runs.size(); ++i) report.rows.push_back(row_of(runs[i], samples[i]));
}

/// Points of a hand's motion, one for each millisecond. The hand draws gestures, and moves aimlessly from the
/// end of one to the start of the next.
std::vector<gesture::StrokePoint> gesture_motion(std::span<const gesture::Gesture> gestures,
                                                 std::size_t ticks) {
    constexpr double tick = 1e-3;
    Random random = random_stream(gesture_seed, 0x57e);
    std::vector<gesture::StrokePoint> points;
    vec3 at(0);
    while (points.size() < ticks) {
        const auto& g = gestures[random.below(gestures.size())];
        const auto stroke = gesture::variation_of(g.strokes[0], random);
        const vec3 from = at - stroke[0].at;
        for (std::size_t i = 1; i < stroke.size(); ++i) {
            const auto &a = stroke[i - 1], &b = stroke[i];
            for (double t = a.t; t < b.t; t += tick)
                points.push_back({0, from + a.at + (b.at - a.at) * ((t - a.t) / (b.t - a.t)), a.force});
        }
        const vec3 start = points.back().at, end{random.uniform(-1, 1), random.uniform(-1, 1), 0};
        const auto way = 300 + random.below(1500);
        for (std::uint64_t i = 0; i < way; ++i)
            points.push_back(
                {0, start + (end - start) * (static_cast<double>(i) / static_cast<double>(way)), 1});
        at = end;
    }
    for (std::size_t i = 0; i < points.size(); ++i) points[i].t = tick * static_cast<double>(i);
    points.resize(ticks);
    return points;
}

void gesture_stream(const Options& options, Report& report) {
    const auto gestures = generated_gestures(30);
    const auto recogniser =
        gesture::Recogniser::make(gestures, {.channels = {false, true}, .seed = gesture_seed});
    if (!recogniser) return report.faults.push_back(recogniser.error().message);
    const auto spotter = std::make_unique<gesture::Spotter>(*recogniser, gesture::SpotterSettings{});
    const auto points = gesture_motion(gestures, options.quick ? 60'000 : 600'000);
    std::vector<double> us;
    us.reserve(points.size());
    std::uint64_t hash = 0, found = 0;
    const auto before = allocation_count();
    for (const auto& p : points) {
        const double begin = now_us();
        const auto spotted = spotter->feed(p);
        us.push_back(now_us() - begin);
        if (!spotted) continue;
        ++found;
        hash = hash_combine(hash, hash_combine(spotted->what.gesture, hash_value(spotted->what.distance)));
    }
    const auto allocations = allocation_count() - before;
    const double median = percentile(us, 0.5), p999 = percentile(us, 0.999);
    report.rows.push_back({.area = "gesture",
                           .name = "stream",
                           .setting = {{"templates", std::int64_t{30}}},
                           .time_us = times(us),
                           .is_default = true,
                           .metrics = {{"median_us", median},
                                       {"p999_us", p999},
                                       {"allocations", static_cast<double>(allocations)},
                                       {"found", static_cast<double>(found)},
                                       {"skipped_ends", static_cast<double>(spotter->skipped_ends())}},
                           .hash = hex(hash)});
}

}  // namespace

void gestures(const Options& options, Report& report) {
    isolated_gestures(options, report);
    gesture_stream(options, report);
}

}  // namespace thaum::bench
