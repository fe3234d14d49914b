// thaum gesture eval: measures accuracy, confusion, time and calibration of a method of recognition on a file
// of strokes.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/gesture/gesture.h"
#include "game/app/gesture/gesture_report.h"
#include "game/command_line/arguments.h"
#include "gesture/prefix.h"
#include "gesture/stroke_files.h"

namespace thaum::game::inline app {

const std::string_view gesture_eval_help =
    R"(usage: thaum gesture eval STROKES [OPTIONS]

Measures how often a recogniser is right: accuracy, confusion matrix, time of a recognition, and
whether its probabilities hold.

  --method M      dot (paper 000), tdnn (paper 002), directions (network of paper 000), elastic
                  (every template compared), default (the recogniser of the game), early (the
                  likely gesture of an unfinished stroke, as a player sees it)
  --at S          shows only the first share S of the length of each tested stroke (0.05 to 1)
  --protocol P    user-dependent: templates of the tested user; leave-user-out: templates of the
                  other users (default); random: templates of anybody
  --templates K   strokes of each gesture that serve as templates (default 1)
  --repeats N     rounds with other random templates (default 10)
  --channels C    xy, xyz, xyf or xyzf; f is the force. Default: all that the file has
  --open-set S    share of the gestures that has no templates (0 to 0.9): correct accepts where
                  1 % of the strokes of unknown gestures are accepted
  --seed S        seed of the random choices (default 1)
  --json FILE     also writes the figures as JSON; - for standard output alone
  --svg FILE      also draws confusion matrix and reliability

Probabilities and thresholds are fitted to other users than those they are measured on; if the
file has one user, to the other half of the strokes.
)";

namespace {

using gesture::EvaluationSettings;

struct EvalPlan {
    std::filesystem::path file;
    EvaluationSettings settings;
    std::string method, protocol, channels;
    std::optional<std::string> json, svg;
};

Expected<void> read_counts(const Arguments& arguments, EvalPlan& plan) {
    const auto templates = arguments.whole("--templates", 1, 1000, 1),
               repeats = arguments.whole("--repeats", 1, 1000, 10),
               seed = arguments.whole("--seed", 0, ~std::uint64_t{0}, 1);
    const auto open = arguments.number("--open-set", 0, 0.9, 0), at = arguments.number("--at", 0.05, 1, 1);
    for (const auto* whole : {&templates, &repeats, &seed}) {
        if (!*whole) return whole->error();
    }
    if (!open) return open.error();
    if (!at) return at.error();
    plan.settings.at = *at;
    plan.settings.templates = *templates;
    plan.settings.repeats = *repeats;
    plan.settings.seed = *seed;
    plan.settings.unknown_share = *open;
    return {};
}

Expected<EvalPlan> read_eval_plan(const std::vector<std::string>& words) {
    static constexpr Option options[] = {
        {"--method", 1},   {"--protocol", 1}, {"--templates", 1}, {"--repeats", 1}, {"--channels", 1},
        {"--open-set", 1}, {"--seed", 1},     {"--at", 1},        output("--json"), output("--svg")};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return arguments.error();
    if (arguments->plain().size() != 1)
        return fail("name one file of strokes; see `thaum gesture eval --help`");
    EvalPlan plan;
    plan.file = arguments->plain()[0];
    plan.method = arguments->value("--method").value_or("default");
    plan.protocol = arguments->value("--protocol").value_or("leave-user-out");
    plan.channels = arguments->value("--channels").value_or("");
    plan.json = arguments->value("--json");
    plan.svg = arguments->value("--svg");
    const auto method = gesture::method_of(plan.method);
    if (!method)
        return fail(
            text("--method '", plan.method, "': must be dot, tdnn, directions, elastic, default or early"));
    const auto protocol = gesture::protocol_of(plan.protocol);
    if (!protocol)
        return fail(
            text("--protocol '", plan.protocol, "': must be user-dependent, leave-user-out or random"));
    plan.settings.method = *method;
    plan.settings.protocol = *protocol;
    if (auto counts = read_counts(*arguments, plan); !counts) return counts.error();
    return plan;
}

}  // namespace

Expected<gesture::Channels> choose_channels(const std::string& word, bool has_depth, bool has_force) {
    if (word.empty()) return gesture::Channels{has_depth, has_force};
    const bool depth = word.find('z') != std::string::npos, force = word.ends_with('f');
    if (word != text("xy", depth ? "z" : "", force ? "f" : ""))
        return fail(text("--channels '", word, "': must be xy, xyz, xyf or xyzf"));
    if (force && !has_force) return fail(text("--channels ", word, ": the file has no force; leave out f"));
    if (depth && !has_depth) return fail(text("--channels ", word, ": the file has no z; leave out z"));
    return gesture::Channels{depth, force};
}

std::string name_of(gesture::Channels channels) {
    return text("xy", channels.depth ? "z" : "", channels.force ? "f" : "");
}

namespace {

/// Times of a recognition with the templates of the first round of cross-validation (us), sorted.
Expected<std::vector<double>> measure_times(const gesture::StrokeSet& set,
                                            const EvaluationSettings& settings) {
    const auto index = gesture::index_of(set.strokes);
    Random random = random_stream(settings.seed, 0);
    const auto templates = gesture::draw_templates(index, settings.protocol, 0, settings.templates, random);
    const auto gestures = gesture::gestures_of(set.strokes, index, templates);
    const auto classifier =
        gesture::make_classifier(settings.method, gestures, {settings.channels, settings.seed, false});
    if (!classifier) return classifier.error();
    // Each timed call gets another stroke, as in a match. All of these strokes fit in the processor's cache,
    // where a stroke that was just drawn would be, too.
    constexpr std::size_t timed_strokes = 64, calls = 8;
    constexpr int passes = 40;
    const std::size_t stride = set.strokes.size() / timed_strokes + 1;
    std::vector<gesture::Points> shown;
    for (const auto& stroke : set.strokes) shown.push_back(gesture::beginning_of(stroke.points, settings.at));
    std::vector<double> us;
    std::uint64_t sum = 0;
    for (int pass = 0; pass < passes; ++pass) {
        for (std::size_t s = 0; s + calls * stride <= set.strokes.size(); s += calls * stride) {
            const auto begin = std::chrono::steady_clock::now();
            for (std::size_t call = 0; call < calls; ++call)
                sum += (*classifier)->classify(shown[s + call * stride]).gesture;
            const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - begin;
            us.push_back(time.count() / calls);
        }
        if (us.empty()) return std::vector<double>{0};  // there were too few strokes to measure
    }
    if (sum == 1) us.push_back(us.back());  // uses the answers, so that the compiler cannot remove the calls
    std::sort(us.begin(), us.end());
    return us;
}

Expected<GestureReport> measure_method(EvalPlan& plan, const gesture::StrokeSet& set) {
    GestureReport report;
    report.file = plan.file.filename().string();
    report.method = plan.method;
    report.protocol = plan.protocol;
    report.channels = name_of(plan.settings.channels);
    report.templates = plan.settings.templates;
    report.repeats = plan.settings.repeats;
    report.strokes = set.strokes.size();
    report.users = gesture::index_of(set.strokes).users.size();
    auto evaluation = gesture::evaluate(set.strokes, plan.settings);
    if (!evaluation) return fail(text(plan.file.string(), ": ", evaluation.error().message));
    report.evaluation = std::move(*evaluation);
    report.at = plan.settings.at;
    const bool is_early = plan.settings.method == gesture::Method::early;
    if (is_early || plan.settings.method == gesture::Method::standard) {
        auto own = plan.settings;
        own.own_calibration = true;
        // This evaluation spends most of its time on making synthetic strokes; therefore it has few repeats.
        own.repeats = std::min<std::size_t>(own.repeats, 3);
        const auto second = gesture::evaluate(set.strokes, own);
        report.has_own_calibration = second.has_value();
        if (second) report.own_calibration_error = second->calibration_error;
        if (second && is_early) report.certainty = certainty_of(*second, gesture::likely_enough);
    }
    const auto us = measure_times(set, plan.settings);
    if (!us) return us.error();
    report.median_us = (*us)[us->size() / 2];
    report.p99_us = (*us)[us->size() * 99 / 100];
    return report;
}

}  // namespace

int run_gesture_eval(const std::vector<std::string>& words) {
    auto plan = read_eval_plan(words);
    if (!plan) return refuse(plan.error());
    for (const auto& out : {plan->json, plan->svg}) {
        if (!out || *out == "-") continue;
        if (const auto free = check_output(*out); !free) return refuse(free.error());
    }
    const auto set = gesture::load_strokes(plan->file);
    if (!set) return refuse(set.error());
    const auto channels = choose_channels(plan->channels, set->has_depth, set->has_force);
    if (!channels) return refuse(channels.error());
    plan->settings.channels = *channels;
    const auto report = measure_method(*plan, *set);
    if (!report) return refuse(report.error());
    const bool only_json = plan->json == "-";
    std::printf("%s", only_json ? report_json(*report).c_str() : report_text(*report).c_str());
    if (plan->json && !only_json) {
        if (const auto written = write_text_file(*plan->json, report_json(*report)); !written)
            return refuse(written.error());
    }
    if (plan->svg) {
        if (const auto written = write_text_file(*plan->svg, report_svg(*report)); !written)
            return refuse(written.error());
    }
    return done;
}

}  // namespace thaum::game::inline app
