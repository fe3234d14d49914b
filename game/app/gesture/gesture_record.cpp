// thaum gesture record: writes a gesture file from strokes drawn now, from a recorded match, or from a file
// of strokes.
#include <algorithm>
#include <cstdio>

#include "core/file.h"
#include "core/text.h"
#include "game/app/command.h"
#include "game/app/gesture/gesture.h"
#include "game/app/gesture/stroke_window.h"
#include "game/command_line/arguments.h"
#include "game/components/hand_state.h"
#include "game/match/playback.h"
#include "gesture/gesture_file.h"
#include "gesture/recogniser.h"
#include "gesture/stroke_files.h"
#include "gesture/stroke_recorder.h"

namespace thaum::game::inline app {

const std::string_view gesture_record_help =
    R"(usage: thaum gesture record NAME [--device D|--log LOG|--strokes FILE] --out FILE.toml [OPTIONS]

Writes strokes as the file of a gesture, which the recogniser uses as templates. Without --log and
--strokes a window opens: hold a button of the mouse, or of the arm's stylus, and draw.

  --device D      mouse (default), or an arm by its name or number, such as touch or arm:0
  --log LOG       a recorded match: a stroke is the way of the hand while Trace is held, in metres
                  and newtons; the newest strokes are taken
  --player N      player of the match whose strokes these are (default 1)
  --strokes FILE  a file of strokes (CSV, gzipped or not): strokes of the gesture NAME are taken
  --count N       number of strokes (default 3)
  --closed        the stroke is a closed curve that may start anywhere
  --any-direction the stroke may be drawn backwards
  --planar        z does not count
  --rotation D    largest turn against the templates (degrees, default 0)
  --out FILE      file of the gesture
)";

namespace {

using Courses = std::vector<std::vector<gesture::StrokePoint>>;

/// Index of a player's device in the log; std::nullopt if the player has none.
std::optional<std::size_t> device_of(const input::LogReader& log, std::uint32_t player) {
    const auto& devices = log.header().devices;
    for (std::size_t d = 0; d < devices.size(); ++d) {
        if (devices[d].player == player) return d;
    }
    return std::nullopt;
}

Expected<Courses> strokes_of_log(const std::string& path, std::uint32_t player) {
    auto playback = Playback::open(path, find_assets());
    if (!playback) return playback.error();
    const auto device = device_of(playback->log(), player);
    if (!device) return fail(text(path, ": player ", player + 1, " has no device in this match"));
    gesture::StrokeRecorder recorder;
    while (playback->step()) {
        const auto& world = playback->match().world();
        const auto& hand = world.get<HandState>(wizard_of(world, player));
        const double t = static_cast<double>(playback->match().now()) / 1000;
        recorder.feed({t, hand.device.position, glm::length(hand.servo.safety.output)},
                      playback->frame().devices[*device].down(input::Button::trace));
    }
    recorder.end();
    if (recorder.strokes().empty())
        return fail(text(path, ": player ", player + 1, " never holds Trace in this match"));
    return recorder.strokes();
}

/// The newest strokes of a gesture in a file, at most `count`.
Expected<Courses> strokes_of_file(const std::string& path, const std::string& name, std::size_t count) {
    const auto set = gesture::load_strokes(path);
    if (!set) return set.error();
    Courses courses;
    for (auto stroke = set->strokes.rbegin(); stroke != set->strokes.rend(); ++stroke) {
        if (stroke->gesture != name || courses.size() == count) continue;
        if (const auto fault = gesture::fault_of_stroke(stroke->points); !fault.empty())
            return fail(text(path, ":", stroke->line, ": ", fault));
        courses.push_back(stroke->points);
    }
    if (courses.empty()) return fail(text(path, ": no stroke of the gesture '", name, "'"));
    std::reverse(courses.begin(), courses.end());
    return courses;
}

Expected<gesture::Gesture> read_gesture_words(const Arguments& arguments) {
    const auto log = arguments.value("--log"), file = arguments.value("--strokes");
    const bool twice = log.has_value() + file.has_value() + arguments.has("--device") > 1;
    if (arguments.plain().size() != 1 || twice || !arguments.value("--out"))
        return fail(
            "name the gesture, at most one of --device, --log and --strokes, and --out; see `thaum gesture "
            "record "
            "--help`");
    const auto player = arguments.whole("--player", 1, players, 1),
               count = arguments.whole("--count", 1, 100, 3);
    const auto turn = arguments.number("--rotation", 0, 180, 0);
    if (!player) return player.error();
    if (!count) return count.error();
    if (!turn) return turn.error();
    gesture::Gesture gesture{.name = arguments.plain()[0], .options = {}, .strokes = {}};
    gesture.options.closed = arguments.has("--closed");
    gesture.options.direction_sensitive = !arguments.has("--any-direction");
    gesture.options.planar = arguments.has("--planar");
    gesture.options.rotation = *turn * radians_per_degree;
    const auto courses = log    ? strokes_of_log(*log, static_cast<std::uint32_t>(*player - 1))
                         : file ? strokes_of_file(*file, gesture.name, *count)
                                : draw_strokes({.name = gesture.name,
                                                .count = *count,
                                                .device = arguments.value("--device").value_or("mouse")});
    if (!courses) return courses.error();
    const std::size_t first = courses->size() > *count ? courses->size() - *count : 0;
    gesture.strokes.assign(courses->begin() + static_cast<std::ptrdiff_t>(first), courses->end());
    return gesture;
}

/// Text of the gesture file. First checks the gesture as `thaum gesture check` and a match do when they read
/// the file.
Expected<std::string> text_of(const gesture::Gesture& gesture, const std::string& path) {
    for (const auto& stroke : gesture.strokes) {
        if (stroke.size() > gesture::max_template_points)
            return fail(text("a stroke of ", stroke.size(), " points, more than ",
                             gesture::max_template_points, ": draw a shorter one, or thin it"));
    }
    auto words = gesture::to_file(gesture);
    if (words.size() > gesture::max_gesture_bytes)
        return fail(text("the file would have ", words.size() >> 20U, " MiB, more than ",
                         gesture::max_gesture_bytes >> 20U, ": take fewer strokes with --count"));
    const auto config = Config::parse(words, path, gesture::gesture_file_version);
    if (!config) return config.error();
    const auto read = gesture::read_gesture(*config);
    if (!read) return read.error();
    const auto made = gesture::Recogniser::make(std::span(&*read, 1), {.calibrate = false});
    if (!made) return made.error();
    return words;
}

}  // namespace

int run_gesture_record(const std::vector<std::string>& words) {
    static constexpr Option options[] = {
        {"--log", 1},    {"--player", 1}, {"--strokes", 1},    {"--device", 1}, {"--count", 1},
        output("--out"), {"--closed"},    {"--any-direction"}, {"--planar"},    {"--rotation", 1}};
    const auto arguments = Arguments::parse(words, options);
    if (!arguments) return refuse(arguments.error());
    if (const auto out = arguments->value("--out")) {
        if (const auto free = check_output(*out); !free) return refuse(free.error());
    }
    const auto gesture = read_gesture_words(*arguments);
    if (!gesture) return refuse(gesture.error());
    const auto out = *arguments->value("--out");
    const auto file = text_of(*gesture, out);
    if (!file) return refuse(file.error());
    if (const auto written = write_text_file(out, *file); !written) return refuse(written.error());
    const auto count = gesture->strokes.size();
    std::printf("%zu %s of '%s'\n", count, count == 1 ? "stroke" : "strokes", gesture->name.c_str());
    return done;
}

}  // namespace thaum::game::inline app
