// thaum lab VOLUME: explores a volume by touch.
#include "game/lab/window/volume_lab.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/clock.h"
#include "core/config.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/one_line.h"
#include "core/tell_user.h"
#include "core/text.h"
#include "field/volume_file.h"
#include "game/command_line/arguments.h"
#include "game/command_line/command.h"
#include "game/data/match_data.h"
#include "game/lab/saved_body.h"
#include "game/lab/volume_trace.h"
#include "game/lab/window/volume_lab_files.h"
#include "game/live/end_watch.h"
#include "render/display.h"

namespace thaum::game::inline lab {
namespace {

constexpr std::string_view help =
    R"(usage: thaum lab VOLUME [OPTIONS]      thaum lab --fluid --help: the brew alone

A volume to feel and carve: in a window, or with --headless as a script. VOLUME: a
.nrrd or .nhdr file, a .toml that describes a raw file, or one that is made: sphere
or gyroid (bodies), vortices or beltrami (flows).
  --count N, --seed N   of one that is made: samples (64), seed;  --moment N  of a file
  --place X,Y,Z[,SCALE[,DEGREES]]  where it lies;  --beside VOLUME[,X,Y,Z...]  another
                   there, not carved; repeats;  --registered  there by the files' origins
  --mode M[,S]     a haptic mode and its strength (N); a wrong name lists them; 1:M
                   reads the first --beside; repeats (isosurface; for a flow, follow)
  --transfer M,X:Y,...   strength of mode M by the property it reads, 32 points most
  --filter M,F[,A,B]   between data and mode M: magnitude, gradient, curl,
                   divergence, scale,A,B clamp,A,B smooth,SAMPLES; repeats: in order
  --feel KIND,N,...  the body as a whole: wall,DENSITY,FORCE[,FRICTION] opacity,FORCE
                   attract,FORCE shell,LOW,HIGH,FORCE gravity plane (MANUAL.md)
  --opacity X:Y,...  opacity of the picture, and of that feel, by the density
  --level X        value of the felt and drawn surface (between body and air)
  --look NAME      surface (default) or translucent;  --device NAME  (touch)
  --hand PATH      rest, press, circle, FILE.csv with time_s,x_m,y_m,z_m, or a trace
                   to play again (headless: press; the window: the mouse)
  --carve T,A,B    holds tool T (melt, construct, paint, ...) from second A to B
  --session FILE   settings that the window saved, in place of VOLUME
  --save FILE      .nrrd: the body at the end;  --trace FILE  CSV, a row a tick of 1 ms
  --shots DIR      pictures;  --every N  ticks from picture to picture (500)
  --size WxH       size of the pictures or of the window in px (1280x720)
  --headless       no window;  --seconds S  length (headless: 4);  --step MS  0.2 to 1
)";

constexpr Option volume_options[] = {
    {"--count", 1},        {"--seed", 1},           {"--moment", 1},     {"--mode", 1, true},
    {"--filter", 1, true}, {"--transfer", 1, true}, {"--feel", 1, true}, {"--opacity", 1},
    {"--beside", 1, true}, {"--place", 1},          {"--registered"},    {"--level", 1},
    {"--hand", 1},         {"--carve", 1, true},    {"--device", 1},     {"--look", 1},
    {"--session", 1},      output("--save"),        output("--trace"),   {"--shots", 1},
    {"--every", 1},        {"--size", 1},           {"--step", 1},       {"--headless"},
    {"--seconds", 1}};

// ---- the volume -------------------------------------------------------------------------------------------

/// Reads "X,Y,Z[,SCALE[,DEGREES]]".
Expected<LabPlace> read_place(std::string_view option, std::span<const std::string> parts) {
    std::array<double, 5> n{0, 0, 0, 1, 0};
    if (parts.size() < 3 || parts.size() > n.size())
        return fail(text(option, ": a place is X,Y,Z[,SCALE[,DEGREES]]"));
    constexpr std::array<Range, 5> ranges{
        {{-1, 1}, {-1, 1}, {-1, 1}, {min_place_scale, max_place_scale}, {-360, 360}}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto number = parse_number(parts[i], option, ranges.at(i).low, ranges.at(i).high);
        if (!number) return number.error();
        n.at(i) = *number;
    }
    return LabPlace{.origin = {n[0], n[1], n[2]}, .yaw = n[4] * pi / 180, .scale = n[3]};
}

/// Reads --place, and the volumes of --beside as "VOLUME[,PLACE]".
Expected<void> read_places(const Arguments& arguments, VolumeSession& session) {
    if (const auto words = arguments.value("--place")) {
        const auto place = read_place("--place", parts_of(*words));
        if (!place) return place.error();
        session.first.place = *place;
    }
    for (const auto& words : arguments.values("--beside")) {
        const auto parts = parts_of(words);
        SessionVolume one{.volume = parts[0], .count = session.first.count, .seed = session.first.seed};
        if (parts.size() > 1) {
            const auto place = read_place("--beside", std::span(parts).subspan(1));
            if (!place) return place.error();
            one.place = *place;
        }
        session.beside.push_back(std::move(one));
    }
    return {};
}

/// The session that the command line describes: from a file, or a new one with the volume's name.
Expected<VolumeSession> read_session(const Arguments& arguments) {
    VolumeSession session;
    if (const auto file = arguments.value("--session")) {
        if (!arguments.plain().empty()) return fail("lab takes a volume or --session, not both");
        auto saved = load_session(*file);
        if (!saved) return saved;
        session = std::move(*saved);
    } else {
        session.first.volume = arguments.plain()[0];
    }
    if (!is_made(session.first.volume) && (arguments.has("--count") || arguments.has("--seed")))
        return fail(
            text("--count and --seed are for volumes that are made, not for '", session.first.volume, "'"));
    const auto count = arguments.whole("--count", 8, 512, static_cast<std::uint64_t>(session.first.count));
    if (!count) return count.error();
    const auto seed =
        arguments.whole("--seed", 0, 1'000'000'000'000, static_cast<std::uint64_t>(session.first.seed));
    if (!seed) return seed.error();
    const auto moment =
        arguments.whole("--moment", 1, 1'000'000'000, static_cast<std::uint64_t>(session.first.moment));
    if (!moment) return moment.error();
    if (is_made(session.first.volume) && arguments.has("--moment"))
        return fail(text("--moment is for files with time, not for '", session.first.volume, "'"));
    session.first.moment = static_cast<std::int64_t>(*moment);
    session.first.count = static_cast<std::int64_t>(*count);
    session.first.seed = static_cast<std::int64_t>(*seed);
    if (arguments.has("--registered")) {
        if (!arguments.has("--beside")) return fail("--registered needs --beside");
        session.registered = true;
    }
    if (auto read = read_places(arguments, session); !read) return read.error();
    session.device = arguments.value("--device").value_or(session.device);
    return session;
}

/// Opens a file, or generates a volume.
Expected<field::Volume> open_volume(const SessionVolume& one, std::vector<std::string>& notes) {
    if (is_made(one.volume))
        return field::make_volume(one.volume, static_cast<int>(one.count),
                                  static_cast<std::uint64_t>(one.seed));
    auto volume = field::read_volume(one.volume, {.frame = static_cast<int>(one.moment - 1)});
    if (volume)
        for (const auto& note : volume->notes) notes.push_back(in_one_line(text(one.volume, ": ", note)));
    if (const auto faulty = volume ? field::not_finite(*volume) : 0; faulty > 0)
        notes.push_back(in_one_line(text(one.volume, ": ", faulty, " of ", volume->samples.size(),
                                         " samples are no finite numbers; nothing is felt beside them")));
    return volume;
}

// ---- modes ------------------------------------------------------------------------------------------------

/// Reads a filter "NAME,A,B", the part of a --filter value that follows the mode.
Expected<field::Filter> read_filter(const std::string& words, std::span<const std::string> parts) {
    const auto names = field::filter_names();
    const auto name = parts.empty() ? names.end() : std::ranges::find(names, parts[0]);
    if (name == names.end() || parts.size() > 3) {
        std::string all;
        for (const auto each : names) all += text(all.empty() ? "" : ", ", each);
        return fail(text("--filter '", words, "': must be MODE,FILTER[,A[,B]]; the filters are ", all));
    }
    field::Filter filter{.kind = static_cast<field::FilterKind>(name - names.begin())};
    const std::array<double*, 2> numbers{&filter.a, &filter.b};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const auto number = parse_number(parts[i], "--filter", -1e30, 1e30);
        if (!number) return number.error();
        *numbers[i - 1] = *number;
    }
    return filter;
}

/// Filters of the field that a haptic mode reads, in the order of the command line.
Expected<std::vector<field::Filter>> filters_of(const Arguments& arguments, const std::string& mode) {
    std::vector<field::Filter> filters;
    for (const auto& words : arguments.values("--filter")) {
        const auto parts = parts_of(words);
        if (parts[0] != mode) continue;
        const auto filter = read_filter(words, std::span(parts).subspan(1));
        if (!filter) return filter.error();
        filters.push_back(*filter);
    }
    return filters;
}

/// Splits a word such as "1:follow" into the number of a volume and the name of a haptic mode. Without a
/// number, the first volume is meant.
std::pair<std::size_t, std::string> volume_and_mode(const std::string& words) {
    const bool numbered = words.size() > 2 && words[1] == ':' && words[0] >= '0' && words[0] <= '9';
    if (!numbered) return {0, words};
    return {static_cast<std::size_t>(words[0] - '0'), words.substr(2)};
}

/// The chosen mode that a word such as "1:follow" names; modes.end() if there is none.
std::vector<LabMode>::iterator mode_named(std::vector<LabMode>& modes, const std::string& words) {
    const auto named = volume_and_mode(words);
    return std::ranges::find_if(
        modes, [&](const LabMode& mode) { return mode.volume == named.first && mode.name == named.second; });
}

Expected<LabMode> read_mode(const Arguments& arguments, const std::string& words, const VolumeLab& lab) {
    const auto parts = parts_of(words);
    const auto [volume, name] = volume_and_mode(parts[0]);
    if (parts.size() > 2) return fail(text("--mode '", words, "': must be MODE or MODE,STRENGTH"));
    auto filters = filters_of(arguments, parts[0]);
    if (!filters) return filters.error();
    auto mode = lab_mode(lab, name, std::move(*filters), volume);
    if (!mode) return mode;
    const auto level = arguments.number("--level", -1e30, 1e30);
    if (!level) return level.error();
    if (*level) mode->settings.level = **level;
    if (parts.size() == 1) return mode;
    const auto strength = parse_number(parts[1], "--mode", -1e6, 1e6);
    if (!strength) return strength.error();
    mode->settings.strength = field::constant(*strength);
    return mode;
}

/// Reads the points "X:Y" of a transfer function.
Expected<field::TransferFunction> read_points(std::string_view option, std::span<const std::string> parts,
                                              Range range_y) {
    std::vector<vec2> points;
    for (const auto& part : parts) {
        const auto numbers = parts_of(part, ':');
        if (numbers.size() != 2) return fail(text(option, ": '", part, "' must be X:Y"));
        const auto x = parse_number(numbers[0], option, -1e100, 1e100);
        if (!x) return x.error();
        const auto y = parse_number(numbers[1], option, range_y.low, range_y.high);
        if (!y) return y.error();
        points.emplace_back(*x, *y);
    }
    auto function = field::transfer_function(points);
    if (!function) return fail(text(option, ": ", function.error().message));
    return *function;
}

/// Reads "M,X:Y,..." and assigns that transfer function to mode M.
Expected<void> read_transfer(const std::string& words, std::vector<LabMode>& modes) {
    const auto parts = parts_of(words);
    const auto mode = mode_named(modes, parts[0]);
    if (mode == modes.end()) return fail(text("--transfer '", words, "': there is no --mode ", parts[0]));
    auto function = read_points("--transfer", std::span(parts).subspan(1), {-1e6, 1e6});
    if (!function) return function.error();
    mode->settings.strength = *function;
    return {};
}

/// Reads "KIND,N,...", a part of the force law by which the body is felt.
Expected<FeelPart> read_feel(const std::string& words) {
    const auto parts = parts_of(words);
    std::vector<double> numbers;
    for (const auto& part : std::span(parts).subspan(1)) {
        const auto number = parse_number(part, "--feel", -1e6, 1e6);
        if (!number) return number.error();
        numbers.push_back(*number);
    }
    auto part = feel_part(parts[0], numbers);
    if (!part) return fail(text("--feel ", part.error().message));
    return *part;
}

/// Reads the feel of the body as a whole, and the opacity that the feel uses.
Expected<void> read_body_feel(const Arguments& arguments, VolumeLabPlan& plan, VolumeLabSettings& settings) {
    if (const auto words = arguments.value("--opacity")) {
        auto opacity = read_points("--opacity", parts_of(*words), {0, 1});
        if (!opacity) return opacity.error();
        plan.view.opacity = *opacity;
    }
    settings.opacity = plan.view.opacity;
    for (const auto& words : arguments.values("--feel")) {
        const auto part = read_feel(words);
        if (!part) return part.error();
        settings.feel.push_back(*part);
    }
    return {};
}

Expected<void> read_modes(const Arguments& arguments, VolumeLabPlan& plan) {
    const auto level = arguments.number("--level", -1e30, 1e30);
    if (!level) return level.error();
    if (*level) plan.view.level = **level;
    VolumeLabSettings settings = plan.lab.settings;
    for (const auto& words : arguments.values("--mode")) {
        auto mode = read_mode(arguments, words, plan.lab);
        if (!mode) return mode.error();
        if (const auto word = parts_of(words)[0]; mode_named(settings.modes, word) != settings.modes.end())
            return fail(text("--mode '", word, "' is given twice"));
        settings.modes.push_back(std::move(*mode));
    }
    for (const auto& words : arguments.values("--filter")) {
        if (mode_named(settings.modes, parts_of(words)[0]) == settings.modes.end())
            return fail(text("--filter '", words, "': it begins with the mode, and there is no such --mode"));
    }
    for (const auto& words : arguments.values("--transfer"))
        if (auto read = read_transfer(words, settings.modes); !read) return read;
    if (auto read = read_body_feel(arguments, plan, settings); !read) return read;
    return change_volume_lab(plan.lab, settings);
}

// ---- the script -------------------------------------------------------------------------------------------

Expected<PlannedCarve> read_carve(const std::string& words, const VolumeLab& lab) {
    const auto parts = parts_of(words);
    if (parts.size() != 3) return fail(text("--carve '", words, "': must be TOOL,FROM,TO"));
    if (!lab.carvable()) return fail("--carve: a flow cannot be carved");
    const auto& tools = lab.data.tools;
    const auto tool = std::ranges::find(tools, parts[0], &field::Tool::name);
    if (tool == tools.end()) {
        std::string names;
        for (const auto& each : tools) names += (names.empty() ? "" : ", ") + each.name;
        return fail(text("--carve '", words, "': there are ", names));
    }
    const auto from = parse_number(parts[1], "--carve", 0, 1e6);
    if (!from) return from.error();
    const auto to = parse_number(parts[2], "--carve", *from, 1e6);
    if (!to) return to.error();
    return PlannedCarve{static_cast<std::size_t>(tool - tools.begin()), *from, *to};
}

Expected<void> read_script(const Arguments& arguments, bool headless, VolumeLabPlan& plan) {
    auto path = hand_path(arguments.value("--hand").value_or(headless ? "press" : "rest"));
    if (!path) return fail(text("--hand ", path.error().message));
    plan.path = std::move(*path);
    plan.by_mouse = !headless && !arguments.has("--hand");
    for (const auto& words : arguments.values("--carve")) {
        const auto carve = read_carve(words, plan.lab);
        if (!carve) return carve.error();
        plan.carves.push_back(*carve);
    }
    return {};
}

// ---- the whole plan ---------------------------------------------------------------------------------------

Expected<void> read_outputs(const Arguments& arguments, VolumeLabPlan& plan) {
    auto outputs = read_lab_outputs(arguments, 500);
    if (!outputs) return outputs.error();
    plan.out = std::move(*outputs);
    if (plan.out.save && plan.out.save->extension() != ".nrrd")
        return fail("--save: the file must end in .nrrd");
    const auto look = arguments.value("--look");
    if (look && *look != "surface" && *look != "translucent")
        return fail(text("--look '", *look, "': must be surface or translucent"));
    if (look) plan.view.look = *look == "surface" ? render::ScanLook::surface : render::ScanLook::translucent;
    return check_outputs(plan);
}

/// Chooses a default haptic mode if the command line names none: the surface of a body, the direction of a
/// flow.
Expected<void> put_on_usual_mode(const Arguments& arguments, VolumeLab& lab) {
    if (arguments.has("--session") || arguments.has("--mode") || arguments.has("--feel")) return {};
    auto mode = read_mode(arguments, lab.carvable() ? "isosurface" : "follow", lab);
    if (!mode) return mode.error();
    auto settings = lab.settings;
    settings.modes.push_back(std::move(*mode));
    return change_volume_lab(lab, settings);
}

/// Notes the haptic modes that read smoothed samples of a very large volume, because their first step is
/// slow.
void note_slow_filters(VolumeLabPlan& plan) {
    constexpr std::size_t many = std::size_t{1} << 24U;
    constexpr double samples_per_second = 4e6;
    for (const auto& mode : plan.lab.settings.modes) {
        std::size_t samples = 1;
        for (const int n : volume_of(plan.lab, mode.volume).source.count)
            samples *= static_cast<std::size_t>(n);
        if (samples < many ||
            !std::ranges::count(mode.filters, field::FilterKind::smooth, &field::Filter::kind))
            continue;
        const double seconds = static_cast<double>(samples) / samples_per_second;
        plan.notes.push_back(text("mode '", mode.name, "': smoothing ", samples, " samples takes about ",
                                  fixed(seconds, 0), " s, once and after each edit"));
    }
}

/// Reads the duration of a servo step (ms). A tick must consist of a whole number of steps.
Expected<void> read_servo_step(const Arguments& arguments, VolumeLab& lab) {
    const auto ms = arguments.number("--step", 1.0 / max_steps_per_tick, 1);
    if (!ms) return ms.error();
    const double steps = 1 / ms->value_or(1);
    if (std::abs(steps - std::round(steps)) > 1e-3 * steps)
        return fail("--step: a tick of 1 ms must have a whole number of steps: 1, 0.5, 0.25, 0.2");
    set_servo_rate(lab, static_cast<int>(std::lround(steps)));
    return {};
}

Expected<VolumeLabPlan> read_volume_plan(const Arguments& arguments) {
    const bool headless = arguments.has("--headless");
    const auto session = read_session(arguments);
    if (!session) return session.error();
    auto opened = plan_of(*session);
    if (!opened) return opened;
    VolumeLabPlan plan = std::move(*opened);
    protect_companions(plan);
    plan.session_file = arguments.path("--session");
    if (auto read = read_modes(arguments, plan); !read) return read.error();
    // The camera comes near a second time, because the options may have changed the level of the surface.
    if (!session->view) come_near(plan.lab, plan.view);
    if (auto put = put_on_usual_mode(arguments, plan.lab); !put) return put.error();
    note_slow_filters(plan);
    if (auto read = read_script(arguments, headless, plan); !read) return read.error();
    if (auto read = read_outputs(arguments, plan); !read) return read.error();
    if (auto read = read_servo_step(arguments, plan.lab); !read) return read.error();
    rest_hand(plan.lab, planned_input(plan).target);
    const auto seconds = arguments.number("--seconds", tick_seconds, 36'000);
    if (!seconds) return seconds.error();
    plan.seconds = headless ? seconds->value_or(4) : *seconds;
    return plan;
}

// ---- without a window -------------------------------------------------------------------------------------

void tell_end(const VolumeLab& lab, std::size_t changed, double max_n, double took_s) {
    // Computed before any output, because the hash needs memory for a second body and may fail.
    const auto state = hex(lab_hash(lab));
    const auto& n = lab.carvable() ? lab.body.count : lab.source.count;
    std::printf("lab: %s s with %d x %d x %d samples in %s s; force up to %s N; %zu voxels changed\n",
                fixed(lab.seconds(), 3).c_str(), n[0], n[1], n[2], fixed(took_s, 2).c_str(),
                fixed(max_n, 3).c_str(), changed);
    std::printf("state %s\n", state.c_str());
}

int run_headless(VolumeLabPlan plan) {
    auto trace = LabTrace::open(plan.out.trace, volume_trace_header());
    if (!trace) return refuse(trace.error());
    auto shots = VolumeShots::open(plan);
    if (!shots) return refuse(shots.error());
    double max_n = 0;
    std::size_t changed = 0;
    const auto start = monotonic_ns();
    const auto steps = ticks(*plan.seconds);
    const EndWatch watch;
    for (Tick i = 0; i < steps && !EndWatch::asked(); ++i) {
        const auto input = planned_input(plan);
        const auto figures = step_volume_lab(plan.lab, input);
        max_n = std::max(max_n, glm::length(figures.force));
        changed += figures.edit.voxels;
        trace->add([&](std::string& rows) { append_volume_row(plan.lab, input, figures, rows); });
        if (auto put = shots->follow(plan.lab, plan.view, figures); !put) return refuse(put.error());
    }
    const double took = static_cast<double>(monotonic_ns() - start) * 1e-9;
    if (auto closed = trace->close(); !closed) return refuse(closed.error());
    if (plan.out.save) {
        if (auto saved = save_volume(plan.lab, *plan.out.save); !saved) return refuse(saved.error());
    }
    tell_end(plan.lab, changed, max_n, took);
    tell_end_by_signal();
    return done;
}

}  // namespace

Expected<VolumeLabPlan> plan_of(const VolumeSession& session) {
    auto data = load_volume_lab_data(find_assets(), session.device);
    if (!data) return data.error();
    std::vector<std::string> notes;
    auto volume = open_volume(session.first, notes);
    if (!volume) return volume.error();
    auto lab = make_volume_lab(std::move(*volume), std::move(*data));
    if (!lab) return fail(text(session.first.volume, ": ", lab.error().message));
    if (!is_made(session.first.volume)) {
        if (auto taken = take_saved_properties(*lab, session.first.volume); !taken) return taken.error();
    }
    for (const auto& one : session.beside) {
        auto other = open_volume(one, notes);
        if (!other) return other.error();
        if (auto added = add_volume_beside(*lab, std::move(*other), session.registered); !added)
            return fail(text(one.volume, ": ", added.error().message));
    }
    VolumeLabPlan plan{.first = session.first,
                       .beside = session.beside,
                       .registered = session.registered,
                       .device = session.device,
                       .lab = std::move(*lab),
                       .notes = std::move(notes)};
    plan.view = usual_view(plan.lab);
    if (session.opacity.count > 0) {
        plan.view.look = session.translucent ? render::ScanLook::translucent : render::ScanLook::surface;
        plan.view.level = session.level;
        plan.view.opacity = session.opacity;
    }
    if (session.view)
        plan.view.eye = {session.view->yaw, session.view->pitch, session.view->away, session.view->aim};
    VolumeLabSettings settings{session.modes, session.feel, plan.view.opacity, {session.first.place}};
    for (const auto& one : session.beside) settings.places.push_back(one.place);
    if (auto set = change_volume_lab(plan.lab, settings); !set) return set.error();
    return plan;
}

VolumeSession session_of(const VolumeLabPlan& plan) {
    const auto& eye = plan.view.eye;
    VolumeSession session{.first = plan.first,
                          .beside = plan.beside,
                          .registered = plan.registered,
                          .device = plan.device,
                          .translucent = plan.view.look == render::ScanLook::translucent,
                          .level = plan.view.level,
                          .opacity = plan.view.opacity,
                          .view = SessionView{eye.yaw, eye.pitch, eye.away, eye.aim},
                          .feel = plan.lab.settings.feel,
                          .modes = plan.lab.settings.modes};
    const auto& places = plan.lab.settings.places;
    if (!places.empty()) session.first.place = places[0];
    for (std::size_t i = 0; i + 1 < places.size() && i < session.beside.size(); ++i)
        session.beside[i].place = places[i + 1];
    return session;
}

VolumeLabInput planned_input(const VolumeLabPlan& plan) {
    VolumeLabInput input;
    const double now = plan.lab.seconds();
    input.target = wanted_place(plan.path, plan.lab.data.device.workspace, now);
    const auto use = use_at(plan.path, now);
    input.history = use.history;
    if (use.tool > 0) {
        input.carve = true;
        input.tool = use.tool - 1;
    }
    for (const auto& carve : plan.carves) {
        if (now < carve.from || now >= carve.to) continue;
        input.carve = true;
        input.tool = carve.tool;
    }
    return input;
}

std::string_view volume_lab_help() { return help; }

int run_volume_lab(const std::vector<std::string>& words) {
    const auto arguments = Arguments::parse(words, volume_options);
    if (!arguments) return refuse(arguments.error());
    if (arguments->plain().size() != 1 && !arguments->has("--session"))
        return refuse({"lab takes one volume, or --fluid; `thaum lab --help` says more"});
    if (!arguments->has("--headless") && !render::display_there())
        return refuse({"lab needs a display; without one: thaum lab VOLUME --headless"});
    auto plan = read_volume_plan(*arguments);
    if (!plan) return refuse(plan.error());
    for (const auto& note : plan->notes) print_line(note);
    std::fflush(stdout);
    return arguments->has("--headless") ? run_headless(std::move(*plan))
                                        : run_volume_window(std::move(*plan));
}

}  // namespace thaum::game::inline lab
