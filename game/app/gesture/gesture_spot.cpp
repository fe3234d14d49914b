// thaum gesture spot: measures how well gestures are found in continuous motion, without a button.
#include <cstdio>
#include <set>

#include "core/file.h"
#include "core/json.h"
#include "core/near_name.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/gesture/gesture.h"
#include "game/command_line/arguments.h"
#include "gesture/stroke_files.h"
#include "gesture/trials/spotting.h"

namespace thaum::game::inline app {

const std::string_view gesture_spot_help =
    R"(usage: thaum gesture spot SESSIONS --labels LABELS --train STROKES [OPTIONS]

Finds gestures in continuous motion and compares them with the labels: precision, recall, F1,
false reports an hour (with an interval of 95 %) and delay. Templates come from other users than
the session's, and thresholds are chosen on the sessions of the other users.

  --labels FILE   user,gesture,t_start,t_end
  --ignore FILE   strokes without a label that count neither way, in the same columns
  --train FILE    strokes from which the templates are taken
  --templates K   strokes of each gesture that serve as templates (default 1)
  --repeats N     rounds with other random templates (default 3)
  --channels C    xy, xyz, xyf or xyzf; f is the force. Default: all that both files have
  --wait S        time for which a report waits for a better one (default 0.1 s)
  --seed S        seed of the random choices (default 1)
  --json FILE     also writes the figures as JSON; - for standard output alone

A report is right if it names the gesture of a label and overlaps the label by half of the
shorter of both. A gesture in the sessions that has no label counts as false.
)";

namespace {

struct SpotPlan {
    std::filesystem::path sessions, labels, strokes;
    std::string channels;
    std::optional<std::string> ignored, json;
    gesture::SpottingSettings settings;
};

Expected<SpotPlan> read_spot_plan(const std::vector<std::string>& words) {
    static constexpr Option options[] = {{"--labels", 1},  {"--train", 1},    {"--templates", 1},
                                         {"--repeats", 1}, {"--channels", 1}, {"--wait", 1},
                                         {"--seed", 1},    output("--json"),  {"--ignore", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return arguments.error();
    const auto labels = arguments->value("--labels"), train = arguments->value("--train");
    if (arguments->plain().size() != 1 || !labels || !train)
        return fail(
            "name one file of sessions, --labels FILE and --train FILE; see `thaum gesture spot --help`");
    SpotPlan plan;
    plan.sessions = arguments->plain()[0];
    plan.labels = *labels;
    plan.strokes = *train;
    plan.channels = arguments->value("--channels").value_or("");
    plan.ignored = arguments->value("--ignore");
    plan.json = arguments->value("--json");
    const auto templates = arguments->whole("--templates", 1, 100, 1),
               repeats = arguments->whole("--repeats", 1, 1000, 3),
               seed = arguments->whole("--seed", 0, ~std::uint64_t{0}, 1);
    const auto wait = arguments->number("--wait", 0, 10, plan.settings.spotter.wait);
    for (const auto* whole : {&templates, &repeats, &seed}) {
        if (!*whole) return whole->error();
    }
    if (!wait) return wait.error();
    plan.settings.templates = *templates;
    plan.settings.repeats = *repeats;
    plan.settings.seed = *seed;
    plan.settings.spotter.wait = *wait;
    return plan;
}

void print_score(const char* name, const gesture::SpottingScore& s) {
    std::printf("%-22s %6s %9s %6s %8s  (%s to %s) %7s s\n", name, fixed(s.f1, 3).c_str(),
                fixed(s.precision, 3).c_str(), fixed(s.recall, 3).c_str(), fixed(s.false_per_hour, 1).c_str(),
                fixed(s.low_per_hour, 1).c_str(), fixed(s.high_per_hour, 1).c_str(),
                fixed(s.delay, 2).c_str());
}

Json json_of(const gesture::SpottingScore& s) {
    return {{"f1", s.f1},
            {"precision", s.precision},
            {"recall", s.recall},
            {"right", s.right},
            {"wrong", s.wrong},
            {"missed", s.missed},
            {"false_per_hour", s.false_per_hour},
            {"false_per_hour_low", s.low_per_hour},
            {"false_per_hour_high", s.high_per_hour},
            {"delay_s", s.delay},
            {"threshold", s.threshold}};
}

std::string json_of(const SpotPlan& plan, const gesture::Spotting& r) {
    const Json json{{"sessions", r.sessions},
                    {"labels", r.labels},
                    {"hours", r.hours},
                    {"templates", plan.settings.templates},
                    {"repeats", plan.settings.repeats},
                    {"best_f1", json_of(r.best)},
                    {"at_six_per_hour", json_of(r.at_six)},
                    {"at_two_per_hour", json_of(r.at_two)},
                    {"skipped_ends", r.skipped}};
    return dump(json, 1) + "\n";
}

void print_spotting(const SpotPlan& plan, const gesture::Spotting& r) {
    std::printf("%zu sessions, %s hours, %zu labels; %zu templates a gesture, %zu repeats\n\n", r.sessions,
                fixed(r.hours, 2).c_str(), r.labels, plan.settings.templates, plan.settings.repeats);
    std::printf("%-22s %6s %9s %6s %8s  %-14s %7s\n", "threshold chosen for", "F1", "precision", "recall",
                "false/h", "95 % interval", "delay");
    print_score("best F1", r.best);
    print_score("at most 6 false/h", r.at_six);
    print_score("at most 2 false/h", r.at_two);
    std::printf("\n%s %% of the ends of windows were skipped to limit the work of a tick\n",
                fixed(100 * r.skipped, 1).c_str());
}

/// Reports labels that have no effect. A label says which gesture a user drew within a recorded session, and
/// when. It has no effect if no session belongs to its user, or no stroke has its gesture.
void tell_unused_labels(const std::vector<gesture::SessionLabel>& labels, const gesture::SessionSet& sessions,
                        const std::vector<gesture::Stroke>& strokes) {
    std::set<std::string_view> users, gestures;
    for (const auto& session : sessions.sessions) users.insert(session.user);
    for (const auto& stroke : strokes) gestures.insert(stroke.gesture);
    std::size_t unused = 0;
    std::string first;
    for (const auto& label : labels) {
        const bool has_user = users.contains(label.user), has_gesture = gestures.contains(label.gesture);
        if (has_user && has_gesture) continue;
        ++unused;
        if (!first.empty()) continue;
        first = has_user
                    ? text("no stroke has the gesture '", label.gesture, "'",
                           did_you_mean(label.gesture, gestures))
                    : text("no session has the user '", label.user, "'", did_you_mean(label.user, users));
    }
    if (unused > 0) tell_user(text(unused, " of ", labels.size(), " labels are left out: ", first));
}

Expected<gesture::Spotting> measure_spotting(SpotPlan& plan) {
    const auto sessions = gesture::load_sessions(plan.sessions);
    if (!sessions) return sessions.error();
    const auto labels = gesture::load_labels(plan.labels);
    if (!labels) return labels.error();
    if (plan.ignored) {
        auto ignored = gesture::load_labels(*plan.ignored);
        if (!ignored) return ignored.error();
        plan.settings.ignored = std::move(*ignored);
    }
    const auto strokes = gesture::load_strokes(plan.strokes);
    if (!strokes) return strokes.error();
    tell_unused_labels(*labels, *sessions, strokes->strokes);
    const auto channels = choose_channels(plan.channels, sessions->has_depth && strokes->has_depth,
                                          sessions->has_force && strokes->has_force);
    if (!channels) return channels.error();
    plan.settings.channels = *channels;
    return gesture::evaluate_spotting(*sessions, *labels, strokes->strokes, plan.settings);
}

}  // namespace

int run_gesture_spot(const std::vector<std::string>& words) {
    auto plan = read_spot_plan(words);
    if (!plan) return refuse(plan.error());
    const bool only_json = plan->json == "-";
    if (plan->json && !only_json) {
        if (const auto free = check_output(*plan->json); !free) return refuse(free.error());
    }
    const auto result = measure_spotting(*plan);
    if (!result) return refuse(result.error());
    if (only_json) {
        std::printf("%s", json_of(*plan, *result).c_str());
        return done;
    }
    print_spotting(*plan, *result);
    if (plan->json) {
        if (const auto written = write_text_file(*plan->json, json_of(*plan, *result)); !written)
            return refuse(written.error());
    }
    return done;
}

}  // namespace thaum::game::inline app
