// The fluid lab in a window. One thread handles input, computes the steps of 16 ms that are due by the clock,
// and draws a picture. If a step takes longer than 16 ms to compute, the brew flows more slowly and the
// screen shows the speed. The lab has no real-time deadlines.
#include <algorithm>
#include <cmath>

#include "core/clock.h"
#include "core/file.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/command_line/command.h"
#include "game/data/match_data.h"
#include "game/lab/lab_file.h"
#include "game/lab/lab_trace.h"
#include "game/lab/window/lab.h"
#include "game/lab/window/lab_picture.h"
#include "game/lab/window/view_controls.h"
#include "game/live/end_watch.h"
#include "game/settings/settings.h"
#include "render/pace.h"
#include "render/with_renderer.h"

namespace thaum::game::inline lab {
namespace {

// Maximum number of steps per picture. They cover a tenth of a second, the longest interval between pictures
// that the settings allow. Time beyond that is dropped.
constexpr int steps_of_a_frame = 7;
constexpr double note_s = 4, rate_s = 0.5;
// Volume poured in a step while the pour key is held, and for each press of that key (m^3)
constexpr double pour_m3 = 2e-3;
constexpr double above = 0.15;  // height of a lifted ladle above the level surface (m)
constexpr double dip_m = 0.04;  // vertical speed of the ladle (m per step)
// How the ladle follows the mouse: share of the remaining distance in a step, and largest displacement in a
// step (m)
constexpr double follow = 0.5, max_way = 0.12;
constexpr double depth_step = 0.08;  // change of the ladle's depth by one step of the wheel (m)
// Largest distance of the ladle from the middle, as a share of the basin's width.
constexpr double within_walls = 0.93;
// Elevation of the camera below which the mouse moves the ladle up and down (rad)
constexpr double flat_view = 0.2;

struct LabSession {
    LabPlan plan;
    LabTrace trace;
    LabPage page{};
    LabFigures figures{};
    std::filesystem::path file{};  ///< file that keys save to and load from

    std::optional<fvec2> cursor{};  ///< position of the mouse (px); std::nullopt: outside of the window
    bool stirring = false, turning = false, pouring = false;
    int pours_due = 0;  ///< presses of the pour key since the last step
    /// true: the brew must start anew (wants_reset); the lab must end (leaves); the bowl has changed, so its
    /// picture must be built again (bowl_changed)
    bool wants_reset = false, leaves = false, bowl_changed = false;
    double height{};  ///< height of a stirring ladle above the level surface (m), <= 0
    /// Position of the ladle, also while it is out of the brew (m, basin frame)
    std::optional<vec3> ladle{};
    std::int64_t note_until_ns = 0;
};

void note(LabSession& session, std::string_view words) {
    session.page.note = in_one_line(words);
    session.note_until_ns = monotonic_ns() + std::llround(note_s * 1e9);
}

// ---- the ladle --------------------------------------------------------------------------------------------

/// The position inside the walls that is nearest to `place`.
vec3 in_basin(const LabState& lab, vec3 place) {
    place.y = std::clamp(place.y, -0.95 * lab.basin.depth, above);
    const double width = within_walls * width_at(lab.basin, std::min(place.y, 0.0));
    const double far = std::sqrt(place.x * place.x + place.z * place.z);
    if (far > width) place *= vec3(width / far, 1, width / far);
    return place;
}

/// Position at which the mouse points in a plane: the horizontal one at the ladle's height or, in a nearly
/// horizontal view, the vertical one through the middle. std::nullopt if the mouse points at no place of that
/// plane.
std::optional<vec3> pointed_at(const LabSession& session, render::Size size) {
    if (!session.cursor || size.height <= 0) return std::nullopt;
    const auto camera = camera_of(session.page.eye);
    const double tall = std::tan(double{camera.fov_y} / 2);
    const double half = 0.5 * size.height;
    const vec3 ray =
        quat(camera.orientation) * vec3(tall * (double{session.cursor->x} - 0.5 * size.width) / half,
                                        tall * (half - double{session.cursor->y}) / half, -1);
    const vec3 eye(camera.position);
    const bool flat = session.page.eye.pitch < flat_view;
    const vec3 normal = flat ? quat(camera.orientation) * vec3(0, 0, 1) : vec3(0, 1, 0);
    const double slope = glm::dot(ray, normal);
    const double way = glm::dot(vec3(0, session.height, 0) - eye, normal) / slope;
    if (!(std::abs(slope) > 1e-6) || !(way > 0)) return std::nullopt;
    return in_basin(session.plan.lab, eye + way * ray);
}

/// Moves the ladle by one step. While stirring, the ladle goes down to the position of the mouse and moves
/// with it. When stirring ends, the ladle goes up again.
void move_ladle(LabSession& session, render::Size size) {
    const auto target = session.stirring ? pointed_at(session, size) : std::nullopt;
    if (target && !session.ladle) session.ladle = vec3(target->x, above, target->z);
    if (!session.ladle) return;
    vec3& at = *session.ladle;
    if (target) {
        const vec3 way = limited(follow * vec3(target->x - at.x, 0, target->z - at.z), max_way);
        const double down = std::clamp(target->y - at.y, -dip_m, dip_m);
        at = in_basin(session.plan.lab, at + way + vec3(0, down, 0));
    } else if (!session.stirring) {
        at.y += dip_m;
        if (at.y > above) session.ladle.reset();
    }
}

// ---- keys and mouse ---------------------------------------------------------------------------------------

void save_now(LabSession& session) {
    if (session.file.empty())
        return note(session, "there is no home folder to save to; start with --save FILE");
    if (session.file.has_parent_path()) {
        if (auto made = make_folder(session.file.parent_path()); !made)
            return note(session, made.error().message);
    }
    const auto saved = save_lab(session.plan.lab, session.file);
    note(session, saved ? text("saved: ", session.file.string()) : saved.error().message);
}

void load_now(LabSession& session) {
    auto lab = load_lab(session.file, session.plan.lab.rules);
    if (!lab) return note(session, lab.error().message);
    session.bowl_changed = lab->settings.room != session.plan.lab.settings.room;
    session.plan.lab = std::move(*lab);
    session.pours_due = 0;
    session.page.hands.settings = session.plan.lab.settings;
    session.figures = figures_of(session.plan.lab);
    note(session, text("loaded: ", session.file.string()));
}

void press(LabSession& session, std::string_view key) {
    if (turn_control(key, session.page.hands, session.plan.lab.rules)) return;
    if (key == "Esc") session.leaves = true;
    if (key == "Space") ++session.pours_due;
    if (key == "Backspace") session.wants_reset = true;
    if (key == "F5") save_now(session);
    if (key == "F9") load_now(session);
    if (key == "PageUp") session.height = std::min(0.0, session.height + depth_step);
    if (key == "PageDown")
        session.height = std::max(-0.9 * session.plan.lab.basin.depth, session.height - depth_step);
}

void cursor_moved(LabSession& session, fvec2 to) {
    if (session.turning && session.cursor) {
        const fvec2 way = to - *session.cursor;
        session.page.eye =
            turned(session.page.eye, -turn_per_px * double{way.x}, turn_per_px * double{way.y}, 1);
    }
    session.cursor = to;
}

render::WindowEvents lab_events(LabSession& session) {
    render::WindowEvents events;
    events.key = [&](int key, int, bool pressed) {
        const auto name = render::key_name(key);
        if (name == "Space") session.pouring = pressed;
        if (pressed) press(session, name);
    };
    events.mouse_button = [&](int button, bool pressed) {
        if (button == 0) session.stirring = pressed;
        if (button == 1) session.turning = pressed;
    };
    events.cursor = [&](double x, double y) { cursor_moved(session, fvec2(vec2(x, y))); };
    events.wheel = [&](double steps) {
        session.page.eye = turned(session.page.eye, 0, 0, std::pow(nearer_per_step, steps));
    };
    events.focus = [&](bool focused) {
        if (!focused) session.stirring = session.turning = session.pouring = false;
    };
    return events;
}

// ---- steps ------------------------------------------------------------------------------------------------

bool same_settings(const LabSettings& a, const LabSettings& b) {
    const auto same = [](const Ingredient& i, const Ingredient& j) {
        return i.name == j.name && i.substance.viscosity == j.substance.viscosity &&
               i.substance.weight == j.substance.weight && i.substance.diffusion == j.substance.diffusion;
    };
    return a.solver == b.solver && a.cells == b.cells && a.order == b.order && a.bowl == b.bowl &&
           a.no_slip == b.no_slip && a.viscosity == b.viscosity && a.gravity == b.gravity &&
           std::ranges::equal(a.substances, b.substances, same);
}

/// Input of the next step: from the user if there is any, else from the script.
LabInput input_now(LabSession& session, render::Size size) {
    auto& lab = session.plan.lab;
    LabInput input = scripted_input(session.plan.script, lab);
    move_ladle(session, size);
    if (session.ladle) input.ladle = session.ladle;
    const int pours = std::max(std::exchange(session.pours_due, 0), session.pouring ? 1 : 0);
    for (int i = 0; i < pours && session.page.hands.chosen < lab.settings.substances.size(); ++i)
        input.pours.push_back({session.page.hands.chosen, pour_m3, place_to_pour(lab, input.ladle)});
    if (!same_settings(session.page.hands.settings, lab.settings)) input.change = session.page.hands.settings;
    input.reset = std::exchange(session.wants_reset, false);
    return input;
}

void step_session(LabSession& session, render::Size size, Jobs& jobs) {
    const auto input = input_now(session, size);
    session.figures = step_lab(session.plan.lab, input, jobs);
    if (!session.figures.refused.empty()) {
        note(session, session.figures.refused);
        session.page.hands.settings = session.plan.lab.settings;
    }
    session.trace.add([&](std::string& rows) {
        append_lab_row(session.plan.lab, session.figures, session.plan.times, rows);
    });
}

/// Clock of the lab: tells how many steps are due now and how many are computed per second.
struct LabClock {
    std::int64_t last_ns = monotonic_ns();
    double owed_s{}, counted_s{};
    int counted{};

    int due(double& steps_per_s) {
        const auto now = monotonic_ns();
        const double passed = static_cast<double>(now - last_ns) * 1e-9;
        last_ns = now;
        owed_s += passed;
        counted_s += passed;
        if (counted_s > rate_s) {
            steps_per_s = counted / counted_s;
            counted = 0;
            counted_s = 0;
        }
        const int steps = std::min(steps_of_a_frame, static_cast<int>(owed_s / lab_dt));
        owed_s = steps == steps_of_a_frame ? 0 : owed_s - steps * lab_dt;
        counted += steps;
        return steps;
    }
};

bool over(const LabSession& session, const render::Window& window, std::int64_t end) {
    return session.leaves || window.should_close() || EndWatch::asked() || session.plan.lab.steps >= end;
}

Expected<void> run(LabSession& session, double frames_per_second, render::Window& window,
                   render::Renderer& renderer) {
    const auto events = lab_events(session);
    std::optional<LabPicture> picture(std::in_place, renderer, session.plan.lab);
    Jobs jobs(session.plan.threads - 1);
    render::Pacer pacer(frames_per_second);
    LabClock clock;
    const auto end = session.plan.seconds
                         ? session.plan.lab.steps + std::llround(*session.plan.seconds / lab_dt)
                         : std::numeric_limits<std::int64_t>::max();
    while (!over(session, window, end)) {
        window.poll(events);
        const auto size = window.size();
        const auto before = session.plan.lab.steps;
        const int due = clock.due(session.page.steps_per_s);
        for (int i = 0; i < due && !session.page.hands.paused && session.plan.lab.steps < end; ++i)
            step_session(session, size, jobs);
        if (session.note_until_ns < monotonic_ns()) session.page.note.clear();
        if (std::exchange(session.bowl_changed, false)) picture.emplace(renderer, session.plan.lab);
        if (!window.minimised() && size.width > 0 && size.height > 0) {
            renderer.draw(picture->frame(session.plan.lab, session.figures, session.page, size));
            if (session.plan.out.shots &&
                before / session.plan.out.every != session.plan.lab.steps / session.plan.out.every) {
                if (auto put = write_lab_shot(*session.plan.out.shots, session.plan.lab.steps,
                                              renderer.read_pixels());
                    !put)
                    return put;
            }
            window.present();
        }
        pacer.wait();
    }
    return {};
}

Expected<void> end(LabSession& session) {
    if (auto closed = session.trace.close(); !closed) return closed;
    return session.plan.out.save ? save_lab(session.plan.lab, *session.plan.out.save) : Expected<void>();
}

}  // namespace

int run_lab_window(LabPlan plan) {
    const auto assets = find_assets();
    const auto settings = settings_to_play_with(settings_file(), assets).settings;
    auto window = render::Window::create(
        {.title = "Thaum: the brew", .size = plan.out.size, .fullscreen = settings.fullscreen});
    if (!window) return refuse(window.error());
    const EndWatch watch;
    auto trace = LabTrace::open(plan.out.trace, lab_trace_header(plan.times));
    if (!trace) return refuse(trace.error());
    if (auto made = make_lab_folder(plan.out, plan.lab.steps + plan.out.every); !made)
        return refuse(made.error());
    LabSession session{.plan = std::move(plan), .trace = std::move(*trace)};
    session.file = session.plan.out.save.value_or(
        matches_folder().empty() ? std::filesystem::path() : matches_folder().parent_path() / "lab.brew");
    session.page.hands.settings = session.plan.lab.settings;
    session.page.text_scale = settings.text_scale;
    session.height = -0.35 * session.plan.lab.basin.depth;
    const auto went = render::with_renderer(*window, assets, [&](render::Renderer& renderer) {
        return run(session, settings.frames_per_second, *window, renderer);
    });
    if (!went) return refuse(went.error());
    if (auto ended = end(session); !ended) return refuse(ended.error());
    tell_end_by_signal();
    return done;
}

}  // namespace thaum::game::inline lab
